// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An operand as it was cut, and how it is read off the mesh of all facets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/mesh/provenance.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// An operand after an imprint: the same surface, with the edges of all its contacts.
struct ImprintedOperand {
  SurfaceMesh mesh;                          ///< in the order of the faces; orientation, labels and their names as in the operand; its data
  std::vector<std::uint32_t> vertex_ids;     ///< per vertex: its number in the mesh of all facets, ascending
  std::vector<std::uint32_t> facet_ids;      ///< per triangle: its number in the mesh of all facets
  std::vector<std::uint32_t> source_vertex;  ///< per vertex: the lowest vertex of the operand there; Provenance::none for a made one
  std::vector<std::uint32_t> source_face;    ///< per triangle
  std::vector<FacetCategory> category;       ///< per triangle, seen from this operand
};

/// Every operand out of the mesh of all facets of all operands (select_all), without vertex and corner data.
/// O(n).
[[nodiscard]] std::vector<ImprintedOperand> read_operands(std::span<const SurfaceMesh* const> operands, const SurfaceMesh& all_facets,
                                                          const Provenance& provenance);

[[nodiscard]] std::vector<const SurfaceMesh*> meshes_of(std::span<const ImprintedOperand> operands);

}  // namespace mortise
