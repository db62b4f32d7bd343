// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Regions of the mesh, with the operands that cover their facets from behind.
#include "mortise/boolean/result_regions.h"

#include <algorithm>

#include "mortise/mesh/find_regions.h"

namespace mortise {

ResultRegions find_result_regions(const BooleanResult& result) {
  const MeshRegions found = find_regions(result.mesh);
  ResultRegions regions;
  regions.region_of_facet = found.region_of_face;
  for (const MeshRegion& r : found.regions) regions.regions.push_back({{}, r.volume, r.area});
  std::vector<std::pair<std::uint32_t, std::uint32_t>> covered;  // region, covering set
  for (std::size_t f = 0; f < found.region_of_face.size(); ++f)
    covered.emplace_back(found.region_of_face[f], result.provenance.covering[f]);
  std::sort(covered.begin(), covered.end());
  covered.erase(std::unique(covered.begin(), covered.end()), covered.end());
  for (const auto& [region, set] : covered) {
    const std::vector<std::uint32_t>& operands = result.provenance.covering_sets[set];
    regions.regions[region].operands.insert(regions.regions[region].operands.end(), operands.begin(), operands.end());
  }
  for (ResultRegion& r : regions.regions) {
    std::sort(r.operands.begin(), r.operands.end());
    r.operands.erase(std::unique(r.operands.begin(), r.operands.end()), r.operands.end());
  }
  return regions;
}

}  // namespace mortise
