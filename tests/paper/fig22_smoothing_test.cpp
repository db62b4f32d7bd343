// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 22: where a vertex goes among its neighbours. The mean of circumcentres (CVT of the paper, the optimal Delaunay update) and of
// centroids (CPT) against closed forms; then random stars, whose worst triangle does not get worse.
#include <algorithm>
#include <array>
#include <cmath>

#include "mortise/base/trig.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/remesh/passes.h"
#include "mortise/remesh/vertex_ball.h"
#include "support/catch.h"
#include "support/random_source.h"
#include "support/remesh_scenes.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// A vertex, and the corners round it in turn.
struct Star {
  Vec3d middle;
  std::vector<Vec3d> ring;
};

SurfaceMesh mesh_of(const Star& star) {
  SurfaceMesh mesh;
  mesh.points = star.ring;
  mesh.points.push_back(star.middle);
  const std::size_t n = star.ring.size();
  for (std::size_t k = 0; k < n; ++k) mesh.triangles.push_back({VertexId(n), VertexId(k), VertexId((k + 1) % n)});
  return mesh;
}

Star regular_star(std::size_t corners, const Vec3d& middle) {
  Star star{middle, {}};
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 360 * static_cast<double>(k) / static_cast<double>(corners);
    star.ring.push_back({trig::cos_deg(angle), trig::sin_deg(angle), 0});
  }
  return star;
}

Star moved_along(Star star, double x) {
  star.middle.x += x;
  for (Vec3d& p : star.ring) p.x += x;
  return star;
}

/// All of one face, whatever its angles.
ModelScene one_face(const SurfaceMesh& mesh) {
  BrepRules rules = without_seams();
  rules.features.face_angle_deg = 180;
  return scene_of(mesh, rules);
}

/// Where the triangles would have the vertex.
Vec3d target_of(const Star& star, const SizingProxy& sizes) {
  const ModelScene scene = one_face(mesh_of(star));
  const WorkingMesh w(scene.mesh, scene.model, scene.normals, sizes, {});
  VertexBall ball;
  ball.gather(w, VertexId(star.ring.size()));
  return ball.centre();
}

const SizingProxy uniform({}, {.global = 1});

template <class Visit>
void for_each_triangle(const Star& star, const Visit& visit) {
  for (std::size_t k = 0; k < star.ring.size(); ++k) visit(star.ring[k], star.ring[(k + 1) % star.ring.size()]);
}

double largest_angle(const Star& star) {
  double largest = 0;
  for_each_triangle(star, [&](const Vec3d& p, const Vec3d& q) {
    for (const double angle : triangle_angles_deg(star.middle, p, q)) largest = std::max(largest, angle);
  });
  return largest;
}

double smallest_angle_at_middle(const Star& star) {
  double smallest = 180;
  for_each_triangle(star,
                    [&](const Vec3d& p, const Vec3d& q) { smallest = std::min(smallest, triangle_angles_deg(star.middle, p, q)[0]); });
  return smallest;
}

/// Where the energy sum A (xx + pp + qq) / 3 of a star in z = 0 is least: its gradient in x is 2/3 A x + sum (pp + qq) grad A_i / 3.
Vec3d least_energy_place(const Star& star) {
  double area = 0;
  Vec3d sum;
  for_each_triangle(star, [&](const Vec3d& p, const Vec3d& q) {
    area += cross(p - star.middle, q - star.middle).z / 2;
    sum = sum + (dot(p, p) + dot(q, q)) / 2 * Vec3d{p.y - q.y, q.x - p.x, 0};
  });
  return -1 / (2 * area) * sum;
}

/// Area of all, and centroid, of the polygon round a star in z = 0.
Vec3d centroid_of_polygon(const Star& star) {
  double area = 0;
  Vec3d sum;
  for_each_triangle(star, [&](const Vec3d& p, const Vec3d& q) {
    const double twice = p.x * q.y - p.y * q.x;
    area += twice;
    sum = sum + twice / 3 * (p + q);
  });
  return 1 / area * sum;
}

/// In z = 0 the point as far from all three.
Vec3d circumcentre(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d u = b - a, v = c - a;
  const double d = 2 * (u.x * v.y - u.y * v.x);
  return a + 1 / d * Vec3d{v.y * dot(u, u) - u.y * dot(v, v), u.x * dot(v, v) - v.x * dot(u, u), 0};
}

