// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How good the triangles of a mesh on a model are: angles, shapes, edges against the size wanted, valences, growth. No code of the
// remesher it judges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/remesh/free_triangles.h"
#include "mortise/size/sizing_proxy.h"

namespace mortise {

/// Of a set of triangles; zeros when it is empty.
struct TriangleMarks {
  std::size_t count = 0;
  double least_angle_deg = 0, greatest_angle_deg = 0;
  double permille_angle_deg = 0, percent_angle_deg = 0, median_angle_deg = 0;  ///< so many triangles have a smaller smallest angle
  std::size_t below_30 = 0, above_115 = 0;                                     ///< triangles with such an angle
  double least_radius_ratio = 0, mean_radius_ratio = 0;                        ///< 2 r / R: 1 for an equilateral triangle
  double greatest_edge_ratio = 0, mean_edge_ratio = 0;                         ///< longest to shortest; infinite for one of length 0
  double greatest_growth = 0;  ///< from the edge of an equilateral triangle of the same area to that of a neighbour of the set
};

/// Limits between the bins of LengthMarks; the first has no lower, the last no upper one.
inline constexpr std::array<double, 8> length_limits{0.5, 0.7071067811865476, 0.8, 0.9, 1.1, 1.25, 1.4142135623730951, 2};

/// Of a set of edges, in units of the size wanted: the integral of 1 / h along them, by Simpson's rule with the size at the middle.
struct LengthMarks {
  std::size_t count = 0;
  double least = 0, greatest = 0, mean = 0;
  double in_band = 0;                                        ///< the part of them in 1 / sqrt 2 .. sqrt 2
  std::array<std::size_t, length_limits.size() + 1> bins{};  ///< an edge as long as a limit is above it
  double greatest_growth = 0;                                ///< from one to the next of the set along a model edge
};

struct QualityReport {
  TriangleMarks all, free;
  LengthMarks edges, free_edges;           ///< free: of a free triangle
  Obstacles obstacles;                     ///< that keep triangles from being free
  std::array<std::size_t, 13> valences{};  ///< vertices inside faces by the number of their edges; the last: as many or more
  std::size_t folds = 0;                   ///< edges inside faces where the normal turns by more than 90 degrees
};

/// Angles are to a few units in the last place, the same bits on every machine.
///
/// @param frozen_edges  as in find_free_triangles
/// @throws Error{InvalidArgument} when the model is not that of the mesh, or there are not as many marks as edges
/// O(n log n) with as many questions for sizes as there are vertices and edges.
[[nodiscard]] QualityReport measure_quality(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SizingProxy& sizes,
                                            const std::vector<std::uint8_t>& frozen_edges = {});

}  // namespace mortise
