// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What must hold for every imprint.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "mortise/boolean/imprint.h"
#include "support/boolean_checks.h"

namespace mortise::test {

/// Faults of the arrays: sizes, common numbers that name the same doubles and corners, source vertices with their bits, labels of the
/// source faces, triangles in the order of the faces, every facet of the whole in the operands its sources name and in no other.
[[nodiscard]] std::string faults_of_numbering(std::span<const SurfaceMesh* const> operands, const ImprintResult& result);

/// Faults found in rationals: the triangles of every face add up to its vector of area, facets lie in their sources, and a facet
/// is inside, outside or on other operands as its category says.
[[nodiscard]] std::string faults_of_split(std::span<const SurfaceMesh* const> operands, const ImprintResult& result);

/// Edges of which two operands or more have a triangle, as pairs of common numbers; sorted.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> shared_edges(const ImprintResult& result);

/// The meshes of the operands.
[[nodiscard]] std::vector<SurfaceMesh> imprinted_meshes(const ImprintResult& result);

/// Vertices, edges and triangles of all operands and of the whole: equal for an imprint that added nothing.
[[nodiscard]] std::vector<std::size_t> counts_of(const ImprintResult& result);

}  // namespace mortise::test
