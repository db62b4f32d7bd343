// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Triangulations of planar points: every cell turns left, they tile the convex hull, given edges stay, and shapes are Delaunay.
#include "mortise/arrange/planar_triangulation.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "mortise/base/error.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Position = std::array<double, 2>;
using Edge = std::array<std::uint32_t, 2>;

/// The point that projects to (u, v) along the axis.
Vec3d lifted(const Position& p, Axis axis) {
  Vec3d result{0.25, 0.25, 0.25};
  const auto a = static_cast<std::size_t>(axis);
  result[(a + 1) % 3] = p[0];
  result[(a + 2) % 3] = p[1];
  return result;
}

/// Points of one plane, by their positions in it.
struct PlanarPoints {
  explicit PlanarPoints(const std::vector<Position>& positions, Axis seen_along = Axis::Z) : axis(seen_along) {
    for (const Position& p : positions) vertices.push_back(points.add_input(lifted(p, axis)));
    lines.assign(vertices.size(), 0);
  }

  [[nodiscard]] PlanarTriangulation triangulate() const { return {points, axis, vertices, lines}; }

  PointSet points;
  std::vector<PointId> vertices;
  std::vector<std::uint64_t> lines;
  Axis axis;
};

struct SideOfCell {
  Edge edge;
  std::uint32_t cell, number;
};

/// The cell on the left of an edge, or none.
std::uint32_t cell_with_side(const std::vector<SideOfCell>& sorted, const Edge& edge) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), edge, [](const SideOfCell& s, const Edge& e) { return s.edge < e; });
  return at != sorted.end() && at->edge == edge ? at->cell : PlanarTriangulation::none;
}

/// Which rule of a triangulation of the hull does not hold; empty when all do. Together they say that the cells tile it: a disk
/// of cells that turn left, with a border that nowhere turns right.
std::string fault_of(const PlanarTriangulation& triangulation, const PlanarPoints& p) {
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return p.points.orient2d(p.vertices[a], p.vertices[b], p.vertices[c], p.axis);
  };
  const auto& cells = triangulation.cells();
  std::vector<std::uint8_t> is_used(p.vertices.size(), 0);
  std::vector<SideOfCell> sides;
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    const auto& corner = cells[c].corner;
    if (turn(corner[0], corner[1], corner[2]) != Sign::Positive) return "cell that does not turn left";
    for (std::uint32_t i = 0; i < 3; ++i) {
      is_used[corner[i]] = 1;
      sides.push_back({{corner[i], corner[(i + 1) % 3]}, c, i});
    }
  }
  if (std::count(is_used.begin(), is_used.end(), 0) != 0) return "vertex without a cell";
  std::sort(sides.begin(), sides.end(), [](const SideOfCell& a, const SideOfCell& b) { return a.edge < b.edge; });
  std::map<std::uint32_t, std::uint32_t> border;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const SideOfCell& s = sides[i];
    if (i > 0 && s.edge == sides[i - 1].edge) return "edge of two cells on one side";
    const std::uint32_t across = cell_with_side(sides, {s.edge[1], s.edge[0]});
    if (cells[s.cell].neighbour[s.number] != across) return "wrong neighbour";
    if (across == PlanarTriangulation::none && !border.try_emplace(s.edge[0], s.edge[1]).second) return "border through a vertex twice";
  }
  if (cells.size() != 2 * p.vertices.size() - 2 - border.size()) return "not a disk";
  std::size_t length = 0;
  for (std::uint32_t v = border.begin()->first; length < border.size(); ++length) {
    const std::uint32_t next = border.at(v);
    if (turn(v, next, border.at(next)) == Sign::Negative) return "border that turns right";
    v = next;
    if (v == border.begin()->first) break;
  }
  return length + 1 == border.size() ? "" : "border of several loops";
}

bool is_edge(const PlanarTriangulation& triangulation, std::uint32_t a, std::uint32_t b, bool is_fixed) {
  std::size_t sides = 0, fixed = 0;
  for (std::uint32_t c = 0; c < triangulation.cells().size(); ++c) {
    const auto& corner = triangulation.cells()[c].corner;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = corner[i], v = corner[(i + 1) % 3];
      if ((u != a || v != b) && (u != b || v != a)) continue;
      ++sides;
      fixed += triangulation.is_fixed(c, i) ? 1 : 0;
    }
  }
  return sides > 0 && (!is_fixed || fixed == sides);
}

