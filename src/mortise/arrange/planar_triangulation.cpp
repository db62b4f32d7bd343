// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sweep, swaps and edge recovery over exact turns.
#include "mortise/arrange/planar_triangulation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>

#include "mortise/base/error.h"

namespace mortise {
namespace {

constexpr std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

// The two coordinates that a projection keeps, in order.
constexpr std::array<std::size_t, 2> kept_coordinates(Axis axis) {
  const std::size_t a = static_cast<std::size_t>(axis);
  return {(a + 1) % 3, (a + 2) % 3};
}

// Positive when d lies inside the circle through a, b, c (counterclockwise) by more than rounding can explain.
bool is_clearly_in_circle(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c,
                          const std::array<double, 2>& d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1];
  const double bx = b[0] - d[0], by = b[1] - d[1];
  const double cx = c[0] - d[0], cy = c[1] - d[1];
  const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double positive = a2 * (bx * cy) + b2 * (cx * ay) + c2 * (ax * by);
  const double negative = a2 * (by * cx) + b2 * (cy * ax) + c2 * (ay * bx);
  const double size = a2 * (std::fabs(bx * cy) + std::fabs(by * cx)) + b2 * (std::fabs(cx * ay) + std::fabs(cy * ax)) +
                      c2 * (std::fabs(ax * by) + std::fabs(ay * bx));
  return positive - negative > 1e-12 * size;
}

}  // namespace

PlanarTriangulation::PlanarTriangulation(const PointSet& points, Axis axis, std::span<const PointId> vertices,
                                         std::span<const std::uint64_t> lines)
    : points_(points), axis_(axis), vertices_(vertices), lines_(lines) {
  order_ = sweep_order();
  take_shape();
  cell_at_.assign(vertices.size(), none);
  sweep();
  constexpr std::size_t few_vertices = 24;
  if (vertices.size() > few_vertices) improve();
}

void PlanarTriangulation::take_shape() {
  const auto [u, v] = kept_coordinates(axis_);
  const Vec3d& origin = points_.nearest(vertices_[order_[0]]);
  double size = 0;
  for (const PointId p : vertices_) {
    const Vec3d offset = points_.nearest(p) - origin;
    shape_.push_back({offset[u], offset[v]});
    size = std::max({size, std::fabs(offset[u]), std::fabs(offset[v])});
  }
  int exponent = 0;
  std::frexp(size, &exponent);  // the same judgement at every scale
  for (auto& [x, y] : shape_) {
    x = std::ldexp(x, -exponent);
    y = std::ldexp(y, -exponent);
  }
}

Sign PlanarTriangulation::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  if ((lines_[a] & lines_[b] & lines_[c]) != 0) return Sign::Zero;
  return points_.orient2d(vertices_[a], vertices_[b], vertices_[c], axis_);
}

// ---- sweep ----------------------------------------------------------------------------------------------------------

std::vector<std::uint32_t> PlanarTriangulation::sweep_order() const {
  std::vector<std::uint32_t> order(vertices_.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto kept = kept_coordinates(axis_);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (a == b) return false;
    const Sign first = points_.compare(vertices_[a], vertices_[b], kept[0]);
    return first != Sign::Zero ? first == Sign::Negative : points_.compare(vertices_[a], vertices_[b], kept[1]) == Sign::Negative;
  });
  return order;
}

std::uint32_t PlanarTriangulation::add_cell(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto cell = static_cast<std::uint32_t>(cells_.size());
  cells_.push_back({{a, b, c}, {none, none, none}});
  fixed_.insert(fixed_.end(), 3, 0);
  for (const std::uint32_t v : {a, b, c}) cell_at_[v] = cell;
  return cell;
}

void PlanarTriangulation::link(Side s, Side t) {
  cells_[s.cell].neighbour[s.edge] = t.cell;
  cells_[t.cell].neighbour[t.edge] = s.cell;
}

