// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An octree without neighbours: at the faces between cells of different sizes the view has two values, both within the error.
#include "mortise/size/background_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/base/numbers.h"
#include "mortise/geom/length.h"

namespace mortise {
namespace {

constexpr double margin = 1e-3;      // of the longest side, so that rounding puts no point of the box outside
constexpr double most_hidden = 0.2;  // a source may ask for less by this part between the places of a cell that are looked at
constexpr std::uint32_t deepest = 30;

// The root halved `level` times, at a place on the grid of its level.
struct Cell {
  std::array<std::uint32_t, 3> at{};
  std::uint32_t level = 0;
};

// Corner k of a cell is on the far side along axis i where bit i of k is set.
// Tetrahedra round the diagonal from corner 0 to corner 7, each a walk along its three axes; positive.
constexpr std::array<std::array<std::uint32_t, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

// A corner of a cell, or the middle of an edge, a face or all of it.
struct Place {
  std::array<std::uint32_t, 3> halves;      // of a side, along each axis
  std::array<std::uint32_t, 2> low_high{};  // places of the corners it is halfway between, on an edge of one of the tetrahedra
};
constexpr std::size_t place_count = 27;

// By x, then y, then z from low to high.
std::array<Place, place_count> places_of_a_cell() {
  std::array<Place, place_count> places;
  for (std::uint32_t i = 0; i < place_count; ++i) {
    const std::uint32_t x = i % 3, y = i / 3 % 3, z = i / 9;
    const auto corner = [](std::uint32_t far_x, std::uint32_t far_y, std::uint32_t far_z) { return 2 * far_x + 6 * far_y + 18 * far_z; };
    places[i] = {{x, y, z}, {corner(x / 2, y / 2, z / 2), corner((x + 1) / 2, (y + 1) / 2, (z + 1) / 2)}};
  }
  return places;
}

class ViewGrid {
 public:
  ViewGrid(const SizingProxy& proxy, const Box3& box, const ViewLimits& limits)
      : proxy_(proxy), limits_(limits), box_(box), places_(places_of_a_cell()) {
    const Vec3d extent = box.hi - box.lo;
    const double longest = std::max({extent.x, extent.y, extent.z});
    const bool is_box = longest > 0 && longest <= std::numeric_limits<double>::max() && extent.x >= 0 && extent.y >= 0 && extent.z >= 0;
    if (!is_box || !(limits.error > 0) || limits.most_cells == 0)
      throw Error(ErrorCode::InvalidArgument, "background_view", "a view needs a box with a length, an error and cells");
    side_ = longest * (1 + 2 * margin);
    origin_ = box.lo - Vec3d{margin * longest, margin * longest, margin * longest};
  }

  // Where it is needed most first, as long as there is room.
  [[nodiscard]] std::vector<Cell> refine() const {
    std::vector<Cell> cells{Cell{}};
    std::priority_queue<Candidate> candidates;
    candidates.push({need_of(cells[0]), 0});
    while (!candidates.empty() && candidates.top().need > 1 && cells.size() + 7 <= limits_.most_cells) {
      const std::size_t place = candidates.top().place;
      candidates.pop();
      const std::vector<Cell> halves = halves_of(cells[place]);  // at least one meets the box
      cells[place] = halves[0];
      candidates.push({need_of(halves[0]), place});
      for (std::size_t k = 1; k < halves.size(); ++k) {
        candidates.push({need_of(halves[k]), cells.size()});
        cells.push_back(halves[k]);
      }
    }
    return cells;
  }

  void append(const Cell& cell, std::string& text) const {
    std::array<std::string, 8> corners, sizes;
    for (std::uint32_t k = 0; k < 8; ++k) {
      const Vec3d p = point(cell, {2 * (k & 1), k & 2, (k & 4) / 2});
      corners[k] = format_double(p.x) + "," + format_double(p.y) + "," + format_double(p.z);
      sizes[k] = format_float(static_cast<float>(proxy_.size_at(p)));
    }
    for (const auto& [a, b, c, d] : tetrahedra) {
      text.append("SS(").append(corners[a]).append(",").append(corners[b]).append(",").append(corners[c]).append(",").append(corners[d]);
      text.append("){").append(sizes[a]).append(",").append(sizes[b]).append(",").append(sizes[c]).append(",").append(sizes[d]);
      text.append("};\n");
    }
  }

 private:
  struct Candidate {
    double need = 0;
    std::size_t place = 0;

    bool operator<(const Candidate& other) const { return need != other.need ? need < other.need : place > other.place; }
  };

  // The same bits from all cells that have the point.
  [[nodiscard]] Vec3d point(const Cell& cell, const std::array<std::uint32_t, 3>& halves) const {
    const double half = side_ / static_cast<double>(std::uint64_t{2} << cell.level);
    const auto along = [&](std::size_t i) { return static_cast<double>(2 * std::uint64_t{cell.at[i]} + halves[i]) * half; };
    return origin_ + Vec3d{along(0), along(1), along(2)};
  }

  [[nodiscard]] std::vector<Cell> halves_of(const Cell& cell) const {
    std::vector<Cell> halves;
    for (std::uint32_t k = 0; k < 8; ++k) {
      const Cell half{{2 * cell.at[0] + (k & 1), 2 * cell.at[1] + (k >> 1 & 1), 2 * cell.at[2] + (k >> 2)}, cell.level + 1};
      if (boxes_meet(Box3{point(half, {0, 0, 0}), point(half, {2, 2, 2})}, box_)) halves.push_back(half);
    }
    return halves;
  }

  // Above 1 the cell is too coarse, the more the larger it is.
  [[nodiscard]] double need_of(const Cell& cell) const {
    if (cell.level >= deepest) return 0;
    std::array<double, place_count> sizes{};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < place_count; ++i) {
      const double asked = proxy_.least_asked_at(point(cell, places_[i].halves));
      least = std::min(least, asked);
      sizes[i] = limited(asked);
    }
    const double from_a_place = length(point(cell, {1, 1, 1}) - point(cell, {0, 0, 0})) / 2;
    double need = (1 - limited(least - proxy_.slope() * from_a_place) / limited(least)) / most_hidden;
    for (std::size_t i = 0; i < place_count; ++i) {
      const double given = (sizes[places_[i].low_high[0]] + sizes[places_[i].low_high[1]]) / 2;
      need = std::max(need, std::fabs(given - sizes[i]) / (limits_.error * sizes[i]));
    }
    return need;
  }

  [[nodiscard]] double limited(double size) const { return std::max(proxy_.limits().smallest, std::min(size, proxy_.limits().global)); }

  const SizingProxy& proxy_;
  const ViewLimits& limits_;
  Box3 box_;
  Vec3d origin_;
  double side_ = 0;
  std::array<Place, place_count> places_;
};

}  // namespace

std::string background_view(const SizingProxy& proxy, const Box3& box, const ViewLimits& limits) {
  const ViewGrid grid(proxy, box, limits);
  std::string text = "View \"size\" {\n";
  for (const Cell& cell : grid.refine()) grid.append(cell, text);
  return text + "};\n";
}

}  // namespace mortise
