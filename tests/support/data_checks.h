// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What must hold for vertex and corner data of results, by code that shares nothing with the pipeline.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/imprint.h"
#include "support/random_source.h"

namespace mortise::test {

/// Adds the channel "uv" of vertex data: two linear functions of the position, rounded; slopes up to 1.
[[nodiscard]] SurfaceMesh with_chart(SurfaceMesh mesh);

/// The largest difference between the channel "uv" of corner data and the chart in units of a length; infinite where there is no value.
[[nodiscard]] double deviation_from_chart(const SurfaceMesh& mesh, double size);

/// Adds channels with random values of all kinds: "t" and "n" (normals) at vertices, "c" and "w" (vectors) at corners; a tenth of
/// "c" has no value. An operand of every second number lacks "c".
[[nodiscard]] SurfaceMesh with_random_data(SurfaceMesh mesh, RandomSource& random, std::size_t number);

/// Faults of the data of a result that needed no repair, corner by corner in rationals: channels joined by name, values of the first
/// source face bit for bit at its corners and correctly rounded elsewhere, normals turned with their facets. One line each.
[[nodiscard]] std::string faults_of_data(std::span<const SurfaceMesh* const> operands, const BooleanResult& result);

/// The same of an imprint: of the whole, and of every operand for itself.
[[nodiscard]] std::string faults_of_data(std::span<const SurfaceMesh* const> operands, const ImprintResult& result);

/// Faults of labels: every facet has the name of its source face. One line each.
[[nodiscard]] std::string faults_of_groups(std::span<const SurfaceMesh* const> operands, const BooleanResult& result);

}  // namespace mortise::test
