// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A solid less what lies behind sheets that separate it (exact-core 4).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mortise/boolean/merge.h"

namespace mortise {

/// Takes the cells of a certified result that lie behind a sheet out of it, and the sheets. A cell lies behind a sheet when it
/// sees no front of it, but its back; where it sees both, the sheet ends inside and separates nothing there.
///
/// @param merged  with walls where sheets cut the solid
/// @param failed_faces  of the result, by number: they get the new ones
/// @return a sentence about each sheet that ends inside
/// O(n log n) in the result.
[[nodiscard]] std::vector<std::string> cut_by_sheets(const OperandFaces& faces, const Facets& facets, MergedMesh& merged,
                                                     std::vector<std::uint32_t>& failed_faces);

}  // namespace mortise
