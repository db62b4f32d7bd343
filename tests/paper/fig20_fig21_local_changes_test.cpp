// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Figs. 20 and 21: by the rules of the paper an edge shorter than the size is collapsed and one longer than twice that split at its
// middle; edges are swapped where the largest angle falls, and only there.
#include <algorithm>
#include <array>
#include <cmath>

#include "mortise/base/trig.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/triangulate_polygon.h"
#include "mortise/remesh/passes.h"
#include "support/catch.h"
#include "support/random_source.h"
#include "support/remesh_scenes.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A mesh under change, all sizes 1, with what it refers to. Stays where it is.
struct Bench {
  explicit Bench(const SurfaceMesh& mesh) : scene(scene_of(mesh)), w(scene.mesh, scene.model, scene.normals, sizes, {}) {}
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  SizingProxy sizes{{}, {.global = 1}};
  ModelScene scene;
  WorkingMesh w;
};

/// Two vertices at this distance in a hexagon; all other edges are between 1 and 2 long, before and after a collapse.
SurfaceMesh hexagon_round_edge(double apart) {
  const double x = apart / 2;
  return make_mesh({{-x, 0, 0}, {x, 0, 0}, {0, 1.2, 0}, {-1.3, 0.75, 0}, {-1.3, -0.75, 0}, {0, -1.2, 0}, {1.3, -0.75, 0}, {1.3, 0.75, 0}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {1, 0, 5}, {1, 5, 6}, {1, 6, 7}, {1, 7, 2}});
}

/// Two triangles on an edge of this length, not along an axis.
SurfaceMesh kite_round_edge(double size) {
  const Vec3d along{0.6 * size, 0.8 * size, 0}, across{-0.8, 0.6, 0}, middle = Vec3d{3, 5, 0} + 0.5 * along;
  return make_mesh({{3, 5, 0}, Vec3d{3, 5, 0} + along, middle + 1.2 * across, middle + -1.3 * across}, {{0, 1, 2}, {1, 0, 3}});
}

std::size_t vertex_count(const WorkingMesh& w) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < w.mesh.vertex_count(); ++v) count += w.mesh.has(VertexId(v)) ? 1 : 0;
  return count;
}

template <class Visit>
void for_each_inner_edge(const WorkingMesh& w, const Visit& visit) {
  for (HalfEdge h = 0; h < w.mesh.half_edge_count(); ++h) {
    if (w.mesh.has(h) && !w.mesh.is_on_model_edge(h) && h < w.mesh.opposite(h)) visit(h);
  }
}

double largest_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const std::array<double, 3> angles = triangle_angles_deg(a, b, c);
  return *std::max_element(angles.begin(), angles.end());
}

bool turns_left(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a).z > 0; }

/// By how many degrees the largest angle of two triangles falls with the other diagonal; below 0 when these would lie on one another.
double angle_gained(const WorkingMesh& w, HalfEdge h) {
  const auto at = [&](VertexId v) { return w.mesh.points[v.index()]; };
  const Vec3d a = at(w.mesh.origin(h)), b = at(w.mesh.target(h)), c = at(w.mesh.apex(h)), d = at(w.mesh.apex(w.mesh.opposite(h)));
  if (!turns_left(d, c, a) || !turns_left(c, d, b)) return -1;
  return std::max(largest_angle(a, b, c), largest_angle(b, a, d)) - std::max(largest_angle(d, c, a), largest_angle(c, d, b));
}

double largest_angle(const WorkingMesh& w) {
  double largest = 0;
  for (std::size_t t = 0; t < w.mesh.triangle_count(); ++t) {
    const auto [a, b, c] = w.mesh.triangle(FaceId(t));
    largest = std::max(largest, largest_angle(w.mesh.points[a.index()], w.mesh.points[b.index()], w.mesh.points[c.index()]));
  }
  return largest;
}

/// Corners in turn about the origin; with `spread` 0 on a circle, where no angle falls by a swap of a square.
SurfaceMesh polygon(std::size_t count, double spread, RandomSource& random) {
  SurfaceMesh mesh;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = 360 * static_cast<double>(k) / static_cast<double>(count), radius = 1 - spread * random.between(0, 1);
    mesh.points.push_back({radius * trig::cos_deg(angle), radius * trig::sin_deg(angle), 0});
  }
  for (const auto& [a, b, c] : triangulate_polygon(mesh.points).triangles)
    mesh.triangles.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return mesh;
}

/// A quadrilateral on its diagonal 0 1.
SurfaceMesh random_pair(RandomSource& random) {
  return make_mesh(
      {{-1, 0, 0}, {1, 0, 0}, {random.between(-2, 2), random.octaves(-3, 1), 0}, {random.between(-2, 2), -random.octaves(-3, 1), 0}},
      {{0, 1, 2}, {1, 0, 3}});
}

}  // namespace

