// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Regions of the mesh, with the operands that cover their facets from behind.
#include "mortise/boolean/result_regions.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "mortise/base/bits.h"
#include "mortise/mesh/find_cells.h"
#include "mortise/mesh/find_regions.h"

namespace mortise {
namespace {

// Does every edge run as often one way as the other? By two sums of 64 bits, which other edges do not cancel by chance.
bool is_balanced(const SurfaceMesh& mesh) {
  std::uint64_t sum = 0, other_sum = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t u = t[i].value, v = t[(i + 1) % 3].value;
      const std::uint64_t edge = (std::uint64_t{std::min(u, v)} << 32U) | std::max(u, v);
      const std::uint64_t bits = mixed_bits(edge), other_bits = mixed_bits(~edge);
      sum += u < v ? bits : -bits;
      other_sum += u < v ? other_bits : -other_bits;
    }
  }
  return sum == 0 && other_sum == 0;
}

// Operands that contain the region behind any of its facets.
void add_operands(const Provenance& provenance, ResultRegions& regions) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> covered;  // region, covering set
  for (std::size_t f = 0; f < regions.region_of_facet.size(); ++f) covered.emplace_back(regions.region_of_facet[f], provenance.covering[f]);
  std::sort(covered.begin(), covered.end());
  covered.erase(std::unique(covered.begin(), covered.end()), covered.end());
  for (const auto& [region, set] : covered) {
    const std::vector<std::uint32_t>& operands = provenance.covering_sets[set];
    regions.regions[region].operands.insert(regions.regions[region].operands.end(), operands.begin(), operands.end());
  }
  for (ResultRegion& r : regions.regions) {
    std::sort(r.operands.begin(), r.operands.end());
    r.operands.erase(std::unique(r.operands.begin(), r.operands.end()), r.operands.end());
  }
}

ResultRegions regions_of_boolean(const BooleanResult& result) {
  const MeshRegions found = find_regions(result.mesh);
  ResultRegions regions;
  regions.region_of_facet = found.region_of_face;
  for (const MeshRegion& r : found.regions) regions.regions.push_back({{}, r.volume, r.area});
  add_operands(result.provenance, regions);
  return regions;
}

// A cell with its kind of space makes a region; where no repair went wrong a cell has one kind.
class CellRegions {
 public:
  explicit CellRegions(const BooleanResult& result) : provenance_(result.provenance), cells_(find_cells(result.mesh)) {}

  [[nodiscard]] ResultRegions find() {
    for (std::size_t f = 0; f < cells_.behind.size(); ++f) {
      regions_.region_of_facet.push_back(region(cells_.behind[f], provenance_.covering[f]));
      regions_.region_in_front.push_back(region(cells_.in_front[f], provenance_.covering_front[f]));
    }
    for (ResultRegion& r : regions_.regions) {
      std::sort(r.operands.begin(), r.operands.end());
      r.operands.erase(std::unique(r.operands.begin(), r.operands.end()), r.operands.end());
    }
    return std::move(regions_);
  }

 private:
  std::uint32_t region(std::uint32_t cell, std::uint32_t covering) {
    const std::vector<std::uint32_t>& operands = provenance_.covering_sets[covering];
    const bool is_void = operands.empty();
    const std::uint32_t space = provenance_.space_of(covering);
    const auto space_of_cell = space_of_cell_.try_emplace(cell, space).first->second;
    if (space_of_cell != space || (cell == MeshCells::unbounded && !is_void)) regions_.is_closed = false;
    if (is_void) return ResultRegions::none;
    const auto number = static_cast<std::uint32_t>(regions_.regions.size());
    const auto [found, is_new] = number_.try_emplace({cell, space}, number);
    if (is_new) regions_.regions.push_back({{}, cells_.cells[cell].volume, cells_.cells[cell].area});
    if (seen_.insert({found->second, covering}).second) {
      std::vector<std::uint32_t>& all = regions_.regions[found->second].operands;
      all.insert(all.end(), operands.begin(), operands.end());
    }
    return found->second;
  }

  const Provenance& provenance_;
  MeshCells cells_;
  ResultRegions regions_;
  std::map<std::uint32_t, std::uint32_t> space_of_cell_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> number_;  // by cell and space
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen_;                   // region, covering set
};

}  // namespace

double ResultRegions::total_volume() const {
  double sum = 0;
  for (const ResultRegion& r : regions) sum += r.volume;
  return sum;
}

ResultRegions find_result_regions(const BooleanResult& result) {
  if (!result.provenance.covering_front.empty()) return CellRegions(result).find();
  if (is_balanced(result.mesh)) return regions_of_boolean(result);
  ResultRegions open;
  open.region_of_facet.assign(result.mesh.triangles.size(), ResultRegions::none);
  open.is_closed = false;
  return open;
}

void correct_by_regions(const BooleanResult& result, const ResultRegions& regions, MeshReport& report) {
  if (result.provenance.covering_front.empty()) return;
  report.closed = regions.is_closed && report.boundary_edges == 0;
  const bool has_volume = regions.is_closed && !regions.regions.empty();
  report.volume = has_volume ? std::optional(regions.total_volume()) : std::nullopt;
}

std::vector<std::uint32_t> find_idle_sheets(const BooleanResult& result, const ResultRegions& regions) {
  std::vector<std::uint32_t> idle;
  for (std::size_t f = 0; f < result.mesh.walls.size(); ++f) {
    const std::uint32_t region = regions.region_of_facet[f];
    if (result.mesh.walls[f] != 0 && region != ResultRegions::none && region == regions.region_in_front[f]) {
      idle.push_back(result.provenance.source_operand[f]);
    }
  }
  std::sort(idle.begin(), idle.end());
  idle.erase(std::unique(idle.begin(), idle.end()), idle.end());
  return idle;
}

SurfaceMesh region_mesh(const BooleanResult& result, const ResultRegions& regions, std::uint32_t region) {
  SurfaceMesh mesh;
  std::vector<VertexId> vertex(result.mesh.points.size());
  const auto add = [&](const Triangle& t) {
    for (const VertexId v : t) {
      if (vertex[v.index()].is_valid()) continue;
      vertex[v.index()] = VertexId(mesh.points.size());
      mesh.points.push_back(result.mesh.points[v.index()]);
    }
    mesh.triangles.push_back({vertex[t[0].index()], vertex[t[1].index()], vertex[t[2].index()]});
  };
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    const Triangle& t = result.mesh.triangles[f];
    const bool is_behind = regions.region_of_facet[f] == region;
    const bool is_in_front = !regions.region_in_front.empty() && regions.region_in_front[f] == region;
    if (is_behind == is_in_front) continue;
    add(is_behind ? t : Triangle{t[0], t[2], t[1]});
  }
  return mesh;
}

}  // namespace mortise
