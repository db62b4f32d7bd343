// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Generated shapes: spheres, cylinders, cones and tori are swept profiles.
#include "mortise/mesh/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/base/trig.h"
#include "mortise/exact/predicates.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/triangulate_polygon.h"

namespace mortise {
namespace {

void require(bool condition, const std::string& message) {
  if (!condition) throw Error(ErrorCode::InvalidArgument, "shapes", message);
}

bool is_finite(double x) { return std::fabs(x) <= std::numeric_limits<double>::max(); }

void require_size(double size, const char* name) { require(size > 0 && is_finite(size), std::string(name) + " must be a positive number"); }

void require_count(std::uint64_t count, std::uint64_t least, const char* name) {
  require(count >= least, std::string(name) + " must be at least " + std::to_string(least));
}

void require_room(std::uint64_t first, std::uint64_t second) {
  constexpr std::uint64_t most = std::uint64_t{1} << 31;
  require(first < most && second < most && first * second < most / 2, "the shape has too many triangles");
}

void add_triangle(SurfaceMesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
  mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
}

/// A point on the unit circle; exact at quarters, symmetric.
Vec2d circle_point(std::uint64_t i, std::uint64_t count) {
  const double degrees = 360.0 * static_cast<double>(i) / static_cast<double>(count);
  return {trig::cos_deg(degrees), trig::sin_deg(degrees)};
}

/// The vertices of one corner of a profile: one on the axis, else a ring.
struct Ring {
  std::size_t first = 0;
  std::size_t count = 1;

  [[nodiscard]] std::size_t at(std::size_t i) const { return first + i % count; }
  [[nodiscard]] bool is_on_axis() const { return count == 1; }
};

Ring add_ring(SurfaceMesh& mesh, const Vec2d& corner, std::uint32_t around) {
  const Ring ring{mesh.points.size(), corner[0] == 0 ? 1 : std::size_t{around}};
  for (std::size_t i = 0; i < ring.count; ++i) {
    const Vec2d direction = circle_point(i, around);
    mesh.points.push_back(ring.is_on_axis() ? Vec3d{0, 0, corner[1]}
                                            : Vec3d{corner[0] * direction[0], corner[0] * direction[1], corner[1]});
  }
  return ring;
}

/// The band between two rings, outside to the right of the way from `from` to `to`.
void add_band(SurfaceMesh& mesh, const Ring& from, const Ring& to, std::size_t around) {
  for (std::size_t i = 0; i < around; ++i) {
    if (!from.is_on_axis()) add_triangle(mesh, from.at(i), from.at(i + 1), to.at(i));
    if (!to.is_on_axis()) add_triangle(mesh, to.at(i), from.at(i + 1), to.at(i + 1));
  }
}

/// Sweeps a closed profile that turns counterclockwise in (radius, z).
SurfaceMesh sweep(std::span<const Vec2d> profile, std::uint32_t around) {
  SurfaceMesh mesh;
  const std::size_t n = profile.size();
  const auto is_on_axis = [&](std::size_t i) { return profile[i % n][0] == 0; };
  std::vector<Ring> rings(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_inside_axis = is_on_axis(i + n - 1) && is_on_axis(i) && is_on_axis(i + 1);
    if (!is_inside_axis) rings[i] = add_ring(mesh, profile[i], around);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_on_axis(i) || !is_on_axis(i + 1)) add_band(mesh, rings[i], rings[(i + 1) % n], around);
  }
  return mesh;
}

/// The outline in the plane z = 0, counterclockwise.
std::vector<Vec3d> counterclockwise_polygon(std::span<const Vec2d> outline) {
  std::vector<Vec3d> corners;
  for (const Vec2d& p : outline) {
    require(is_finite(p[0]) && is_finite(p[1]), "a coordinate of the outline is not a finite number");
    corners.push_back({p[0], p[1], 0});
  }
  require_count(corners.size(), 3, "the number of corners");
  require(is_simple_polygon(corners, Axis::Z), "the outline meets itself");
  const auto first =
      std::min_element(corners.begin(), corners.end(), [](const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto i = static_cast<std::size_t>(first - corners.begin());
  const std::size_t n = corners.size();
  const bool is_clockwise = orient2d(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n], Axis::Z) == Sign::Negative;
  if (is_clockwise) std::reverse(corners.begin(), corners.end());
  return corners;
}

SurfaceMesh make_icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  SurfaceMesh mesh;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-golden, golden}) mesh.points.push_back({x, y, 0});
  }
  for (const double y : {-1.0, 1.0}) {
    for (const double z : {-golden, golden}) mesh.points.push_back({0, y, z});
  }
  for (const double z : {-1.0, 1.0}) {
    for (const double x : {-golden, golden}) mesh.points.push_back({x, 0, z});
  }
  // 0..3: (-x-y) (-x+y) (+x-y) (+x+y); 4..7: (-y-z) (-y+z) (+y-z) (+y+z); 8..11: (-z-x) (-z+x) (+z-x) (+z+x)
  constexpr std::array<std::array<std::size_t, 3>, 20> faces{
      {{3, 1, 7},  {3, 6, 1},  {2, 5, 0},  {2, 0, 4},  {7, 5, 11}, {7, 10, 5}, {6, 9, 4},  {6, 4, 8},  {11, 9, 3}, {11, 2, 9},
       {10, 1, 8}, {10, 8, 0}, {3, 7, 11}, {1, 10, 7}, {3, 9, 6},  {1, 6, 8},  {2, 11, 5}, {0, 5, 10}, {2, 4, 9},  {0, 8, 4}}};
  for (const auto& [a, b, c] : faces) add_triangle(mesh, a, b, c);
  return mesh;
}

