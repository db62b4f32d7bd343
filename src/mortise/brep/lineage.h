// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where the entities of a result's model come from, and what became of those of its operands (paper 7.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/brep/model_queries.h"
#include "mortise/mesh/provenance.h"

namespace mortise {

/// An entity of the model of an operand.
struct OperandEntity {
  std::uint32_t operand = 0;
  ModelEntity entity;

  auto operator<=>(const OperandEntity&) const = default;
};

/// Two entities of one dimension that have points in common.
struct LineageLink {
  ModelEntity result;
  OperandEntity source;
  double measure = 0;  ///< of what they share: area of facets, length of mesh edges, volume of the result's region; 1 for vertices
};

/// All links, twice.
struct Lineage {
  std::vector<LineageLink> by_result;  ///< by result, then source
  std::vector<LineageLink> by_source;  ///< by source, then result

  [[nodiscard]] std::span<const LineageLink> sources_of(const ModelEntity& result) const;
  [[nodiscard]] std::span<const LineageLink> results_of(const OperandEntity& source) const;
};

/// Links every entity of a result's model with those of the operands it lies on.
///
/// A face comes from the faces its facets are parts of. A vertex comes from vertices at its place. An edge comes from those
/// on which its mesh edges lie, to within what rounding moved. A region comes from every region that contains it; voids, of
/// operands and of the result, and the outside come from nothing and become nothing.
/// @param operands  the models of the operands as the operation got them, by number
/// @throws Error{InvalidArgument} when a facet comes from a triangle that no operand has
/// O(n log n), plus a ray through an operand of several regions for each region inside it that its faces do not bound.
[[nodiscard]] Lineage trace_lineage(const ModelView& result, const Provenance& provenance, std::span<const ModelView> operands);

}  // namespace mortise
