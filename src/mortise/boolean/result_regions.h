// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The solids a result consists of, and who covers them.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/boolean/result.h"
#include "mortise/mesh/inspect.h"

namespace mortise {

struct ResultRegion {
  std::vector<std::uint32_t> operands;  ///< that contain the region next to its boundary, ascending
  double volume = 0;
  double area = 0;  ///< of its whole boundary
};

struct ResultRegions {
  static constexpr std::uint32_t none = 0xffffffffU;  ///< outside the result

  std::vector<std::uint32_t> region_of_facet;  ///< the region behind it; none in an open result
  std::vector<std::uint32_t> region_in_front;  ///< of a partition: the region in front of it, or none; else empty
  std::vector<ResultRegion> regions;           ///< in the order of their lowest facets
  bool is_closed = true;                       ///< the facets round every region, each on its side, balance at every edge

  /// In the order of the regions.
  [[nodiscard]] double total_volume() const;
};

/// Connected solids of a certified result; bodies that touch in an edge or a corner are two. Of a partition, pieces of space
/// that different operands contain; void cavities are no regions. An open result (keep_faces) has none.
/// O(n log n) in facets.
[[nodiscard]] ResultRegions find_result_regions(const BooleanResult& result);

/// Where a result may have walls, its edges say nothing of its volume: corrects `closed` and `volume` of its report by its regions.
/// Closed is a result whose regions are and that has no border.
void correct_by_regions(const BooleanResult& result, const ResultRegions& regions, MeshReport& report);

/// Operands with a wall that has the same region on both sides: sheets that end within a region divide nothing there. Ascending.
[[nodiscard]] std::vector<std::uint32_t> find_idle_sheets(const BooleanResult& result, const ResultRegions& regions);

/// The boundary of one region as a mesh of its own, the region behind its faces; without labels and data (split_parts keeps them).
[[nodiscard]] SurfaceMesh region_mesh(const BooleanResult& result, const ResultRegions& regions, std::uint32_t region);

}  // namespace mortise
