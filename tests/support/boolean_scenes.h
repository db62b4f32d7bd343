// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Small solids written out by hand, and the scenes made of them that every boolean check runs over.
#pragma once

#include <string>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise::test {

/// Points and triangles as plain numbers.
[[nodiscard]] SurfaceMesh make_mesh(const std::vector<Vec3d>& points, const std::vector<std::array<std::size_t, 3>>& triangles);

/// An axis-aligned box of 12 triangles.
[[nodiscard]] SurfaceMesh box(const Vec3d& lo, const Vec3d& hi);
/// The same solid, every side split along its other diagonal.
[[nodiscard]] SurfaceMesh box_other_diagonals(const Vec3d& lo, const Vec3d& hi);
/// Four corners in any order; the result is oriented outwards.
[[nodiscard]] SurfaceMesh tetrahedron(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d);
/// A convex polygon, counterclockwise in (x, y), from z = low to z = high.
[[nodiscard]] SurfaceMesh prism(const std::vector<std::array<double, 2>>& polygon, double low, double high);
/// Six corners at `radius` from the centre along the axes, 8 faces.
[[nodiscard]] SurfaceMesh octahedron(const Vec3d& centre, double radius);

[[nodiscard]] SurfaceMesh joined(const std::vector<SurfaceMesh>& parts);
[[nodiscard]] SurfaceMesh inside_out(SurfaceMesh mesh);
/// Every triangle with corners of its own.
[[nodiscard]] SurfaceMesh soup_of(const SurfaceMesh& mesh);
[[nodiscard]] SurfaceMesh moved(SurfaceMesh mesh, const Vec3d& offset);
[[nodiscard]] SurfaceMesh scaled(SurfaceMesh mesh, double factor);
/// x to y, y to z, z to x: a rotation that is exact in doubles.
[[nodiscard]] SurfaceMesh with_axes_turned(SurfaceMesh mesh);
/// A quarter turn about the z axis, exact in doubles.
[[nodiscard]] SurfaceMesh quarter_turned(SurfaceMesh mesh);

[[nodiscard]] std::vector<const SurfaceMesh*> pointers_to(const std::vector<SurfaceMesh>& meshes);
[[nodiscard]] BooleanResult evaluate(Operation operation, const std::vector<SurfaceMesh>& operands);

/// Operands of winding 0 or 1, at most six of at most a few dozen triangles: the oracle knows their volumes.
struct Scene {
  std::string name;
  std::vector<SurfaceMesh> operands;
};

/// Contacts of every kind: generic, vertex, edge, face, coplanar, nested, apart, and several at once.
[[nodiscard]] std::vector<Scene> small_scenes();

}  // namespace mortise::test
