// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sizes of sources against hand-worked points, closest points by search, and all sources asked in turn.
#include "mortise/size/sizing_proxy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/base/error.h"
#include "mortise/geom/length.h"
#include "support/catch.h"
#include "support/random_source.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

double size_of(const SizeSource& source, const Vec3d& p) { return size_from(place_source(source), p); }

SizeSource varying(SizeSource source, StrengthOrder order, const std::array<double, 6>& strengths) {
  source.order = order;
  source.strengths = strengths;
  return source;
}

// Distance by Ericson's regions, in the axes of the world.
double distance_to_segment(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  const Vec3d ab = b - a;
  const double square = dot(ab, ab);
  const double t = square > 0 ? std::clamp(dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
  return length(p - a - t * ab);
}

double distance_to_triangle(const std::array<Vec3d, 3>& c, const Vec3d& p) {
  const Vec3d normal = cross(c[1] - c[0], c[2] - c[0]);
  bool is_inside = dot(normal, normal) > 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d &a = c[k], &b = c[(k + 1) % 3];
    is_inside = is_inside && dot(cross(normal, b - a), p - a) >= 0;
    nearest = std::min(nearest, distance_to_segment(a, b, p));
  }
  return is_inside ? std::min(nearest, std::fabs(dot(normal, p - c[0])) / length(normal)) : nearest;
}

double distance_to(const SizeSource& source, const Vec3d& p) {
  if (source.corner_count == 1) return length(p - source.corners[0]);
  if (source.corner_count == 2) return distance_to_segment(source.corners[0], source.corners[1], p);
  return distance_to_triangle(source.corners, p);
}

class RandomSources : public RandomSource {
 public:
  using RandomSource::RandomSource;

  SizeSource next() {
    const Vec3d a = point(-1, 1);
    const double reach = octaves(-8, 1), size = octaves(-9, -1);
    const Vec3d b = a + point(-reach, reach), c = a + point(-reach, reach);
    SizeSource source = once_in(3)   ? point_source(a, size, 1)
                        : once_in(2) ? segment_source(a, b, size, 1)
                                     : triangle_source(a, b, c, size, 1);
    source.growth = once_in(10) ? 1 : 1 + octaves(-5, 1);
    if (once_in(4)) source.radius = octaves(-6, -1);
    if (once_in(2)) source = varying(source, once_in(2) ? StrengthOrder::Linear : StrengthOrder::Quadratic, strengths(size));
    return source;
  }

  std::vector<SizeSource> next(std::size_t count) {
    std::vector<SizeSource> sources;
    while (sources.size() < count) {
      sources.push_back(once_in(5) && !sources.empty() ? sources[below(sources.size())] : next());
      try {
        check_sources({&sources.back(), 1});
      } catch (const Error&) {
        sources.pop_back();
      }
    }
    return sources;
  }

 private:
  std::array<double, 6> strengths(double size) {
    std::array<double, 6> all{};
    for (double& s : all) s = size * between(0.5, 2);
    return all;
  }
};

double least_of_all(const std::vector<SizeSource>& sources, const SizeLimits& limits, const Vec3d& p) {
  double least = limits.global;
  for (const SizeSource& source : sources) least = std::min(least, size_of(source, p));
  return std::max(least, limits.smallest);
}

}  // namespace