/*        c                 c
         / \               / \
        /   \      ->    ca---bc
       /     \           / \ / \
      a-------b         a---ab--b       */
SurfaceMesh cut_in_four(const SurfaceMesh& mesh) {
  const MeshTopology topology = build_topology(mesh);
  SurfaceMesh finer;
  finer.points = mesh.points;
  for (const auto& [a, b] : topology.edges) finer.points.push_back(0.5 * (mesh.points[a.index()] + mesh.points[b.index()]));
  finer.triangles.reserve(4 * mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto middle = [&](std::size_t k) { return mesh.points.size() + topology.edge_of[3 * f + k].index(); };
    const Triangle& t = mesh.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) add_triangle(finer, t[k].index(), middle(k), middle((k + 2) % 3));
    add_triangle(finer, middle(0), middle(1), middle(2));
  }
  return finer;
}

void put_on_sphere(SurfaceMesh& mesh, double radius) {
  for (Vec3d& p : mesh.points) {
    const double length = std::sqrt(dot(p, p));
    p = {p.x / length * radius, p.y / length * radius, p.z / length * radius};
  }
}

}  // namespace

SurfaceMesh make_box(const Vec3d& lo, const Vec3d& hi) {
  const bool is_ordered = lo.x < hi.x && lo.y < hi.y && lo.z < hi.z;
  const bool fits = is_finite(lo.x) && is_finite(lo.y) && is_finite(lo.z) && is_finite(hi.x) && is_finite(hi.y) && is_finite(hi.z);
  require(is_ordered && fits, "the box must have its low corner below its high corner");
  SurfaceMesh mesh;
  for (const double z : {lo.z, hi.z}) {
    for (const double y : {lo.y, hi.y}) {
      for (const double x : {lo.x, hi.x}) mesh.points.push_back({x, y, z});
    }
  }
  constexpr std::array<std::array<std::size_t, 4>, 6> sides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : sides) {
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, c, d);
  }
  return mesh;
}

SurfaceMesh make_sphere(double radius, std::uint32_t around, std::uint32_t rings) {
  require_size(radius, "the radius");
  require_count(around, 3, "the number of meridians");
  require_count(rings, 2, "the number of rings");
  require_room(around, rings);
  std::vector<Vec2d> profile;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const double degrees = 180.0 * i / rings - 90;
    profile.push_back({radius * trig::cos_deg(degrees), radius * trig::sin_deg(degrees)});
  }
  return sweep(profile, around);
}