std::vector<Position> random_positions(std::mt19937& random, std::size_t count, int size) {
  std::vector<Position> positions{{1, 0}, {0, 0}, {0, 1}};  // not all on one line
  while (positions.size() < count) {
    const auto coordinate = [&] { return static_cast<double>(random() % static_cast<std::uint32_t>(size)); };
    const Position p{coordinate(), coordinate()};
    if (std::find(positions.begin(), positions.end(), p) == positions.end()) positions.push_back(p);
  }
  return positions;
}

double turn_of(const Position& a, const Position& b, const Position& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Do two segments of small integer points share a point other than a common end?
bool cross(const Position& a, const Position& b, const Position& c, const Position& d) {
  const double c_side = turn_of(a, b, c), d_side = turn_of(a, b, d), a_side = turn_of(c, d, a), b_side = turn_of(c, d, b);
  if (c_side * d_side > 0 || a_side * b_side > 0) return false;
  const bool has_common_end = a == c || a == d || b == c || b == d;
  if (!has_common_end) return c_side != 0 || d_side != 0 || (std::max(a, b) >= std::min(c, d) && std::max(c, d) >= std::min(a, b));
  return false;
}

/// Edges between random points that cross no other and pass through no point.
std::vector<Edge> random_edges(std::mt19937& random, const std::vector<Position>& p, std::size_t tries) {
  std::vector<Edge> edges;
  const auto count = static_cast<std::uint32_t>(p.size());
  for (std::size_t t = 0; t < tries; ++t) {
    const auto a = static_cast<std::uint32_t>(random() % count), b = static_cast<std::uint32_t>(random() % count);
    if (a == b) continue;
    const auto is_inside = [&](const Position& x) {
      return x != p[a] && x != p[b] && turn_of(p[a], p[b], x) == 0 && std::min(p[a], p[b]) < x && x < std::max(p[a], p[b]);
    };
    const auto crosses = [&](const Edge& e) { return cross(p[a], p[b], p[e[0]], p[e[1]]); };
    if (std::any_of(p.begin(), p.end(), is_inside) || std::any_of(edges.begin(), edges.end(), crosses)) continue;
    edges.push_back({a, b});
  }
  return edges;
}

/// Inner edges, not fixed, whose far corner lies inside the circle of the cell. Exact for small integers.
std::size_t edges_against_delaunay(const PlanarTriangulation& triangulation, const std::vector<Position>& p) {
  std::size_t count = 0;
  const auto& cells = triangulation.cells();
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t other = cells[c].neighbour[i];
      if (other == PlanarTriangulation::none || triangulation.is_fixed(c, i)) continue;
      std::uint32_t d = 0;
      for (const std::uint32_t v : cells[other].corner) {
        if (std::find(cells[c].corner.begin(), cells[c].corner.end(), v) == cells[c].corner.end()) d = v;
      }
      std::array<std::array<double, 3>, 3> m{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Position& q = p[cells[c].corner[k]];
        const double x = q[0] - p[d][0], y = q[1] - p[d][1];
        m[k] = {x, y, x * x + y * y};
      }
      const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
      count += determinant > 0 ? 1 : 0;
    }
  }
  return count;
}