// The first points lie on one line, the apex does not: a fan.
//
//      apex
//     / | \ .
//    /  |  \ .
//   q0--q1--q2
void PlanarTriangulation::add_start_cells(const std::vector<std::uint32_t>& order, std::size_t apex, bool is_left) {
  const std::uint32_t p = order[apex];
  for (std::size_t i = 0; i + 1 < apex; ++i) {
    const std::uint32_t a = is_left ? order[i] : order[i + 1];
    const std::uint32_t b = is_left ? order[i + 1] : order[i];
    const std::uint32_t cell = add_cell(a, b, p);
    hull_next_[a] = b;
    hull_side_[a] = {cell, 0};
    if (i > 0) link({cell, is_left ? 2U : 1U}, {cell - 1, is_left ? 1U : 2U});
  }
  const std::uint32_t last = static_cast<std::uint32_t>(cells_.size()) - 1;
  const std::uint32_t from = is_left ? order[apex - 1] : order[0];
  const std::uint32_t to = is_left ? order[0] : order[apex - 1];
  hull_next_[from] = p;
  hull_side_[from] = {is_left ? last : 0, 1};
  hull_next_[p] = to;
  hull_side_[p] = {is_left ? 0 : last, 2};
  for (std::uint32_t v = p, n = hull_next_[v];; v = n, n = hull_next_[v]) {
    hull_previous_[n] = v;
    if (n == p) break;
  }
}

std::size_t PlanarTriangulation::start_sweep(const std::vector<std::uint32_t>& order) {
  for (std::size_t apex = 2; apex < order.size(); ++apex) {
    const Sign s = turn(order[0], order[1], order[apex]);
    if (s == Sign::Zero) continue;
    add_start_cells(order, apex, s == Sign::Positive);
    return apex;
  }
  MORTISE_CHECK(false, "a planar triangulation whose points lie on one line");
}

// Joins a point beyond the hull to every hull edge it sees; the point added before it is on the hull and next to one.
void PlanarTriangulation::add_outside(std::uint32_t previous, std::uint32_t p) {
  std::uint32_t begin = previous;
  while (turn(hull_previous_[begin], begin, p) == Sign::Negative) begin = hull_previous_[begin];
  std::uint32_t end = previous;
  while (turn(end, hull_next_[end], p) == Sign::Negative) end = hull_next_[end];
  MORTISE_CHECK(begin != end, "vertex " + std::to_string(vertices_[p].value) + " of a planar triangulation");
  std::uint32_t before = none;
  for (std::uint32_t v = begin; v != end; v = hull_next_[v]) {
    const std::uint32_t cell = add_cell(hull_next_[v], v, p);
    link({cell, 0}, hull_side_[v]);
    if (before == none) {
      hull_side_[begin] = {cell, 1};
    } else {
      link({cell, 1}, {before, 2});
    }
    before = cell;
  }
  hull_side_[p] = {before, 2};
  hull_next_[begin] = p;
  hull_previous_[p] = begin;
  hull_next_[p] = end;
  hull_previous_[end] = p;
}

void PlanarTriangulation::sweep() {
  hull_next_.assign(order_.size(), none);
  hull_previous_.assign(order_.size(), none);
  hull_side_.assign(order_.size(), {none, 0});
  const std::size_t apex = start_sweep(order_);
  for (std::size_t i = apex + 1; i < order_.size(); ++i) add_outside(order_[i - 1], order_[i]);
}

// ---- walking --------------------------------------------------------------------------------------------------------

std::size_t PlanarTriangulation::corner_index(std::uint32_t cell, std::uint32_t vertex) const {
  const auto& c = cells_[cell].corner;
  return c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
}

// Visits the cells round a vertex until `visit(cell, corner)` answers true.
template <class Visit>
void PlanarTriangulation::for_each_cell_at(std::uint32_t vertex, Visit visit) const {
  const std::uint32_t start = cell_at_[vertex];
  for (std::uint32_t cell = start; cell != none;) {
    const std::size_t i = corner_index(cell, vertex);
    if (visit(cell, i)) return;
    cell = cells_[cell].neighbour[next(next(i))];  // counterclockwise: across the edge that ends at the vertex
    if (cell == start) return;
  }
  for (std::uint32_t cell = cells_[start].neighbour[corner_index(start, vertex)]; cell != none;) {
    const std::size_t i = corner_index(cell, vertex);
    if (visit(cell, i)) return;
    cell = cells_[cell].neighbour[i];  // the hull was reached: clockwise from the start
  }
}

// The side that runs from a to b; cell none when there is no such edge, or only one that runs from b to a.
PlanarTriangulation::Side PlanarTriangulation::find_side(std::uint32_t a, std::uint32_t b) const {
  Side found{none, 0};
  for_each_cell_at(a, [&](std::uint32_t cell, std::size_t i) {
    if (cells_[cell].corner[next(i)] != b) return false;
    found = {cell, static_cast<std::uint32_t>(i)};
    return true;
  });
  return found;
}

