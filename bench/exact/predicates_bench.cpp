// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Nanoseconds per call of every predicate and construction, and which rungs answered; exact rungs against one another.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "mortise/exact/big_float.h"
#include "mortise/exact/expansion.h"
#include "mortise/exact/formulas.h"
#include "mortise/exact/point_set.h"
#include "mortise/exact/predicates.h"

namespace {

using namespace mortise;

constexpr std::size_t group_count = 4000;
constexpr int repetitions = 10;

using RungTally = std::array<long, rung_count>;

void print_row(const char* name, const char* data, double nanoseconds, const RungTally& tally) {
  std::printf("%-22s %-28s %9.1f ns  ", name, data, nanoseconds);
  long total = 0;
  for (const long n : tally) total += n;
  constexpr std::array<const char*, rung_count> names{"construction", "filter", "double-double", "expansion", "big"};
  for (std::size_t i = 0; i < tally.size() && total > 0; ++i) {
    if (tally[i] != 0) std::printf(" %s %.1f %%", names[i], 100.0 * static_cast<double>(tally[i]) / static_cast<double>(total));
  }
  std::printf("\n");
}

/// Times call(i), which returns an Answer, over all groups i: the fastest of ten rounds.
template <class Call>
void measure(const char* name, const char* data, std::size_t count, Call&& call) {
  RungTally tally{};
  for (std::size_t i = 0; i < count; ++i) ++tally[static_cast<std::size_t>(call(i).rung)];
  int sum = 0;
  double best = HUGE_VAL;
  for (int r = 0; r < repetitions; ++r) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < count; ++i) sum += static_cast<int>(call(i).sign);
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / static_cast<double>(count));
  }
  volatile int keep = sum;
  (void)keep;
  print_row(name, data, best, tally);
}

class Generator {
 public:
  double unit() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }
  std::size_t below(std::size_t n) { return random_() % n; }
  /// Random in the unit cube, all bits.
  Vec3d point() { return {unit(), unit(), unit()}; }
  /// Random in the unit cube, 24 bits: what an STL file holds.
  Vec3d float_point() { return {float(unit()), float(unit()), float(unit())}; }
  /// A multiple of 2^-10 within [-4, 4].
  Vec3d grid_point() { return 0x1p-10 * Vec3d{integer(), integer(), integer()}; }

 private:
  double integer() { return static_cast<double>(random_() % 8193) - 4096; }
  std::mt19937_64 random_{20260101};
};

/// Four or more points of one plane that is not parallel to an axis, exactly.
std::vector<Vec3d> coplanar_points(Generator& random, std::size_t count) {
  const Vec3d origin = random.grid_point(), u = random.grid_point(), v = random.grid_point();
  std::vector<Vec3d> points;
  while (points.size() < count) {
    points.push_back(origin + static_cast<double>(random.below(4096)) * u + static_cast<double>(random.below(4096)) * v);
  }
  return points;
}

void measure_input_predicates(const char* data, const std::vector<Vec3d>& p) {
  measure("orient3d", data, p.size() / 4,
          [&](std::size_t i) { return explain_orient3d(p[4 * i], p[4 * i + 1], p[4 * i + 2], p[4 * i + 3]); });
  measure("  expansion alone", data, p.size() / 4, [&](std::size_t i) {
    return Answer{orient3d_value<Expansion<2>>(p[4 * i], p[4 * i + 1], p[4 * i + 2], p[4 * i + 3]).sign(), Rung::Expansion};
  });
  measure("  big_float alone", data, p.size() / 4, [&](std::size_t i) {
    return Answer{orient3d_value<BigFloat>(p[4 * i], p[4 * i + 1], p[4 * i + 2], p[4 * i + 3]).sign(), Rung::BigFloat};
  });
  measure("orient2d", data, p.size() / 4, [&](std::size_t i) { return explain_orient2d(p[4 * i], p[4 * i + 1], p[4 * i + 2], Axis::Z); });
}

/// a * b, by scaled copies of a, summed two by two.
std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<std::vector<double>> rows;
  for (const double factor : b) {
    rows.emplace_back(2 * a.size());
    rows.back().resize(scale_expansion(a, factor, rows.back().data()));
  }
  while (rows.size() > 1) {
    std::vector<std::vector<double>> sums;
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
      sums.emplace_back(rows[i].size() + rows[i + 1].size());
      sums.back().resize(add_expansions(rows[i], rows[i + 1], sums.back().data()));
    }
    if (rows.size() % 2 == 1) sums.push_back(rows.back());
    rows = std::move(sums);
  }
  return rows.empty() ? std::vector<double>{} : rows[0];
}

