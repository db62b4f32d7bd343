// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A mesh with what calls can use again: dragging a part pays for the mesh once.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mortise/arrange/connectivity.h"
#include "mortise/arrange/self_pairs.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A mesh that does not change, and what is known of it wherever it is put: which vertices are one point, parts, closedness, a
/// tree of boxes, and once a call asked for it, which of its faces may touch one another. What rounding may falsify is looked at
/// again in every call (docs/decisions/007): a call gives the same bits as with the mesh itself, moved by transform().
///
/// Takes about 110 bytes per face beside the mesh. Must outlive the calls it is used in; may be used by several at once.
class PreparedOperand {
 public:
  /// @throws Error{NotFinite, BadIndex, InvalidArgument}
  /// O(n log n), about half of what a call spends on such an operand.
  explicit PreparedOperand(SurfaceMesh mesh);
  ~PreparedOperand();
  PreparedOperand(PreparedOperand&&) noexcept;
  PreparedOperand& operator=(PreparedOperand&&) noexcept;

  [[nodiscard]] const SurfaceMesh& mesh() const;

  // For the stages of a call.

  /// Per vertex: the number of its position; positions are numbered in the order of their first vertices.
  [[nodiscard]] const std::vector<std::uint32_t>& position_of_vertex() const;
  /// Per position: its first vertex.
  [[nodiscard]] const std::vector<std::uint32_t>& first_vertex() const;
  [[nodiscard]] const Connectivity& connectivity() const;
  /// Of the boxes of the faces.
  [[nodiscard]] const BoxTree& tree() const;
  /// Are the corners of the face on no common line?
  [[nodiscard]] bool has_area(FaceId f) const;
  /// A bound of the heights of faces with area, from below; infinite when there are none.
  [[nodiscard]] double least_height() const;
  /// Found when first asked for: as long as searching the mesh for crossings.
  [[nodiscard]] const SelfPairs& self_pairs() const;

 private:
  struct Knowledge;
  std::unique_ptr<const Knowledge> knowledge_;
};

}  // namespace mortise