// The side opposite to a through which the segment from a to b leaves the first cell.
PlanarTriangulation::Side PlanarTriangulation::first_crossed(std::uint32_t a, std::uint32_t b) const {
  Side found{none, 0};
  for_each_cell_at(a, [&](std::uint32_t cell, std::size_t i) {
    const std::uint32_t right = cells_[cell].corner[next(i)];
    const std::uint32_t left = cells_[cell].corner[next(next(i))];
    if (turn(a, right, b) != Sign::Positive || turn(a, b, left) != Sign::Positive) return false;
    found = {cell, static_cast<std::uint32_t>(next(i))};
    return true;
  });
  MORTISE_CHECK(found.cell != none, "segment " + std::to_string(vertices_[a].value) + "-" + std::to_string(vertices_[b].value));
  return found;
}

// ---- swaps ----------------------------------------------------------------------------------------------------------

// Both corner turns of the pair of cells at the ends of the edge are strictly convex.
bool PlanarTriangulation::is_swappable(Side s) const {
  const std::uint32_t other = cells_[s.cell].neighbour[s.edge];
  if (other == none || fixed_[3 * s.cell + s.edge] != 0) return false;
  const std::uint32_t a = cells_[s.cell].corner[s.edge];
  const std::uint32_t b = cells_[s.cell].corner[next(s.edge)];
  const std::uint32_t c = cells_[s.cell].corner[next(next(s.edge))];
  const std::uint32_t d = cells_[other].corner[next(next(corner_index(other, b)))];
  return turn(c, d, b) == Sign::Positive && turn(d, c, a) == Sign::Positive;
}

bool PlanarTriangulation::improves(Side s) const {
  const std::uint32_t other = cells_[s.cell].neighbour[s.edge];
  if (other == none || fixed_[3 * s.cell + s.edge] != 0) return false;
  const Cell& cell = cells_[s.cell];
  const std::uint32_t d = cells_[other].corner[next(next(corner_index(other, cell.corner[next(s.edge)])))];
  return is_clearly_in_circle(shape_[cell.corner[0]], shape_[cell.corner[1]], shape_[cell.corner[2]], shape_[d]);
}

//      c               c
//    /   \           / | \ .
//   a-----b   ->    a  |  b
//    \   /           \ | /
//      d               d
// Returns the side of the new edge that runs from d to c, in the cell left of it.
PlanarTriangulation::Side PlanarTriangulation::swap(Side s) {
  const std::uint32_t left = s.cell;
  const std::uint32_t right = cells_[left].neighbour[s.edge];
  const std::size_t i = s.edge;
  const std::size_t j = corner_index(right, cells_[left].corner[next(i)]);  // right: b at j, a at j + 1, d at j + 2
  const std::uint32_t a = cells_[left].corner[i];
  const std::uint32_t b = cells_[left].corner[next(i)];
  const std::uint32_t c = cells_[left].corner[next(next(i))];
  const std::uint32_t d = cells_[right].corner[next(next(j))];
  struct Outer {
    std::uint32_t cell;
    std::uint8_t is_fixed;
  };
  const auto outer = [&](std::uint32_t cell, std::size_t edge) { return Outer{cells_[cell].neighbour[edge], fixed_[3 * cell + edge]}; };
  const Outer bc = outer(left, next(i)), ca = outer(left, next(next(i)));
  const Outer ad = outer(right, next(j)), db = outer(right, next(next(j)));
  const auto set = [&](std::uint32_t cell, std::array<std::uint32_t, 3> corner, const std::array<Outer, 3>& sides) {
    cells_[cell].corner = corner;
    for (std::size_t k = 0; k < 3; ++k) {
      cells_[cell].neighbour[k] = sides[k].cell;
      fixed_[3 * cell + k] = sides[k].is_fixed;
    }
    for (const std::uint32_t v : corner) cell_at_[v] = cell;
  };
  set(left, {d, c, a}, {Outer{right, 0}, ca, ad});
  set(right, {c, d, b}, {Outer{left, 0}, db, bc});
  const auto redirect = [&](std::uint32_t cell, std::uint32_t from, std::uint32_t to) {
    if (cell == none) return;
    for (std::uint32_t& n : cells_[cell].neighbour) {
      if (n == from) {
        n = to;
        return;
      }
    }
  };
  redirect(ad.cell, right, left);
  redirect(bc.cell, left, right);
  return {left, 0};
}

