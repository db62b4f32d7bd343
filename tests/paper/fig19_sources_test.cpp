// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 19: what a point, a segment and a triangle ask for at twelve points, S + D (f - 1) with constant, linear and quadratic strength.
// Closest points and distances are of right triangles with whole sides, so every size is exact but for a few last places.
#include <algorithm>
#include <array>

#include "mortise/size/placed_source.h"
#include "mortise/size/sizing_proxy.h"
#include "support/catch.h"
#include "support/random_source.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr double growth = 1.25;

/// A point, how far it is from a source, and the strength of that at the closest point for every order.
struct HandWorked {
  Vec3d at;
  double distance;
  std::array<double, 3> strengths;
};

/// A source, its strengths by order, and four points.
struct Figure {
  SizeSource source;
  std::array<double, 6> strengths;
  std::array<HandWorked, 4> points;
};

// Linear strengths are the first of the quadratic ones: of a point one, of a segment two, of a triangle three.
const std::array<Figure, 3> figures{{
    {point_source({1, 2, 3}, 0.5, growth),
     {0.5},
     {{{{1, 2, 3}, 0, {0.5, 0.5, 0.5}},
       {{4, 6, 3}, 5, {0.5, 0.5, 0.5}},
       {{1, -3, 15}, 13, {0.5, 0.5, 0.5}},
       {{-1, 4, 4}, 3, {0.5, 0.5, 0.5}}}}},
    // Along t = x / 4: 1, 1 + 2 t, and through 1 in the middle 1 - 2 t + 4 tt.
    {segment_source({0, 0, 0}, {4, 0, 0}, 1, growth),
     {1, 3, 1},
     {{{{1, 3, 4}, 5, {1, 1.5, 0.75}}, {{-3, 4, 0}, 5, {1, 1, 1}}, {{7, 0, 4}, 5, {1, 3, 3}}, {{2, 0, 0}, 0, {1, 2, 1}}}}},
    // Over u = x / 4, v = y / 4: 1, 1 + u + 2 v, and 1 + u + 2 v + u v, whose value in the middle of the slope is 2.75.
    {triangle_source({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 1, growth),
     {1, 2, 3, 1.5, 2.75, 2},
     {{{{1, 1, 3}, 3, {1, 1.75, 1.8125}}, {{-3, -4, 0}, 5, {1, 1, 1}}, {{2, -3, 4}, 5, {1, 1.5, 1.5}}, {{3, 5, 1}, 3, {1, 2.75, 2.9375}}}}},
}};

SizeSource with_order(const Figure& figure, StrengthOrder order) {
  SizeSource source = figure.source;
  source.order = order;
  source.strengths = figure.strengths;
  return source;
}

constexpr std::array orders{StrengthOrder::Constant, StrengthOrder::Linear, StrengthOrder::Quadratic};

/// The three sources of the figure with strengths of one order, among many that ask for more everywhere near them.
std::vector<SizeSource> crowd(StrengthOrder order) {
  std::vector<SizeSource> sources;
  RandomSource random(19);
  for (int k = 0; k < 500; ++k) sources.push_back(segment_source(random.point(40, 60), random.point(40, 60), random.between(1, 2), growth));
  for (const Figure& figure : figures) sources.push_back(with_order(figure, order));
  return sources;
}

}  // namespace

TEST_CASE("Fig. 19: point, segment and triangle ask for S + D (f - 1) at twelve points, with strengths of three orders", "[paper][size]") {
  for (const Figure& figure : figures) {
    for (std::size_t k = 0; k < orders.size(); ++k) {
      const SizeSource source = with_order(figure, orders[k]);
      const SizingProxy alone(std::vector{source}, {.global = 100});
      for (const HandWorked& p : figure.points) {
        INFO(int(source.corner_count) << " corners, order " << k << ", at " << p.at.x << ' ' << p.at.y << ' ' << p.at.z);
        const double expected = p.strengths[k] + p.distance * (growth - 1);
        CHECK(alone.size_at(p.at) == Approx(expected).epsilon(1e-15));
        CHECK(alone.size_at(p.at) == size_from(place_source(source), p.at));
      }
    }
  }
}

TEST_CASE("Fig. 19: with bins over many sources sizes are those without, bit for bit", "[paper][size]") {
  for (const StrengthOrder order : orders) {
    const std::vector<SizeSource> sources = crowd(order);
    const SizingProxy proxy(sources, {.global = 100});
    for (const Figure& figure : figures) {
      for (const HandWorked& p : figure.points) {
        double least = 100;
        for (const SizeSource& source : sources) least = std::min(least, size_from(place_source(source), p.at));
        CHECK(proxy.size_at(p.at) == least);
      }
    }
  }
}
