// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The sizes of a view, read back and interpolated, against those of the proxy.
#include "mortise/size/background_view.h"

#include <cmath>
#include <limits>

#include "mortise/base/error.h"
#include "mortise/base/numbers.h"
#include "support/catch.h"
#include "support/random_source.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct Tetrahedron {
  std::array<Vec3d, 4> corners;
  std::array<double, 4> sizes;
};

double box_product(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return dot(cross(a, b), c); }

double volume_of(const Tetrahedron& t) {
  return box_product(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0], t.corners[3] - t.corners[0]) / 6;
}

/// Every line but the first and the last is SS(12 numbers){4 numbers};
std::vector<Tetrahedron> read_view(const std::string& text) {
  std::vector<Tetrahedron> tets;
  std::size_t at = text.find('\n') + 1;
  REQUIRE(text.substr(0, at) == "View \"size\" {\n");
  while (text.compare(at, 3, "SS(") == 0) {
    std::array<double, 16> numbers{};
    at += 3;
    for (std::size_t k = 0; k < 16; ++k) {
      const std::size_t end = text.find_first_of(",)}", at);
      numbers[k] = parse_double(std::string_view(text).substr(at, end - at)).value;
      at = end + (k == 11 ? 2 : 1);
    }
    Tetrahedron t{};
    for (std::size_t k = 0; k < 4; ++k) {
      t.corners[k] = {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
      t.sizes[k] = numbers[12 + k];
    }
    REQUIRE(text.compare(at, 2, ";\n") == 0);
    at += 2;
    tets.push_back(t);
  }
  CHECK(text.substr(at) == "};\n");
  return tets;
}

/// By the first tetrahedron the point is in; NaN when there is none.
double interpolate(const std::vector<Tetrahedron>& tets, const Vec3d& p) {
  for (const Tetrahedron& t : tets) {
    const Vec3d &o = t.corners[0], u = t.corners[1] - o, v = t.corners[2] - o, w = t.corners[3] - o, q = p - o;
    if (dot(q, q) > 4 * dot(w, w)) continue;
    const double whole = box_product(u, v, w);
    const double b = box_product(q, v, w) / whole, c = box_product(u, q, w) / whole, d = box_product(u, v, q) / whole;
    if (std::min({b, c, d, 1 - b - c - d}) < -1e-12) continue;
    return (1 - b - c - d) * t.sizes[0] + b * t.sizes[1] + c * t.sizes[2] + d * t.sizes[3];
  }
  return std::nan("");
}

double volume_of(const std::vector<Tetrahedron>& tets) {
  double sum = 0;
  for (const Tetrahedron& t : tets) {
    CHECK(volume_of(t) > 0);
    sum += volume_of(t);
  }
  return sum;
}

}  // namespace

TEST_CASE("a view without sources is one cube of the global size round the box", "[size]") {
  const std::vector<Tetrahedron> tets = read_view(background_view(SizingProxy({}, {.global = 0.5}), {{1, 2, 3}, {3, 4, 5}}));
  REQUIRE(tets.size() == 6);
  CHECK(volume_of(tets) == Approx(8 * std::pow(1.002, 3)));
  for (const Tetrahedron& t : tets) {
    CHECK(t.corners[0].x == Approx(0.998));
    CHECK(t.sizes == std::array<double, 4>{0.5, 0.5, 0.5, 0.5});
  }
}

TEST_CASE("sizes interpolated in a view are those of the proxy within 5 %", "[size]") {
  RandomSource random(4);
  std::vector<SizeSource> sources{point_source({0.2, 0.3, 0.9}, 0.004, 1.3), segment_source({0.1, 0.9, 0.1}, {0.9, 0.4, 0.3}, 0.02, 1.2),
                                  triangle_source({0.5, 0, 0}, {1, 0, 0.1}, {1, 0.3, 0.8}, 0.05, 1.4)};
  const SizingProxy proxy(sources, {.global = 0.15});
  const std::vector<Tetrahedron> tets = read_view(background_view(proxy, {{0, 0, 0}, {1, 1, 1}}));
  CHECK(tets.size() < 6 * 40000);
  CHECK(volume_of(tets) == Approx(std::pow(1.002, 3)));
  double worst = 0;
  for (int k = 0; k < 400; ++k) {
    Vec3d p = random.point(0, 1);
    if (k % 4 == 1) p = Vec3d{0.2, 0.3, 0.9} + random.octaves(-12, -4) * random.direction();
    if (k % 4 == 2) p = Vec3d{0.1, 0.9, 0.1} + random.between(0, 1) * Vec3d{0.8, -0.5, 0.2} + random.octaves(-9, -4) * random.direction();
    worst = std::max(worst, std::fabs(interpolate(tets, p) / proxy.size_at(p) - 1));
  }
  CAPTURE(worst, tets.size());
  CHECK(worst < 0.05);
}

