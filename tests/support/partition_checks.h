// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What must hold for every partition.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mortise/boolean/result_regions.h"
#include "support/boolean_oracle.h"

namespace mortise::test {

/// Faults of a partition: closed regions that do not cross, every facet between different regions, arrays in step. One line
/// each; empty when right.
[[nodiscard]] std::string faults_of_partition(const BooleanResult& result);

/// Exact volume by set of covering operands, ascending; the vertices where they were before rounding.
[[nodiscard]] std::map<std::vector<std::uint32_t>, oracle::Rational> exact_volumes(std::span<const SurfaceMesh* const> operands,
                                                                                   const BooleanResult& result);

/// The same by the oracle: the volume that belongs to these operands and no others, for every choice with volume.
[[nodiscard]] std::map<std::vector<std::uint32_t>, oracle::Rational> expected_volumes(std::span<const SurfaceMesh* const> operands);

/// Vertices less edges plus faces less regions: 1 for a partition of a ball into balls.
[[nodiscard]] std::int64_t euler_with_regions(const BooleanResult& result);

/// How many edges have how many facets.
[[nodiscard]] std::map<std::size_t, std::size_t> fan_sizes(const SurfaceMesh& mesh);

}  // namespace mortise::test
