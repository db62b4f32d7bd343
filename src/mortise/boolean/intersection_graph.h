// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The graph in which boundaries of different operands meet (paper 2.2, Fig. 3), and the measure of their contact.
#pragma once

#include "mortise/boolean/categorize.h"
#include "mortise/boolean/result.h"

namespace mortise {

/// Edges of the arrangement where facets of two or more operands meet, and isolated points of contact.
///
/// Edges inside an area where faces coincide are not part of it, the border of the area is. The same for every order of
/// operands and faces, up to numbering.
/// O(n) in the facets, n log n in the graph.
[[nodiscard]] IntersectionGraph build_intersection_graph(const OperandFaces& faces, const FaceIntersectionMap& map, const Facets& facets,
                                                         const Patches& patches);

/// Points, length and area that operands share.
[[nodiscard]] ContactMeasure measure_contact(const OperandFaces& faces, const Facets& facets, const IntersectionGraph& graph);

}  // namespace mortise
