// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Insertion, swaps and edge recovery over exact turns.
#include "mortise/arrange/planar_triangulation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mortise/base/error.h"

namespace mortise {
namespace {

constexpr std::uint32_t next(std::size_t i) { return i == 2 ? 0 : static_cast<std::uint32_t>(i) + 1; }

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

// Place along a Hilbert curve through a grid of 2^16 x 2^16 cells over [0, 1] x [0, 1] (Hilbert 1891): what is near on the
// curve is near in the plane.
std::uint32_t place_on_curve(const std::array<double, 2>& p) {
  constexpr std::uint32_t size = 1U << 16U;
  const auto cell = [](double x) { return static_cast<std::uint32_t>(std::min(std::max(x, 0.0) * size, size - 1.0)); };
  std::uint32_t x = cell(p[0]), y = cell(p[1]), place = 0;
  for (std::uint32_t half = size / 2; half > 0; half /= 2) {
    const bool right = (x & half) != 0, top = (y & half) != 0;
    place = 4 * place + (right ? (top ? 2 : 3) : (top ? 1 : 0));
    if (top) continue;
    if (right) {
      x = size - 1 - x;
      y = size - 1 - y;
    }
    std::swap(x, y);
  }
  return place;
}

}  // namespace

PlanarTriangulation::PlanarTriangulation(const PointSet& points, Axis axis, std::span<const PointId> vertices,
                                         std::span<const std::uint64_t> lines)
    : points_(points), axis_(axis), vertices_(vertices), lines_(lines) {
  take_shape();
  order_ = insertion_order();
  cell_at_.assign(vertices.size(), none);
  const std::size_t apex = add_first_cell();
  for (std::size_t i = 2; i < order_.size(); ++i) {
    if (i != apex) insert(order_[i]);
  }
}

void PlanarTriangulation::take_shape() {
  const auto [u, v] = kept_coordinates(axis_);
  Box3 box;
  for (const PointId p : vertices_) box.extend(points_.nearest(p));
  const Vec3d half_size = 0.5 * box.hi - 0.5 * box.lo;  // the whole size may overflow
  int exponent = 0;
  std::frexp(std::max(half_size[u], half_size[v]), &exponent);  // the same judgement at every scale
  for (const PointId p : vertices_) {
    const Vec3d half_offset = 0.5 * points_.nearest(p) - 0.5 * box.lo;
    shape_.push_back({std::ldexp(half_offset[u], -exponent), std::ldexp(half_offset[v], -exponent)});
  }
}

Sign PlanarTriangulation::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  if ((lines_[a] & lines_[b] & lines_[c]) != 0) return Sign::Zero;
  return points_.orient2d(vertices_[a], vertices_[b], vertices_[c], axis_);
}

// ---- insertion ------------------------------------------------------------------------------------------------------

