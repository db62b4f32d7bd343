// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Closedness, Euler characteristic and volume of a mesh, by plain code that shares nothing with the mesh folder.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "mortise/base/error.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise::test {

/// Does every directed edge occur as often as its reverse?
[[nodiscard]] bool is_balanced(const SurfaceMesh& mesh);

/// Vertices that faces use, less edges, plus faces.
[[nodiscard]] std::int64_t euler_characteristic(const SurfaceMesh& mesh);

/// Volume of the doubles, summed in rationals and rounded once.
[[nodiscard]] double exactly_summed_volume(const SurfaceMesh& mesh);

/// Do all faces and vertices agree, -0 and +0 told apart?
[[nodiscard]] bool has_same_bits(const SurfaceMesh& a, const SurfaceMesh& b);

/// The error a call throws; nothing when it throws none.
[[nodiscard]] std::optional<Error> error_of(const std::function<void()>& call);

}  // namespace mortise::test
