// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The pipeline round one way of choosing facets: what every public function of this folder calls.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/merge.h"
#include "mortise/boolean/select.h"

namespace mortise {

/// Chooses the facets of the result.
using Selector = std::function<Selection(const OperandFaces&, const Facets&, const Categories&)>;

/// Arranges the operands, chooses, merges, certifies.
///
/// @param name  of the operation, for errors about the call as a whole
/// @throws what evaluate_boolean does, and what `select` does
[[nodiscard]] BooleanResult evaluate_selection(std::string_view name, const Selector& select, const OperandList& operands,
                                               const BooleanOptions& options);

/// A result, and where its vertices are exactly; after repair_by_snapping these are the doubles.
struct EvaluatedSelection {
  BooleanResult result;
  OperandFaces faces;
  std::vector<PointId> point_of_vertex;
  std::vector<SourceId> failed_faces;  ///< that contain triangles without a (relative) certificate
  MergedMesh all_facets;               ///< of the arrangement; only where there are such faces
};

/// The same for those who have more to ask of the arrangement.
[[nodiscard]] EvaluatedSelection evaluate_selection_exactly(std::string_view name, const Selector& select, const OperandList& operands,
                                                            const BooleanOptions& options);

}  // namespace mortise
