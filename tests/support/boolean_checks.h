// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What must hold for every result of a boolean, checked by code that shares nothing with the pipeline.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "support/boolean_oracle.h"

namespace mortise::test {

/// Measures of a closed mesh. Volume is exact before it is rounded; genus and shells are for results without pinched edges.
struct Shape {
  double volume = 0;
  double area = 0;
  std::size_t triangles = 0;
  std::size_t pinched_edges = 0;  ///< edges with more than two faces
  std::size_t shells = 0;         ///< pieces joined through edges of two faces
  long genus = 0;                 ///< sum over the shells, pinched vertices split
};

[[nodiscard]] Shape shape_of(const SurfaceMesh& mesh);

/// Volume of the doubles, summed exactly and rounded once.
[[nodiscard]] double exact_volume(const SurfaceMesh& mesh);

/// Faults of the arrays themselves: sizes, indices, balanced edges, equal or unused vertices, faces without area or given
/// twice, certificate. One line each; empty when right.
[[nodiscard]] std::string faults_of_mesh(const BooleanResult& result);

/// May the repair of rounded results have merged vertices and swapped diagonals? Then a vertex may stand for several made
/// points, and a facet may reach over the border of its source face by 2^-44 of the size of the scene.
enum class Repairs { None, Allowed };

/// Faults of the provenance, checked in rationals: every vertex is its source vertex bit for bit or the correctly rounded
/// point its faces determine, every facet lies in all its source faces and runs as `flipped` says.
[[nodiscard]] std::string faults_of_provenance(std::span<const SurfaceMesh* const> operands, const BooleanResult& result, Repairs repairs);

/// The exact positions of the vertices before they were rounded, as the provenance determines them.
[[nodiscard]] std::vector<oracle::RationalPoint> exact_positions(std::span<const SurfaceMesh* const> operands, const BooleanResult& result);

/// Both of the above.
[[nodiscard]] std::string faults_of(std::span<const SurfaceMesh* const> operands, const BooleanResult& result,
                                    Repairs repairs = Repairs::None);

/// The positions of a mesh, sorted: equal for equal point sets.
[[nodiscard]] std::vector<std::array<double, 3>> sorted_points(const SurfaceMesh& mesh);

/// 1e-12 (V(A) + V(B)) + 4 d area: how far a volume identity may be off after rounding.
[[nodiscard]] double identity_tolerance(double volumes, double area, const BooleanReport& report, double largest_coordinate);

/// The largest absolute value of a coordinate used by a triangle.
[[nodiscard]] double largest_coordinate(const SurfaceMesh& mesh);

}  // namespace mortise::test