/// The cells, each from its first corner in the order of positions.
std::set<std::array<Position, 3>> cells_by_position(const PlanarTriangulation& triangulation, const std::vector<Position>& p) {
  std::set<std::array<Position, 3>> result;
  for (const auto& cell : triangulation.cells()) {
    std::array<Position, 3> corners{p[cell.corner[0]], p[cell.corner[1]], p[cell.corner[2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

std::vector<Position> grid(std::size_t nu, std::size_t nv) {
  std::vector<Position> p;
  for (std::size_t i = 0; i < nu; ++i) {
    for (std::size_t j = 0; j < nv; ++j) p.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  return p;
}

}  // namespace

TEST_CASE("three points are one cell that turns left, in either order") {
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    const PlanarPoints left({{0, 0}, {1, 0}, {0, 1}}, axis), right({{0, 0}, {0, 1}, {1, 0}}, axis);
    CHECK(left.triangulate().cells().size() == 1);
    CHECK(fault_of(left.triangulate(), left) == "");
    CHECK(fault_of(right.triangulate(), right) == "");
  }
}

TEST_CASE("points on one line are fanned from the first that is not, on either side") {
  for (const double apex : {1.0, -1.0}) {
    for (std::size_t count = 2; count < 8; ++count) {
      std::vector<Position> upright, level;
      for (std::size_t i = 0; i < count; ++i) {
        upright.push_back({0, static_cast<double>(i)});
        level.push_back({static_cast<double>(i), 0});
      }
      upright.push_back({apex, 0.5});
      level.push_back({static_cast<double>(count), apex});
      for (const auto& positions : {upright, level}) {
        const PlanarPoints p(positions);
        CHECK(p.triangulate().cells().size() == count - 1);
        CHECK(fault_of(p.triangulate(), p) == "");
      }
    }
  }
}

TEST_CASE("points that all lie on one line are no plane") {
  const PlanarPoints p({{0, 0}, {1, 1}, {2, 2}, {3, 3}});
  const auto error = error_of([&] { (void)p.triangulate(); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InternalError);
}

TEST_CASE("points in any order and along any axis tile their hull") {
  constexpr std::uint32_t seed = 4711;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (std::size_t i = 0, n = scaled_count(300, 20000); i < n; ++i) {
    const int size = 3 + static_cast<int>(random() % 12);
    const std::size_t count = 5 + random() % static_cast<std::uint32_t>(size * size - 4);
    const auto positions = random_positions(random, count, size);
    const PlanarPoints p(positions, static_cast<Axis>(i % 3));
    PlanarTriangulation triangulation = p.triangulate();
    CHECK(fault_of(triangulation, p) == "");
    triangulation.improve();
    CHECK(fault_of(triangulation, p) == "");
    CHECK(edges_against_delaunay(triangulation, positions) == 0);
  }
}

TEST_CASE("more than two dozen points are Delaunay from the start") {
  std::mt19937 random(5);
  const auto positions = random_positions(random, 200, 64);
  const PlanarPoints p(positions);
  CHECK(edges_against_delaunay(p.triangulate(), positions) == 0);
}

TEST_CASE("given edges become edges, stay, and leave the rest a triangulation") {
  constexpr std::uint32_t seed = 99;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::size_t recovered = 0;
  for (std::size_t i = 0, n = scaled_count(200, 10000); i < n; ++i) {
    const int size = 4 + static_cast<int>(random() % 10);
    const auto positions = random_positions(random, 6 + random() % static_cast<std::uint32_t>(size * size - 5), size);
    const std::vector<Edge> edges = random_edges(random, positions, 40);
    const PlanarPoints p(positions, static_cast<Axis>(i % 3));
    PlanarTriangulation triangulation = p.triangulate();
    for (const Edge& e : edges) triangulation.recover_edge(e[0], e[1]);
    CHECK(fault_of(triangulation, p) == "");
    triangulation.improve();
    CHECK(fault_of(triangulation, p) == "");
    CHECK(edges_against_delaunay(triangulation, positions) == 0);
    CHECK(std::all_of(edges.begin(), edges.end(), [&](const Edge& e) { return is_edge(triangulation, e[0], e[1], true); }));
    recovered += edges.size();
  }
  CHECK(recovered > scaled_count(200, 10000) * 5);
}

TEST_CASE("an edge that is there already is fixed, from either end") {
  const PlanarPoints p({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  for (const Edge& diagonal : {Edge{0, 2}, Edge{2, 0}, Edge{1, 3}, Edge{3, 1}}) {
    PlanarTriangulation triangulation = p.triangulate();
    CHECK_FALSE(is_edge(triangulation, 0, 1, true));
    triangulation.recover_edge(diagonal[0], diagonal[1]);
    triangulation.recover_edge(diagonal[0], diagonal[1]);
    triangulation.recover_edge(0, 1);
    CHECK(is_edge(triangulation, diagonal[0], diagonal[1], true));
    CHECK(is_edge(triangulation, 0, 1, true));
    CHECK_FALSE(is_edge(triangulation, 1, 2, true));
    CHECK(fault_of(triangulation, p) == "");
  }
}

TEST_CASE("the example of the paper: two edges are missing after the points are in (Fig. 13)") {
  // A zigzag across a face whose points a long diagonal edge keeps apart.
  const PlanarPoints p({{0, 0}, {12, 0}, {0, 12}, {1, 5}, {3, 1}, {5, 6}, {9, 2}});
  PlanarTriangulation triangulation = p.triangulate();
  const std::vector<Edge> chain{{3, 6}, {6, 4}};
  CHECK((!is_edge(triangulation, 3, 6, false) || !is_edge(triangulation, 6, 4, false)));
  for (const Edge& e : chain) triangulation.recover_edge(e[0], e[1]);
  for (const Edge& e : chain) CHECK(is_edge(triangulation, e[0], e[1], true));
  CHECK(fault_of(triangulation, p) == "");
}

TEST_CASE("an edge across a fixed one, or through a vertex, is a broken belief") {
  const PlanarPoints square({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  PlanarTriangulation crossed = square.triangulate();
  crossed.recover_edge(0, 2);
  const auto crossing = error_of([&] { crossed.recover_edge(1, 3); });
  REQUIRE(crossing);
  CHECK(crossing->code == ErrorCode::InternalError);
  const PlanarPoints middle({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}});
  PlanarTriangulation passed = middle.triangulate();
  const auto through = error_of([&] { passed.recover_edge(0, 2); });
  REQUIRE(through);
  CHECK(through->code == ErrorCode::InternalError);
}

TEST_CASE("a line that points are said to share saves arithmetic and changes nothing") {
  std::vector<Position> positions = grid(9, 9);
  PlanarPoints plain(positions), told(positions);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto u = static_cast<unsigned>(positions[v][0]), w = static_cast<unsigned>(positions[v][1]);
    told.lines[v] = (std::uint64_t{1} << u) | (std::uint64_t{1} << (16 + w)) | (std::uint64_t{1} << (32 + u + w));
  }
  const PlanarTriangulation first = plain.triangulate(), second = told.triangulate();
  REQUIRE(first.cells().size() == second.cells().size());
  for (std::size_t c = 0; c < first.cells().size(); ++c) {
    CHECK(first.cells()[c].corner == second.cells()[c].corner);
    CHECK(first.cells()[c].neighbour == second.cells()[c].neighbour);
  }
}

TEST_CASE("points one ulp apart and near a line by one ulp are told apart") {
  const double ulp = 0x1p-52;
  std::vector<Position> positions;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) positions.push_back({1 + i * ulp, 1 + j * ulp});
  }
  for (const Position& p : {Position{0, 0}, {0, 4}, {4, 0}, {2, 2}, {3, 3 + 2 * ulp}, {1.5, 1.5 - ulp}, {2, 2 - 2 * ulp}})
    positions.push_back(p);
  const PlanarPoints p(positions);
  PlanarTriangulation triangulation = p.triangulate();
  CHECK(fault_of(triangulation, p) == "");
  // From one side of the cluster to its far corner, 4 steps by 3: through no point between.
  triangulation.recover_edge(1, 24);
  CHECK(is_edge(triangulation, 1, 24, true));
  CHECK(fault_of(triangulation, p) == "");
}

TEST_CASE("two grids whose columns are an ulp apart have one triangulation, whatever the numbers of the points") {
  std::vector<Position> positions;
  for (int i = 0; i < 30; ++i) {
    for (int j = 0; j < 30; ++j) {
      positions.push_back({i / 30.0, j / 30.0});
      positions.push_back({(i + 0.5) / 30.0 - 0.5 / 30.0, (j + 0.25) / 30.0});  // about i / 30
    }
  }
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  const PlanarPoints p(positions);
  const PlanarTriangulation triangulation = p.triangulate();
  CHECK(fault_of(triangulation, p) == "");
  const std::vector<Position> backwards(positions.rbegin(), positions.rend());
  const PlanarPoints q(backwards);
  CHECK(cells_by_position(triangulation, positions) == cells_by_position(q.triangulate(), backwards));
}

TEST_CASE("sizes of 2^300 and 2^-300 tile as others do") {
  std::mt19937 random(17);
  for (const double scale : {0x1p300, 0x1p-300}) {
    auto positions = random_positions(random, 60, 10);
    for (Position& p : positions) p = {scale * p[0], scale * p[1]};
    const PlanarPoints p(positions);
    CHECK(fault_of(p.triangulate(), p) == "");
  }
}

TEST_CASE("made points that no double holds are placed exactly") {
  // Crossings of 12 random lines of the plane z = 0.25.
  constexpr std::uint32_t seed = 2;
  std::mt19937 random(seed);
  PlanarPoints p({});
  std::vector<LinePoints> lines;
  for (int i = 0; i < 12; ++i) {
    const auto point = [&] {
      return p.points.add_input({static_cast<double>(random() % 1000), static_cast<double>(random() % 1000), 0.25});
    };
    const PointId from = point();
    lines.push_back({from, point()});
  }
  std::size_t rounded = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const PointId x = p.points.add_line_line(lines[i], lines[j], Axis::Z);
      if (std::find(p.vertices.begin(), p.vertices.end(), x) != p.vertices.end()) continue;
      p.vertices.push_back(x);
      rounded += p.points.is_representable(x) ? 0 : 1;
    }
  }
  p.lines.assign(p.vertices.size(), 0);
  REQUIRE(rounded > 50);
  CHECK(fault_of(p.triangulate(), p) == "");
}

TEST_CASE("a thousand edges from one point are a fan") {
  std::vector<Position> positions{{0, 0}};
  constexpr std::uint32_t count = 1000;
  for (std::uint32_t i = 0; i < count; ++i) {  // on a parabola: no three on a line
    const double x = static_cast<double>(i) - 499.5;
    positions.push_back({x, 1000 + x * x});
  }
  const PlanarPoints p(positions);
  PlanarTriangulation triangulation = p.triangulate();
  for (std::uint32_t i = 1; i <= count; ++i) triangulation.recover_edge(0, i);
  CHECK(fault_of(triangulation, p) == "");
  std::size_t at_apex = 0;
  for (const auto& cell : triangulation.cells()) at_apex += std::count(cell.corner.begin(), cell.corner.end(), 0U) > 0 ? 1 : 0;
  CHECK(at_apex >= count - 1);
}

TEST_CASE("an edge across thousands of others is recovered in bounded time") {
  const auto n = static_cast<std::uint32_t>(scaled_count(4000, 20000));
  std::vector<Position> positions{{-1, 0.5}, {static_cast<double>(n), 0.5}};
  for (std::uint32_t i = 0; i < n; ++i) positions.push_back({static_cast<double>(i), i % 2 == 0 ? 0.0 : 1.0});
  const PlanarPoints p(positions);
  PlanarTriangulation triangulation = p.triangulate();
  triangulation.recover_edge(0, 1);
  CHECK(is_edge(triangulation, 0, 1, true));
  CHECK(fault_of(triangulation, p) == "");
}

TEST_CASE("an edge between two bent chains, where no swap is free, is recovered in bounded time") {
  const auto n = static_cast<std::uint32_t>(scaled_count(300, 1000));
  std::vector<Position> positions{{-1, 0}, {static_cast<double>(n), 0}};
  for (std::uint32_t i = 0; i < n; ++i) {  // two chains bent towards each other
    const double x = static_cast<double>(i), y = 1 + (x - n / 2.0) * (x - n / 2.0) / n;
    positions.push_back({x, y});
    positions.push_back({x, -y});
  }
  const PlanarPoints p(positions);
  PlanarTriangulation triangulation = p.triangulate();
  triangulation.recover_edge(0, 1);
  CHECK(is_edge(triangulation, 0, 1, true));
  CHECK(fault_of(triangulation, p) == "");
}

TEST_CASE("many thousands of points are triangulated in bounded time") {
  std::mt19937 random(3);
  std::vector<Position> positions;
  for (std::size_t i = 0, n = scaled_count(30000, 1000000); i < n; ++i) {
    positions.push_back({static_cast<double>(random()) * 0x1p-32, static_cast<double>(random()) * 0x1p-32});
  }
  const PlanarPoints scattered(positions);
  CHECK(fault_of(scattered.triangulate(), scattered) == "");
  const std::size_t side = is_reduced_run() ? 100 : 316;  // a hundred thousand points, most of them on lines of 316
  const PlanarPoints lattice(grid(side, side));
  CHECK(lattice.triangulate().cells().size() == 2 * (side - 1) * (side - 1));
}