/// The mean of circumcentres, centroids where a triangle is obtuse, with weights A / (mean size)^2.
Vec3d weighted_mean(const Star& star, const SizingProxy& sizes) {
  double weights = 0;
  Vec3d sum;
  for_each_triangle(star, [&](const Vec3d& p, const Vec3d& q) {
    const std::array<double, 3> angles = triangle_angles_deg(star.middle, p, q);
    const bool is_obtuse = *std::max_element(angles.begin(), angles.end()) > 90;
    const double size = (sizes.size_at(star.middle) + sizes.size_at(p) + sizes.size_at(q)) / 3;
    const double weight = triangle_area(star.middle, p, q) / (size * size);
    sum = sum + weight * (is_obtuse ? 1.0 / 3 * (star.middle + p + q) : circumcentre(star.middle, p, q));
    weights += weight;
  });
  return 1 / weights * sum;
}

class RandomStars : public RandomSource {
 public:
  using RandomSource::RandomSource;

  /// In z = 0, or with corners up to this above and below it.
  Star next(double height) {
    for (;;) {
      Star star = regular_star(3 + below(7), {between(-0.3, 0.3), between(-0.3, 0.3), between(-height, height) / 2});
      for (Vec3d& p : star.ring) p = between(0.35, 1.5) * p + 0.2 * point(-1, 1);
      for (Vec3d& p : star.ring) p.z = between(-height, height);
      if (sees_all_round(star)) return star;
    }
  }

 private:
  static bool sees_all_round(const Star& star) {
    bool sees = true;
    for_each_triangle(star, [&](const Vec3d& p, const Vec3d& q) { sees = sees && cross(p - star.middle, q - star.middle).z > 0; });
    return sees;
  }
};

/// 4 sqrt(3) area over the sum of the squares of the edges.
double mean_ratio_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return 4 * std::sqrt(3.0) * triangle_area(a, b, c) / (dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c));
}

double worst_of(const Star& star) {
  double worst = 1;
  for_each_triangle(star, [&](const Vec3d& p, const Vec3d& q) { worst = std::min(worst, mean_ratio_of(star.middle, p, q)); });
  return worst;
}

struct Fallen {
  std::size_t moved = 0, worse = 0;
};

/// Moves the middles of stars once and counts those whose worst triangle got worse than it was and than `good_enough`.
Fallen smooth_stars(WorkingMesh w, const std::vector<Star>& stars, const std::vector<VertexId>& middles, double good_enough) {
  Fallen fallen;
  smooth_vertices(w, middles, good_enough);
  for (std::size_t k = 0; k < stars.size(); ++k) {
    Star after = stars[k];
    after.middle = w.mesh.points[middles[k].index()];
    fallen.moved += after.middle == stars[k].middle ? 0 : 1;
    fallen.worse += worst_of(after) < std::min(worst_of(stars[k]), good_enough) - 1e-9 ? 1 : 0;
  }
  return fallen;
}

/// Rows of nearly equilateral triangles of edge 1, vertices inside moved by a tenth at random.
SurfaceMesh shaken_rows(std::size_t rows, RandomSource& random) {
  SurfaceMesh mesh;
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= rows; ++i) {
      const bool is_inside = i > 0 && j > 0 && i < rows && j < rows;
      const Vec3d at{static_cast<double>(i) + 0.5 * static_cast<double>(j), std::sqrt(0.75) * static_cast<double>(j), 0};
      const double shake = is_inside ? 0.1 : 0;
      mesh.points.push_back(at + Vec3d{random.between(-shake, shake), random.between(-shake, shake), 0});
    }
  }
  const auto id = [&](std::size_t i, std::size_t j) { return VertexId(j * (rows + 1) + i); };
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < rows; ++i) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i, j + 1)});
      mesh.triangles.push_back({id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

/// Of optimal Delaunay triangulations: the integral of the linear interpolant of xx, less that of xx, which does not change.
double energy_of(const std::vector<Vec3d>& points, const std::vector<Triangle>& triangles, const Vec3d& origin) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3d p = points[a.index()] - origin, q = points[b.index()] - origin, r = points[c.index()] - origin;
    sum += triangle_area(p, q, r) / 3 * (dot(p, p) + dot(q, q) + dot(r, r));
  }
  return sum;
}

}  // namespace

TEST_CASE("Fig. 22: the displaced middle of a hexagon goes back to its centre", "[paper][remesh]") {
  for (const Vec3d& middle : {Vec3d{0.1, 0, 0}, Vec3d{0, -0.25, 0}, Vec3d{0.2, 0.15, 0}, Vec3d{-0.2, 0.1, 0}}) {
    const Star star = regular_star(6, middle);
    REQUIRE(largest_angle(star) < 90);
    CHECK(length(target_of(star, uniform)) < 1e-15);
    CHECK(length(centroid_of_polygon(star)) < 1e-15);
    CHECK(length(least_energy_place(star)) < 1e-15);
  }
}