void PlanarTriangulation::improve() {
  std::deque<Side> queue;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    for (std::uint32_t e = 0; e < 3; ++e) {
      if (cells_[c].neighbour[e] != none && cells_[c].neighbour[e] > c) queue.push_back({c, e});
    }
  }
  std::size_t budget = 32 * queue.size() + 64;  // judged in doubles, swaps might go round in a circle
  while (!queue.empty() && budget > 0) {
    const Side s = queue.front();
    queue.pop_front();
    if (!improves(s) || !is_swappable(s)) continue;
    --budget;
    const Side swapped = swap(s);
    const std::uint32_t other = cells_[swapped.cell].neighbour[0];
    for (const std::uint32_t cell : {swapped.cell, other}) {
      queue.push_back({cell, 1});
      queue.push_back({cell, 2});
    }
  }
}

// ---- edges ----------------------------------------------------------------------------------------------------------

void PlanarTriangulation::fix(std::uint32_t a, std::uint32_t b) {
  for (const Side s : {find_side(a, b), find_side(b, a)}) {
    if (s.cell != none) fixed_[3 * s.cell + s.edge] = 1;
  }
}

std::vector<std::array<std::uint32_t, 2>> PlanarTriangulation::crossed_edges(std::uint32_t a, std::uint32_t b) const {
  std::vector<std::array<std::uint32_t, 2>> crossed;
  Side s = first_crossed(a, b);
  while (true) {
    const std::uint32_t right = cells_[s.cell].corner[s.edge];
    const std::uint32_t left = cells_[s.cell].corner[next(s.edge)];
    const std::string segment = std::to_string(vertices_[a].value) + "-" + std::to_string(vertices_[b].value);
    MORTISE_CHECK(!is_fixed(s.cell, s.edge), "segment " + segment);
    crossed.push_back({right, left});
    const std::uint32_t cell = cells_[s.cell].neighbour[s.edge];
    const std::size_t i = corner_index(cell, left);  // cell: left at i, right at i + 1, apex at i + 2
    const std::uint32_t apex = cells_[cell].corner[next(next(i))];
    if (apex == b) return crossed;
    const Sign side = turn(a, b, apex);
    MORTISE_CHECK(side != Sign::Zero, "segment " + segment + " through point " + std::to_string(vertices_[apex].value));
    s = {cell, static_cast<std::uint32_t>(side == Sign::Positive ? next(i) : next(next(i)))};
  }
}

void PlanarTriangulation::recover_edge(std::uint32_t a, std::uint32_t b) {
  if (find_side(a, b).cell != none || find_side(b, a).cell != none) return fix(a, b);
  const auto crossed = crossed_edges(a, b);
  std::deque<std::array<std::uint32_t, 2>> queue(crossed.begin(), crossed.end());
  std::size_t budget = 16 * crossed.size() * crossed.size() + 64;
  while (!queue.empty()) {
    MORTISE_CHECK(budget-- > 0, "segment " + std::to_string(vertices_[a].value) + "-" + std::to_string(vertices_[b].value));
    const auto edge = queue.front();
    queue.pop_front();
    const Side s = find_side(edge[0], edge[1]);
    if (!is_swappable(s)) {
      queue.push_back(edge);
      continue;
    }
    const Side swapped = swap(s);
    const std::uint32_t p = cells_[swapped.cell].corner[0];
    const std::uint32_t q = cells_[swapped.cell].corner[1];
    if (p == a || p == b || q == a || q == b) continue;
    if (turn(a, b, p) * turn(a, b, q) == Sign::Negative) queue.push_back({p, q});
  }
  fix(a, b);
}

void PlanarTriangulation::recover_edges(std::span<const std::array<std::uint32_t, 2>> segments) {
  std::vector<std::uint32_t> place(order_.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i) place[order_[i]] = i;
  std::vector<std::array<std::uint32_t, 2>> placed;
  for (const auto& [a, b] : segments) placed.push_back({std::min(place[a], place[b]), std::max(place[a], place[b])});
  std::sort(placed.begin(), placed.end());
  for (const auto& [a, b] : placed) recover_edge(order_[a], order_[b]);
}

}  // namespace mortise
