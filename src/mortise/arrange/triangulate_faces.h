// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Steps 6 to 8 of the paper: faces become facets that contain every segment, the same on both sides.
#pragma once

#include "mortise/arrange/facets.h"
#include "mortise/arrange/split_segments.h"

namespace mortise {

/// Facets of all operands. Faces without contact come back as they are; faces without area are gone.
///
/// Each overlay is triangulated once, over all points of its faces, with all segments and face edges kept; every facet
/// knows all faces that contain it. Order: by the lowest face of the overlay.
/// @throws Error{Cancelled}
[[nodiscard]] Facets triangulate_faces(const OperandFaces& faces, const Overlays& overlays, const FaceIntersectionMap& map,
                                       const LineSubdivision& lines, const ProgressCallback& progress);

}  // namespace mortise
