// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Where vertices of a result lie exactly, said by the doubles of operands.
#pragma once

#include <span>
#include <vector>

#include "mortise/boolean/result.h"
#include "mortise/exact/point_set.h"

namespace mortise {

/// The exact places of the corners of some faces.
/// @param point_of_vertex  per vertex of the mesh, in `points`
[[nodiscard]] ExactPlaces exact_places(const SurfaceMesh& mesh, std::span<const std::uint32_t> faces, const PointSet& points,
                                       std::span<const PointId> point_of_vertex);

/// The places of the vertices that stay, by their new numbers.
/// @param is_kept  per vertex there was
[[nodiscard]] ExactPlaces renumbered(const ExactPlaces& places, std::span<const std::uint8_t> is_kept);

}  // namespace mortise