/// Side of the plane p[5..7] of the point where line p[0..1] meets plane p[2..4], by the heights of the line's ends above the
/// two planes, in expansions throughout.
Sign side_by_expansions(const Vec3d* p) {
  const auto height = [](const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    const auto e = orient3d_value<Expansion<2>>(a, b, c, d);
    return std::vector<double>(e.terms.begin(), e.terms.begin() + static_cast<std::ptrdiff_t>(e.size));
  };
  const auto difference = [](const std::vector<double>& a, std::vector<double> b) {
    for (double& x : b) x = -x;
    std::vector<double> result(a.size() + b.size());
    result.resize(add_expansions(a, b, result.data()));
    return result;
  };
  const auto sign = [](const std::vector<double>& a) { return a.empty() ? Sign::Zero : sign_of(a.back()); };
  const auto own_0 = height(p[2], p[3], p[4], p[0]), own_1 = height(p[2], p[3], p[4], p[1]);
  const auto other_0 = height(p[5], p[6], p[7], p[0]), other_1 = height(p[5], p[6], p[7], p[1]);
  return sign(difference(product(other_0, own_1), product(other_1, own_0))) * sign(difference(own_1, own_0));
}

/// The same as PointSet's last rung takes it.
Sign side_by_big_float(const Vec3d* p) {
  const Homogeneous<BigFloat> x = line_plane_point<BigFloat>({p[0], p[1], p[2], p[3], p[4]});
  const BigFloat height = x.w * orient3d_value<BigFloat>(p[5], p[6], p[7], p[0]);
  return (height + dot(normal<BigFloat>(p[5], p[6], p[7]), x.offset)).sign() * x.w.sign();
}

void measure_exact_rungs(const char* data, const std::vector<Vec3d>& p) {
  const std::size_t count = p.size() / 8;
  measure("side, expansions", data, count, [&](std::size_t i) { return Answer{side_by_expansions(&p[8 * i]), Rung::Expansion}; });
  measure("side, big_float", data, count, [&](std::size_t i) { return Answer{side_by_big_float(&p[8 * i]), Rung::BigFloat}; });
}

enum class Form { LinePlane, LineLine, ThreePlanes };

/// One made point per group of ten input points; a line-line point uses coplanar ones.
PointId add_made(PointSet& set, Form form, const std::vector<PointId>& p, std::size_t i) {
  const std::size_t k = 10 * i;
  if (form == Form::LinePlane) return set.add_line_plane({p[k], p[k + 1]}, {p[k + 2], p[k + 3], p[k + 4]});
  if (form == Form::LineLine) return set.add_line_line({p[k], p[k + 1]}, {p[k + 2], p[k + 3]}, Axis::Z);
  return set.add_three_planes({p[k], p[k + 1], p[k + 2]}, {p[k + 3], p[k + 4], p[k + 5]}, {p[k + 6], p[k + 7], p[k + 8]});
}

void measure_made_points(const char* form_name, Form form, const char* data, const std::vector<Vec3d>& points) {
  const std::size_t count = points.size() / 10;
  PointSet set;
  std::vector<PointId> p, made;
  double best = HUGE_VAL;
  for (int r = 0; r < repetitions; ++r) {
    set = PointSet();
    p.clear();
    made.clear();
    for (const Vec3d& x : points) p.push_back(set.add_input(x));
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < count; ++i) made.push_back(add_made(set, form, p, i));
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count() / static_cast<double>(count));
  }
  print_row(form_name, data, best, {});
  measure("  side_of_plane", data, count, [&](std::size_t i) {
    const std::size_t k = 10 * i;
    return set.explain_side_of_plane({p[k + 5], p[k + 6], p[k + 9]}, made[i]);
  });
  measure("  orient2d", data, count - 2, [&](std::size_t i) { return set.explain_orient2d(made[i], made[i + 1], made[i + 2], Axis::Z); });
  measure("  compare", data, count - 1, [&](std::size_t i) { return set.explain_compare(made[i], made[i + 1], 0); });
}