// Many points along a curve, so that each is next to the one before; few, and those in one cell of the curve, from low to high.
std::vector<std::uint32_t> PlanarTriangulation::insertion_order() const {
  const bool is_few = vertices_.size() <= few_vertices;
  std::vector<std::uint32_t> on_curve(vertices_.size(), 0), order(vertices_.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) {
    order[v] = v;
    if (!is_few) on_curve[v] = place_on_curve(shape_[v]);
  }
  const auto kept = kept_coordinates(axis_);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (on_curve[a] != on_curve[b]) return on_curve[a] < on_curve[b];
    if (a == b) return false;
    const Sign first = points_.compare(vertices_[a], vertices_[b], kept[0]);
    return (first != Sign::Zero ? first : points_.compare(vertices_[a], vertices_[b], kept[1])) == Sign::Negative;
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

// What was linked to `before` is linked to side `now` of another cell.
void PlanarTriangulation::replace_neighbour(std::uint32_t cell, std::uint32_t before, Side now) {
  cells_[now.cell].neighbour[now.edge] = cell;
  if (cell == none) return;
  auto& neighbours = cells_[cell].neighbour;
  *std::find(neighbours.begin(), neighbours.end(), before) = now.cell;
}

// The first two points and the next one that is not on their line; returns its place in the order.
std::size_t PlanarTriangulation::add_first_cell() {
  for (std::size_t apex = 2; apex < order_.size(); ++apex) {
    const Sign s = turn(order_[0], order_[1], order_[apex]);
    if (s == Sign::Zero) continue;
    const bool is_left = s == Sign::Positive;
    add_cell(order_[is_left ? 0 : 1], order_[is_left ? 1 : 0], order_[apex]);
    last_ = order_[apex];
    return apex;
  }
  MORTISE_CHECK(false, "a planar triangulation whose points lie on one line");
}

void PlanarTriangulation::insert(std::uint32_t p) {
  const Place place = locate(p);
  suspects_.clear();
  if (place.is_outside) {
    add_outside(place.side, p);
  } else if (place.is_on_side) {
    split_side(place.side, p);
  } else {
    split_cell(place.side.cell, p);
  }
  last_ = p;
  if (vertices_.size() > few_vertices) swap_suspects();
}

// A side of the hull next to the point inserted last, if that sees the new point; else cell none.
PlanarTriangulation::Side PlanarTriangulation::seen_beside_last(std::uint32_t p) const {
  Side hull{none, 0};
  for_each_cell_at(last_, [&](std::uint32_t cell, std::size_t i) {
    if (cells_[cell].neighbour[i] == none) hull = {cell, static_cast<std::uint32_t>(i)};
    return hull.cell != none;
  });
  if (hull.cell == none || sees(hull, p)) return hull;
  hull = previous_on_hull(hull);
  return sees(hull, p) ? hull : Side{none, 0};
}

bool PlanarTriangulation::sees(Side hull, std::uint32_t p) const {
  const Cell& c = cells_[hull.cell];
  return turn(c.corner[hull.edge], c.corner[next(hull.edge)], p) == Sign::Negative;
}

// Walks towards the point, at each cell beginning with another side: so it cannot go round in a circle for ever (Devillers,
// Pion and Teillaud 2002).
PlanarTriangulation::Place PlanarTriangulation::locate(std::uint32_t p) {
  if (const Side seen = seen_beside_last(p); seen.cell != none) return {seen, true, false};
  std::uint32_t cell = cell_at_[last_], from = none;
  while (true) {
    walk_state_ = 1664525 * walk_state_ + 1013904223;
    auto edge = static_cast<std::uint32_t>((std::uint64_t{walk_state_} * 3) >> 32U);
    Place place{{cell, 0}, false, false};
    bool is_inside = true;
    for (int i = 0; i < 3 && is_inside; ++i, edge = next(edge)) {
      const Cell& c = cells_[cell];
      if (c.neighbour[edge] == from && from != none) continue;
      const Sign side = turn(c.corner[edge], c.corner[next(edge)], p);
      if (side == Sign::Positive) continue;
      place.side = {cell, edge};
      place.is_on_side = side == Sign::Zero;
      is_inside = place.is_on_side;
    }
    if (is_inside) return place;
    if (cells_[cell].neighbour[place.side.edge] == none) return {place.side, true, false};
    from = cell;
    cell = cells_[cell].neighbour[place.side.edge];
  }
}

// The side of the hull after / before a side of the hull.
PlanarTriangulation::Side PlanarTriangulation::next_on_hull(Side s) const {
  const std::uint32_t v = cells_[s.cell].corner[next(s.edge)];
  for (s.edge = next(s.edge); cells_[s.cell].neighbour[s.edge] != none;) {
    s.cell = cells_[s.cell].neighbour[s.edge];
    s.edge = corner_index(s.cell, v);
  }
  return s;
}

PlanarTriangulation::Side PlanarTriangulation::previous_on_hull(Side s) const {
  const std::uint32_t v = cells_[s.cell].corner[s.edge];
  for (s.edge = next(next(s.edge)); cells_[s.cell].neighbour[s.edge] != none;) {
    s.cell = cells_[s.cell].neighbour[s.edge];
    s.edge = next(next(corner_index(s.cell, v)));
  }
  return s;
}

// Joins a point beyond the hull to every side of the hull it sees; one of them is known.
void PlanarTriangulation::add_outside(Side seen, std::uint32_t p) {
  Side first = seen;
  for (Side s = previous_on_hull(first); sees(s, p); s = previous_on_hull(s)) first = s;
  std::vector<Side> sides{first};
  for (Side s = next_on_hull(first); sees(s, p); s = next_on_hull(s)) sides.push_back(s);
  std::uint32_t before = none;
  for (const Side s : sides) {
    const Cell& c = cells_[s.cell];
    const std::uint32_t cell = add_cell(c.corner[next(s.edge)], c.corner[s.edge], p);
    link({cell, 0}, s);
    if (before != none) link({cell, 1}, {before, 2});
    suspects_.push_back({cell, 0});
    before = cell;
  }
}

// Cell (a, b, c) becomes (a, b, p), (b, c, p) and (c, a, p).
void PlanarTriangulation::split_cell(std::uint32_t cell, std::uint32_t p) {
  const auto [a, b, c] = cells_[cell].corner;
  const auto outer = cells_[cell].neighbour;
  const std::uint32_t bc = add_cell(b, c, p), ca = add_cell(c, a, p);
  cells_[cell].corner[2] = p;
  replace_neighbour(outer[1], cell, {bc, 0});
  replace_neighbour(outer[2], cell, {ca, 0});
  link({cell, 1}, {bc, 2});
  link({bc, 1}, {ca, 2});
  link({ca, 1}, {cell, 2});
  suspects_.insert(suspects_.end(), {{cell, 0}, {bc, 0}, {ca, 0}});
}

//        c
//      / | \ .
//     a--p--b
//      \ | /
//        d
void PlanarTriangulation::split_side(Side s, std::uint32_t p) {
  const std::uint32_t other = cells_[s.cell].neighbour[s.edge];
  const auto [at_a, at_b] = split_from_side(s, p);
  if (other == none) return;
  const auto& back = cells_[other].neighbour;
  const auto edge = static_cast<std::uint32_t>(std::find(back.begin(), back.end(), s.cell) - back.begin());
  const auto [other_at_b, other_at_a] = split_from_side({other, edge}, p);
  link({at_a, 1}, {other_at_a, 2});
  link({at_b, 2}, {other_at_b, 1});
}

// Cell (a, b, c) with p on its side a - b becomes (c, a, p) and (b, c, p).
std::array<std::uint32_t, 2> PlanarTriangulation::split_from_side(Side s, std::uint32_t p) {
  const std::uint32_t a = cells_[s.cell].corner[s.edge];
  const std::uint32_t b = cells_[s.cell].corner[next(s.edge)];
  const std::uint32_t c = cells_[s.cell].corner[next(next(s.edge))];
  const std::uint32_t bc = cells_[s.cell].neighbour[next(s.edge)], ca = cells_[s.cell].neighbour[next(next(s.edge))];
  const std::uint32_t at_b = add_cell(b, c, p);
  cells_[s.cell] = {{c, a, p}, {ca, none, none}};
  for (const std::uint32_t v : {a, c, p}) cell_at_[v] = s.cell;
  replace_neighbour(bc, s.cell, {at_b, 0});
  link({s.cell, 2}, {at_b, 1});
  suspects_.insert(suspects_.end(), {{s.cell, 0}, {at_b, 0}});
  return {s.cell, at_b};
}

// ---- walking --------------------------------------------------------------------------------------------------------

std::uint32_t PlanarTriangulation::corner_index(std::uint32_t cell, std::uint32_t vertex) const {
  const auto& c = cells_[cell].corner;
  return c[0] == vertex ? 0U : c[1] == vertex ? 1U : 2U;
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
  replace_neighbour(ad.cell, right, {left, 2});
  replace_neighbour(bc.cell, left, {right, 2});
  return {left, 0};
}

void PlanarTriangulation::improve() {
  suspects_.clear();
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    for (std::uint32_t e = 0; e < 3; ++e) {
      if (cells_[c].neighbour[e] != none && cells_[c].neighbour[e] > c) suspects_.push_back({c, e});
    }
  }
  swap_suspects();
}

void PlanarTriangulation::swap_suspects() {
  std::size_t budget = 32 * suspects_.size() + 64;  // judged in doubles, swaps might go round in a circle
  while (!suspects_.empty() && budget > 0) {
    const Side s = suspects_.front();
    suspects_.pop_front();
    if (!improves(s) || !is_swappable(s)) continue;
    --budget;
    const Side swapped = swap(s);
    const std::uint32_t other = cells_[swapped.cell].neighbour[0];
    for (const std::uint32_t cell : {swapped.cell, other}) {
      suspects_.push_back({cell, 1});
      suspects_.push_back({cell, 2});
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
