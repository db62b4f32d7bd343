// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Makes a solid of a heightfield.
#pragma once

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The solid between an open sheet and the plane at height z, which lies below or above the whole sheet: closed, oriented
/// outwards and free of crossings.
///
/// Equal positions of the sheet are welded and vertices without faces left out. The faces of the sheet come first, in order
/// (turned over where outward is the other side), then as many in the plane, then two for each boundary edge; a label of the
/// sheet stays, the others are labelled "base" and "side". Data are corner data of the sheet's faces; the others have no values.
/// @throws what validate() throws; Error{InvalidArgument} if z is not finite, naming vertices that lie in the plane or beyond,
/// or naming faces that stand upright, fold over, or meet others seen along z in more than what they share: no heightfield
/// O(n log n)
[[nodiscard]] SurfaceMesh extrude_to(const SurfaceMesh& sheet, double z);

}  // namespace mortise