/// Line x plane points in a plane that none of them was made from, and on a line none of them was made from.
void measure_unknown_zeros(Generator& random) {
  PointSet set;
  std::vector<std::array<PointId, 12>> groups;
  for (std::size_t i = 0; i < group_count; ++i) {
    const std::vector<Vec3d> flat = coplanar_points(random, 6);
    std::array<PointId, 12> ids;
    for (std::size_t k = 0; k < 6; ++k) ids[k] = set.add_input(flat[k]);
    for (std::size_t k = 6; k < 12; ++k) ids[k] = set.add_input(random.grid_point());
    groups.push_back(ids);
  }
  std::vector<PointId> made;
  for (const auto& g : groups) made.push_back(set.add_line_plane({g[6], g[7]}, {g[0], g[1], g[2]}));
  measure("side_of_plane", "line-plane, zero not known", made.size(), [&](std::size_t i) {
    return set.explain_side_of_plane({groups[i][3], groups[i][4], groups[i][5]}, made[i]);
  });
  std::vector<std::array<PointId, 3>> collinear;
  for (const auto& g : groups) {
    const PlanePoints cut{g[6], g[7], g[8]};
    collinear.push_back(
        {set.add_line_plane({g[0], g[1]}, cut), set.add_line_plane({g[2], g[3]}, cut), set.add_line_plane({g[4], g[5]}, cut)});
  }
  measure("orient2d", "line-plane, zero not known", collinear.size(),
          [&](std::size_t i) { return set.explain_orient2d(collinear[i][0], collinear[i][1], collinear[i][2], Axis::Z); });
  std::vector<std::array<PointId, 3>> traced;
  for (const auto& g : groups) {
    const PlanePoints cut{g[6], g[7], g[8]}, face{g[0], g[1], g[2]};
    traced.push_back(
        {set.add_line_plane({g[0], g[1]}, cut), set.add_line_plane({g[1], g[2]}, cut), set.add_line_plane({g[6], g[7]}, face)});
  }
  measure("orient2d", "line-plane, zero known", traced.size(),
          [&](std::size_t i) { return set.explain_orient2d(traced[i][0], traced[i][1], traced[i][2], Axis::Z); });
}

}  // namespace

int main() {
  Generator random;
  std::vector<Vec3d> full, single, grid, flat;
  for (std::size_t i = 0; i < 10 * group_count; ++i) {
    full.push_back(random.point());
    single.push_back(random.float_point());
    grid.push_back(random.grid_point());
  }
  for (std::size_t i = 0; i < group_count; ++i) {
    const std::vector<Vec3d> points = coplanar_points(random, 10);
    flat.insert(flat.end(), points.begin(), points.end());
  }
  std::vector<Vec3d> quads;
  for (std::size_t i = 0; i < group_count; ++i)
    quads.insert(quads.end(), flat.begin() + 10 * static_cast<std::ptrdiff_t>(i), flat.begin() + 10 * static_cast<std::ptrdiff_t>(i) + 4);
  std::vector<Vec3d> near_quads;
  for (std::size_t i = 0; i < group_count; ++i) {
    const Vec3d o = random.point(), u = random.point(), v = random.point();
    for (const Vec3d& x : {o, o + u, o + v, o + (0.3 * u + 0.7 * v)}) near_quads.push_back(x);
  }
  measure_input_predicates("random, 53 bits", full);
  measure_input_predicates("random, 24 bits", single);
  measure_input_predicates("coplanar, exactly", quads);
  measure_input_predicates("coplanar, rounded", near_quads);
  measure_exact_rungs("random, 53 bits", full);
  measure_exact_rungs("random, 24 bits", single);
  measure_exact_rungs("grid, 13 bits", grid);
  measure_made_points("line x plane", Form::LinePlane, "random, 53 bits", full);
  measure_made_points("line x plane", Form::LinePlane, "random, 24 bits", single);
  measure_made_points("line x plane", Form::LinePlane, "grid, 13 bits", grid);
  measure_made_points("line x line", Form::LineLine, "coplanar, exactly", flat);
  measure_made_points("three planes", Form::ThreePlanes, "random, 53 bits", full);
  measure_made_points("three planes", Form::ThreePlanes, "random, 24 bits", single);
  measure_unknown_zeros(random);
}