SurfaceMesh make_icosphere(double radius, std::uint32_t levels) {
  require_size(radius, "the radius");
  require(levels <= 12, "the number of levels must be at most 12");
  SurfaceMesh mesh = make_icosahedron();
  put_on_sphere(mesh, 1);
  for (std::uint32_t level = 0; level < levels; ++level) {
    mesh = cut_in_four(mesh);
    put_on_sphere(mesh, 1);
  }
  for (Vec3d& p : mesh.points) p = radius * p;
  return mesh;
}

SurfaceMesh make_cylinder(double radius, double height, std::uint32_t around) {
  require_size(radius, "the radius");
  require_size(height, "the height");
  require_count(around, 3, "the number of sides");
  require_room(around, 2);
  return sweep(std::array<Vec2d, 4>{{{0, 0}, {radius, 0}, {radius, height}, {0, height}}}, around);
}

SurfaceMesh make_cone(double radius, double height, std::uint32_t around) {
  require_size(radius, "the radius");
  require_size(height, "the height");
  require_count(around, 3, "the number of sides");
  require_room(around, 2);
  return sweep(std::array<Vec2d, 3>{{{0, 0}, {radius, 0}, {0, height}}}, around);
}

SurfaceMesh make_torus(double major_radius, double minor_radius, std::uint32_t around, std::uint32_t across) {
  require_size(major_radius, "the major radius");
  require_size(minor_radius, "the minor radius");
  require_size(major_radius + minor_radius, "the outer radius");
  require(minor_radius < major_radius, "the minor radius must be smaller than the major radius");
  require_count(around, 3, "the number of sections");
  require_count(across, 3, "the number of points of a section");
  require_room(around, across);
  std::vector<Vec2d> profile;
  for (std::uint32_t i = 0; i < across; ++i) {
    const Vec2d direction = circle_point(i, across);
    profile.push_back({major_radius + minor_radius * direction[0], minor_radius * direction[1]});
  }
  return sweep(profile, around);
}

SurfaceMesh make_grid_sheet(double width, double depth, std::uint32_t cells_x, std::uint32_t cells_y) {
  require_size(width, "the width");
  require_size(depth, "the depth");
  require_count(cells_x, 1, "the number of cells along x");
  require_count(cells_y, 1, "the number of cells along y");
  require_room(std::uint64_t{cells_x} + 1, std::uint64_t{cells_y} + 1);
  SurfaceMesh mesh;
  for (std::uint32_t j = 0; j <= cells_y; ++j) {
    for (std::uint32_t i = 0; i <= cells_x; ++i)
      mesh.points.push_back({width * (static_cast<double>(i) / cells_x), depth * (static_cast<double>(j) / cells_y), 0});
  }
  const std::size_t row = std::size_t{cells_x} + 1;
  for (std::size_t j = 0; j < cells_y; ++j) {
    for (std::size_t v = j * row; v < j * row + cells_x; ++v) {
      add_triangle(mesh, v, v + 1, v + row + 1);
      add_triangle(mesh, v, v + row + 1, v + row);
    }
  }
  return mesh;
}

SurfaceMesh extrude(std::span<const Vec2d> outline, double height) {
  require_size(height, "the height");
  SurfaceMesh mesh;
  mesh.points = counterclockwise_polygon(outline);
  const std::size_t n = mesh.points.size();
  const PolygonTriangulation cap = triangulate_polygon(mesh.points);
  for (std::size_t i = 0; i < n; ++i) mesh.points.push_back({mesh.points[i].x, mesh.points[i].y, height});
  for (const auto& [a, b, c] : cap.triangles) add_triangle(mesh, a, c, b);
  for (const auto& [a, b, c] : cap.triangles) add_triangle(mesh, a + n, b + n, c + n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add_triangle(mesh, i, next, next + n);
    add_triangle(mesh, i, next + n, i + n);
  }
  return mesh;
}

SurfaceMesh revolve(std::span<const Vec2d> profile, std::uint32_t around) {
  require_count(around, 3, "the number of steps");
  require_room(around, profile.size());
  const std::vector<Vec3d> corners = counterclockwise_polygon(profile);
  std::vector<Vec2d> turned;
  for (const Vec3d& p : corners) {
    require(p.x >= 0, "a corner of the profile is on the wrong side of the axis: its radius is negative");
    turned.push_back({p.x, p.y});
  }
  return sweep(turned, around);
}

}  // namespace mortise
