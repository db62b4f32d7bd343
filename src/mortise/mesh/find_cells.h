// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The pieces of space that a mesh cuts out, with faces inside solids and open sheets.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

struct MeshCell {
  double volume = 0;
  double area = 0;  ///< of the faces that have the cell on one side only
};

struct MeshCells {
  static constexpr std::uint32_t unbounded = 0;

  std::vector<std::uint32_t> behind;    ///< per face: index into cells
  std::vector<std::uint32_t> in_front;  ///< per face
  std::vector<MeshCell> cells;          ///< [0] reaches to infinity and has no volume; the others in the order of their lowest faces
};

/// Pieces of space connected through their inside: bodies that touch in an edge or a corner are two, a body and its cavities
/// one, what lies in a cavity another. Both sides of a face that ends inside a cell are that cell.
///
/// The mesh does not cross itself and has no face without area; its faces may run either way and meet any number at an edge.
/// Sides of faces join round edges by exact radial order; a surface inside another is located by an exact ray.
/// O(n log n) in faces, plus a ray for each surface connected through edges.
[[nodiscard]] MeshCells find_cells(const SurfaceMesh& mesh);

}  // namespace mortise