TEST_CASE("Fig. 22: among acute triangles a vertex goes where the energy of optimal Delaunay triangulations is least", "[paper][remesh]") {
  RandomSource random(22);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < scaled_count(2000, 50000); ++k) {
    Star star = regular_star(5 + random.below(4), {random.between(-0.2, 0.2), random.between(-0.2, 0.2), 0});
    for (Vec3d& p : star.ring) p = random.between(0.8, 1.2) * p;
    if (!(largest_angle(star) < 90)) continue;
    CHECK(length(target_of(star, uniform) - least_energy_place(star)) < 1e-13);
    ++compared;
  }
  CHECK(compared > scaled_count(2000, 50000) / 10);
}

TEST_CASE("Fig. 22: among obtuse triangles a vertex goes to the centroid of the polygon round it", "[paper][remesh]") {
  RandomSource random(23);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < scaled_count(500, 10000); ++k) {
    Star star = regular_star(3, {random.between(-0.2, 0.2), random.between(-0.2, 0.2), 0});
    for (Vec3d& p : star.ring) p = random.between(0.7, 1.3) * p;
    if (!(smallest_angle_at_middle(star) > 90)) continue;
    CHECK(length(target_of(star, uniform) - centroid_of_polygon(star)) < 1e-14);
    CHECK(length(target_of(star, uniform) - 1.0 / 3 * (star.ring[0] + star.ring[1] + star.ring[2])) < 1e-14);
    ++compared;
  }
  CHECK(compared > scaled_count(500, 10000) / 10);
}

TEST_CASE("Fig. 22: triangles weigh as much as they have area in units of the size", "[paper][remesh]") {
  const SizingProxy sizes(std::vector{point_source({0.5, 0.2, 0}, 0.3, 1.8)}, {.global = 1});
  RandomStars random(24);
  for (std::size_t k = 0; k < scaled_count(2000, 50000); ++k) {
    const Star star = random.next(0);
    if (std::fabs(largest_angle(star) - 90) < 1e-3) continue;
    CHECK(length(target_of(star, sizes) - weighted_mean(star, sizes)) < 1e-11);
  }
}

TEST_CASE("Fig. 22: no move makes the worst triangle round a vertex worse, or worse than is good enough", "[paper][remesh]") {
  constexpr std::size_t stars_per_mesh = 25;
  for (const double height : {0.0, 0.3}) {
    RandomStars random(26);
    std::size_t moved_stars = 0;
    const std::size_t meshes = scaled_count(2000, 20000);
    for (std::size_t m = 0; m < meshes; ++m) {
      std::vector<Star> stars;
      std::vector<VertexId> middles;
      std::vector<SurfaceMesh> parts;
      std::size_t points = 0;
      for (std::size_t k = 0; k < stars_per_mesh; ++k) {
        stars.push_back(moved_along(random.next(height), 4.0 * static_cast<double>(k)));
        parts.push_back(mesh_of(stars.back()));
        points += parts.back().points.size();
        middles.emplace_back(points - 1);
      }
      const ModelScene scene = one_face(joined(parts));
      const WorkingMesh w(scene.mesh, scene.model, scene.normals, uniform, {});
      const Fallen strict = smooth_stars(w, stars, middles, 1);
      CHECK(strict.worse == 0);
      CHECK(smooth_stars(w, stars, middles, 0.75).worse == 0);
      moved_stars += strict.moved;
    }
    CHECK(moved_stars > meshes * stars_per_mesh / 2);
  }
}

TEST_CASE("Fig. 22: the energy of optimal Delaunay triangulations falls with every sweep over a plane", "[paper][remesh]") {
  RandomSource random(25);
  for (int mesh = 0; mesh < 5; ++mesh) {
    const ModelScene scene = scene_of(shaken_rows(20, random));
    REQUIRE(measure_faces(scene.mesh).angles.max_deg < 90);
    WorkingMesh w(scene.mesh, scene.model, scene.normals, uniform, {});
    const Box3 bounds = bounding_box(scene.mesh);
    const auto energy = [&] { return energy_of(w.mesh.points, scene.mesh.triangles, 0.5 * (bounds.lo + bounds.hi)); };
    for (int sweep = 0; sweep < 20; ++sweep) {
      const double before = energy();
      smooth_vertices(w, vertices_inside_faces(w), 1);
      CHECK(energy() <= before);
      if (sweep < 5) CHECK(energy() < before - 1e-6);
    }
  }
}