TEST_CASE("a view finds a source that is much smaller than the box", "[size]") {
  // It reaches (0.1 - 0.001) / 0.5 = 0.198 far, in a box of 100.
  const SizingProxy proxy(std::vector{point_source({31.3, 0, 77.7}, 0.001, 1.5)}, {.global = 0.1});
  const std::vector<Tetrahedron> tets = read_view(background_view(proxy, {{0, 0, 0}, {100, 0, 100}}, {.error = 0.2}));
  CHECK(interpolate(tets, {31.3, 0, 77.7}) == Approx(0.001).epsilon(0.25));
  CHECK(interpolate(tets, {31.4, 0, 77.7}) == Approx(0.051).epsilon(0.25));
  CHECK(interpolate(tets, {90, 0, 10}) == Approx(0.1));
}

TEST_CASE("a view of a flat box covers it and little else", "[size]") {
  const SizingProxy proxy(std::vector{segment_source({0, 0, 0}, {1, 1, 0}, 0.01, 1.3)}, {.global = 0.2});
  const std::vector<Tetrahedron> tets = read_view(background_view(proxy, {{0, 0, 0}, {1, 1, 0}}));
  CHECK(tets.size() < 6 * 8000);
  RandomSource random(1);
  for (int k = 0; k < 100; ++k) {
    const Vec3d p{random.between(0, 1), random.between(0, 1), 0};
    CHECK(interpolate(tets, p) == Approx(proxy.size_at(p)).epsilon(0.05));
  }
  for (const Vec3d& corner : {Vec3d{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}) CHECK(std::isfinite(interpolate(tets, corner)));
}

TEST_CASE("a view has no more cells than wanted", "[size]") {
  const SizingProxy proxy(std::vector{point_source({0.3, 0.3, 0.3}, 1e-6, 1.2)}, {.global = 1});
  for (const std::size_t most : {1U, 8U, 9U, 1000U}) {
    const std::size_t count = read_view(background_view(proxy, {{0, 0, 0}, {1, 1, 1}}, {.error = 0.001, .most_cells = most})).size();
    CHECK(count <= 6 * most);
    CHECK(count + 6 * 7 > 6 * most);
  }
}

TEST_CASE("views of nothing are refused", "[size]") {
  const SizingProxy proxy({}, {.global = 1});
  for (const Box3& box :
       {Box3{}, Box3{{1, 1, 1}, {1, 1, 1}}, Box3{{0, 0, 1}, {1, 1, 0}}, Box3{{0, 0, 0}, {std::numeric_limits<double>::infinity(), 1, 1}}})
    CHECK_THROWS_AS(background_view(proxy, box), Error);
  CHECK_THROWS_AS(background_view(proxy, {{0, 0, 0}, {1, 1, 1}}, {.error = 0}), Error);
  CHECK_THROWS_AS(background_view(proxy, {{0, 0, 0}, {1, 1, 1}}, {.most_cells = 0}), Error);
}

TEST_CASE("the least that sources ask for has no limits", "[size]") {
  const SizingProxy proxy(std::vector{point_source({0, 0, 0}, 0.1, 1.5)}, {.global = 0.75, .smallest = 0.2});
  CHECK(proxy.least_asked_at({0, 0, 0}) == 0.1);
  CHECK(proxy.least_asked_at({10, 0, 0}) == 5.1);
  CHECK(SizingProxy({}, {.global = 1}).least_asked_at({0, 0, 0}) == std::numeric_limits<double>::infinity());
}