TEST_CASE("Fig. 20: an edge shorter than the size is collapsed, one as long is not", "[paper][remesh]") {
  const RemeshRules rules = paper_rules();
  for (const double length : {0.5, 0.99, 1.01}) {
    INFO(length);
    Bench bench(hexagon_round_edge(length));
    REQUIRE(bench.w.mesh.is_inside_face(VertexId(0)));
    collapse_short_edges(bench.w, rules.shortest, rules.longest);
    bench.w.mesh.check();
    CHECK(vertex_count(bench.w) == (length < 1 ? 7U : 8U));
    CHECK(bench.w.mesh.live_triangle_count() == (length < 1 ? 6U : 8U));
  }
}

TEST_CASE("Fig. 20: an edge is not collapsed where that makes one longer than two sizes", "[paper][remesh]") {
  const RemeshRules rules = paper_rules();
  SurfaceMesh mesh = hexagon_round_edge(0.9);
  for (const std::size_t far : {3U, 4U}) mesh.points[far].x = -1.6;  // 2.2 from the right vertex
  for (const std::size_t far : {6U, 7U}) mesh.points[far].x = 1.6;
  Bench bench(mesh);
  collapse_short_edges(bench.w, rules.shortest, rules.longest);
  CHECK(vertex_count(bench.w) == 8);
}

TEST_CASE("Fig. 20: an edge longer than two sizes is split at its middle, one as long is not", "[paper][remesh]") {
  const RemeshRules rules = paper_rules();
  for (const double length : {1.99, 2.01, 2.3}) {
    INFO(length);
    Bench bench(kite_round_edge(length));
    split_long_edges(bench.w, rules.longest, 1000);
    bench.w.mesh.check();
    REQUIRE(vertex_count(bench.w) == (length < 2 ? 4U : 5U));
    const std::vector<Vec3d>& points = bench.w.mesh.points;
    if (length > 2) CHECK(points[4] == 0.5 * (points[0] + points[1]));
  }
}

TEST_CASE("Fig. 20: by the rules of the paper edges of two remeshed cylinders are between one and two sizes long", "[paper][remesh]") {
  const ModelScene scene = scene_of(Operation::Union, crossing_cylinders(48));
  const SizingProxy sizes({}, {.global = 0.1});
  const RemeshResult result = remesh(scene.mesh, scene.model, scene.normals, sizes, paper_rules());
  const auto count_between = [&](double least, double greatest) {
    double count = 0;
    for (const auto& [a, b] : build_topology(result.mesh).edges) {
      const double sizes_long = length(result.mesh.points[b.index()] - result.mesh.points[a.index()]) / 0.1;
      count += sizes_long >= least && sizes_long <= greatest ? 1 : 0;
    }
    return count;
  };
  // Moves come after splits and collapses, and model edges, which are neither, have edges from 0.7 sizes on.
  const double all = count_between(0, 100);
  CHECK(count_between(1, 2) > 0.95 * all);
  CHECK(count_between(2, 100) < 0.002 * all);
  CHECK(count_between(0, 0.7) == 0);
}

TEST_CASE("Fig. 21: an edge is swapped where that lowers the largest angle, and nowhere else", "[paper][remesh]") {
  RandomSource random(21);
  std::size_t swaps = 0, others = 0;
  for (std::size_t k = 0; k < scaled_count(2000, 50000); ++k) {
    Bench bench(random_pair(random));
    const HalfEdge diagonal = 0;
    REQUIRE_FALSE(bench.w.mesh.is_on_model_edge(diagonal));
    const double gained = angle_gained(bench.w, diagonal);
    if (std::fabs(gained) < 0.01) continue;
    swap_edges(bench.w);
    bench.w.mesh.check();
    const bool is_swapped = bench.w.mesh.are_neighbours(VertexId(2), VertexId(3));
    CHECK(is_swapped == (gained > 0));
    ++(is_swapped ? swaps : others);
  }
  CHECK(std::min(swaps, others) > scaled_count(2000, 50000) / 10);
}

TEST_CASE("Fig. 21: the queue of swaps ends where no angle falls any more", "[paper][remesh]") {
  RandomSource random(5);
  for (const double spread : {0.0, 0.1, 0.5}) {  // all corners on a circle: many swaps change nothing
    for (const std::size_t count : {4U, 8U, 64U, 300U}) {
      INFO(count << " corners, spread " << spread);
      Bench bench(polygon(count, spread, random));
      const double before = largest_angle(bench.w);
      swap_edges(bench.w);
      bench.w.mesh.check();
      CHECK(bench.w.mesh.live_triangle_count() == count - 2);
      CHECK(largest_angle(bench.w) <= before);
      std::size_t left = 0;
      for_each_inner_edge(bench.w, [&](HalfEdge h) { left += angle_gained(bench.w, h) > 0.01 ? 1 : 0; });
      CHECK(left == 0);
    }
  }
}