TEST_CASE("a source asks for S + D (f - 1), at points worked out by hand", "[size]") {
  const SizeSource point = point_source({1, 2, 3}, 0.5, 1.5);
  CHECK(size_of(point, {1, 2, 3}) == 0.5);
  CHECK(size_of(point, {4, 6, 3}) == 0.5 + 5 * 0.5);

  const SizeSource segment = segment_source({0, 0, 0}, {4, 0, 0}, 0.25, 1.25);
  CHECK(size_of(segment, {1, 3, 4}) == 0.25 + 5 * 0.25);
  CHECK(size_of(segment, {-3, 4, 0}) == 0.25 + 5 * 0.25);
  CHECK(size_of(segment, {7, 0, 4}) == 0.25 + 5 * 0.25);

  const SizeSource triangle = triangle_source({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0.5, 2);
  CHECK(size_of(triangle, {1, 1, 3}) == 3.5);
  CHECK(size_of(triangle, {-3, -4, 0}) == 5.5);
  CHECK(size_of(triangle, {2, -3, 4}) == 5.5);
  CHECK(size_of(triangle, {4, 4, 1}) == Approx(0.5 + 3).epsilon(1e-15));

  SizeSource capsule = segment;
  capsule.radius = 2;
  CHECK(size_of(capsule, {1, 1, 0}) == 0.25);
  CHECK(size_of(capsule, {1, 3, 4}) == 0.25 + 3 * 0.25);
}

TEST_CASE("strengths vary linearly and quadratically along sources", "[size]") {
  const SizeSource segment = segment_source({0, 0, 0}, {4, 0, 0}, 1, 1.5);
  const SizeSource linear = varying(segment, StrengthOrder::Linear, {1, 3});
  CHECK(size_of(linear, {1, 0, 0}) == 1.5);
  CHECK(size_of(linear, {1, 3, 4}) == 1.5 + 2.5);
  CHECK(size_of(linear, {9, 0, 0}) == 3 + 2.5);
  const SizeSource quadratic = varying(segment, StrengthOrder::Quadratic, {1, 3, 1});
  CHECK(size_of(quadratic, {0, 0, 0}) == 1);
  CHECK(size_of(quadratic, {2, 0, 0}) == 1);
  CHECK(size_of(quadratic, {4, 0, 0}) == 3);
  CHECK(size_of(quadratic, {3, 2, 0}) == 1.75 + 1);

  const SizeSource triangle = triangle_source({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 1, 1.5);
  const SizeSource plane = varying(triangle, StrengthOrder::Linear, {1, 2, 3});
  CHECK(size_of(plane, {1, 1, 0}) == Approx(1.75).epsilon(1e-15));
  CHECK(size_of(plane, {1, 2, 6}) == Approx(2.25 + 3).epsilon(1e-15));
  // 1 + uv over u = x / 4, v = y / 4.
  const SizeSource saddle = varying(triangle, StrengthOrder::Quadratic, {1, 1, 1, 1, 1.25, 1});
  CHECK(size_of(saddle, {1, 1, 0}) == Approx(1 + 1. / 16).epsilon(1e-15));
  CHECK(size_of(saddle, {1, 2, -2}) == Approx(1 + 2. / 16 + 1).epsilon(1e-15));
}

TEST_CASE("sizes laid end to end from a source are a geometric progression", "[size]") {
  const SizingProxy proxy(std::vector{segment_source({0, -1, 0}, {0, 1, 0}, 0.01, 1.3)}, {.global = 10});
  double x = 0, expected = 0.01;
  for (int k = 0; k < 20; ++k) {
    CHECK(proxy.size_at({x, 0, 0}) == Approx(expected).epsilon(1e-13));
    x += expected;
    expected *= 1.3;
  }
}

TEST_CASE("sizes grow with the distance found by other means, for random sources", "[size]") {
  RandomSources random(11);
  for (std::size_t k = 0; k < scaled_count(3000, 100000); ++k) {
    SizeSource source = random.next();
    source.order = StrengthOrder::Constant;
    source.radius = 0;
    const Vec3d p = random.point(-3, 3);
    const double expected = source.strengths[0] + (source.growth - 1) * distance_to(source, p);
    CHECK(size_of(source, p) == Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("the proxy gives the least of all sources, bit for bit", "[size]") {
  std::size_t below_global = 0;
  for (std::size_t seed = 1; seed <= scaled_count(60, 1000); ++seed) {
    INFO("seed " << seed);
    RandomSources random(seed);
    const std::size_t count = random.size(1, 400);
    const std::vector<SizeSource> sources = random.next(count);
    const SizeLimits limits{.global = random.octaves(-4, 3), .smallest = random.once_in(3) ? 0.01 : 0};
    const SizingProxy proxy(sources, limits);
    std::size_t differing = 0;
    for (std::size_t k = 0; k < 500; ++k) {
      const Vec3d p = random.once_in(4) ? sources[random.below(count)].corners[0] : random.point(-3, 3);
      const double size = proxy.size_at(p);
      differing += size == least_of_all(sources, limits, p) ? 0 : 1;
      below_global += size < limits.global ? 1 : 0;
    }
    CHECK(differing == 0);
  }
  CHECK(below_global > scaled_count(60, 1000) * 100);
}

TEST_CASE("the proxy gives the least of many sources along a curve, far from the origin too", "[size]") {
  for (const double offset : {0.0, 1e6}) {
    std::vector<SizeSource> sources;
    const auto at = [&](double t) { return Vec3d{offset + std::cos(7 * t), std::sin(9 * t), std::cos(5 * t)}; };
    for (int k = 0; k < 5000; ++k) sources.push_back(segment_source(at(k / 5000.), at((k + 1) / 5000.), 1e-3 * (1 + k % 7), 1.2));
    const SizeLimits limits{.global = 0.3};
    const SizingProxy proxy(sources, limits);
    RandomSource random(5);
    std::size_t differing = 0;
    for (int k = 0; k < 1000; ++k) {
      const Vec3d p = at(random.between(0, 1)) + random.point(-0.5, 0.5);
      differing += proxy.size_at(p) == least_of_all(sources, limits, p) ? 0 : 1;
    }
    CHECK(differing == 0);
  }
}

TEST_CASE("no size differs from another by more than the slope times the way", "[size]") {
  for (std::size_t seed = 1; seed <= 20; ++seed) {
    RandomSources random(seed);
    const SizingProxy proxy(random.next(50), {.global = 2});
    for (int k = 0; k < 200; ++k) {
      const Vec3d p = random.point(-2, 2), q = p + random.point(-0.1, 0.1);
      CHECK(std::fabs(proxy.size_at(p) - proxy.size_at(q)) <= proxy.slope() * length(p - q) * (1 + 1e-9) + 1e-12);
    }
  }
}

TEST_CASE("a triangle without height is the segment it lies on", "[size]") {
  RandomSource random(3);
  const SizeSource segment = segment_source({0, 0, 0}, {3, 0, 0}, 0.1, 1.5);
  for (const double height : {0.0, 1e-300, 1e-17, 1e-12}) {
    const SizeSource thin = triangle_source({1, height, 0}, {0, 0, 0}, {3, 0, 0}, 0.1, 1.5);
    for (int k = 0; k < 100; ++k) {
      const Vec3d p = random.point(-4, 4);
      CHECK(size_of(thin, p) == Approx(size_of(segment, p)).epsilon(1e-11));
    }
  }
  CHECK(size_of(triangle_source({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, 0.5, 2), {1, 1, 3}) == 2.5);
}

TEST_CASE("without sources, and where there is no place, the size is the global one", "[size]") {
  const SizingProxy none({}, {.global = 0.75});
  CHECK(none.size_at({0, 0, 0}) == 0.75);
  CHECK(none.slope() == 0);
  const SizingProxy one(std::vector{point_source({0, 0, 0}, 0.1, 1.5)}, {.global = 0.75});
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), far = std::numeric_limits<double>::max();
  CHECK(one.size_at({nan, 0, 0}) == 0.75);
  CHECK(one.size_at({far, -far, far}) == 0.75);
  CHECK(one.sizes_at(std::vector<Vec3d>{{0, 0, 0}, {0, 1, 0}}) == std::vector{0.1, 0.6});
  const SizingProxy large(std::vector{point_source({0, 0, 0}, 3, 1.5)}, {.global = 0.75});
  CHECK(large.size_at({0, 0, 0}) == 0.75);
}

TEST_CASE("sources and limits that mean nothing are refused by number", "[size]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const SizeSource good = segment_source({0, 0, 0}, {1, 0, 0}, 0.1, 1.2);
  const auto refuses = [&](const SizeSource& bad, const std::string& text) {
    try {
      const SizingProxy proxy(std::vector{good, bad}, {.global = 1});
      FAIL("taken: " << text);
    } catch (const Error& error) {
      CHECK(error.code == ErrorCode::InvalidArgument);
      CHECK(error.message == "source 1 " + text);
    }
  };
  refuses(segment_source({0, 0, nan}, {1, 0, 0}, 0.1, 1.2), "has a corner that is not finite");
  refuses(point_source({0, 0, 0}, 0, 1.2), "has a size that is not a positive number");
  refuses(point_source({0, 0, 0}, nan, 1.2), "has a size that is not a positive number");
  refuses(point_source({0, 0, 0}, 1, 0.99), "has a growth that is below 1 or not finite");
  SizeSource bad = good;
  bad.radius = -1;
  refuses(bad, "has a radius that is negative or not finite");
  bad = good;
  bad.corner_count = 4;
  refuses(bad, "has 4 corners, not 1 to 3");
  refuses(varying(good, StrengthOrder::Linear, {1, -1}), "has a size that is not a positive number");
  // 1 - 2.7 t + 1.8 tt is below zero at t = 0.75.
  refuses(varying(good, StrengthOrder::Quadratic, {1, 0.1, 0.1}), "has sizes that fall below zero between those given");
  const SizeSource flat = triangle_source({0, 0, 0}, {1, 0, 0}, {3, 0, 0}, 1, 1.2);
  refuses(varying(flat, StrengthOrder::Linear, {1, 2, 3}), "is a triangle without area: its size cannot vary; take segments");
  for (const SizeLimits& limits : {SizeLimits{.global = 0}, {.global = nan}, {.global = 1, .smallest = 2}, {.global = 1, .smallest = -1}})
    CHECK_THROWS_AS(SizingProxy({}, limits), Error);
}
