// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Generated shapes. Solids are closed and oriented outwards, with shared vertices; the same bits on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A point (x, y) of an outline, or (radius, z) of a profile.
using Vec2d = std::array<double, 2>;

// All of them throw Error{InvalidArgument} for counts that are too small, sizes that are not positive and finite,
// and meshes of more than 2^31 vertices or triangles.

/// The box between two corners, lo < hi: 8 vertices, 12 triangles.
[[nodiscard]] SurfaceMesh make_box(const Vec3d& lo, const Vec3d& hi);

/// A sphere about the origin of `around` >= 3 meridians and `rings` >= 2 bands from pole to pole:
/// around (rings - 1) + 2 vertices, 2 around (rings - 1) triangles.
[[nodiscard]] SurfaceMesh make_sphere(double radius, std::uint32_t around, std::uint32_t rings);

/// An icosahedron about the origin with every triangle cut in four `levels` <= 12 times: 10 4^levels + 2 vertices,
/// 20 4^levels triangles.
[[nodiscard]] SurfaceMesh make_icosphere(double radius, std::uint32_t levels);

/// A cylinder standing on z = 0, `around` >= 3: 2 around + 2 vertices, 4 around triangles.
[[nodiscard]] SurfaceMesh make_cylinder(double radius, double height, std::uint32_t around);

/// A cone standing on z = 0, its tip on the z axis, `around` >= 3: around + 2 vertices, 2 around triangles.
[[nodiscard]] SurfaceMesh make_cone(double radius, double height, std::uint32_t around);

/// A torus about the z axis, minor radius < major radius, `around` >= 3 sections of `across` >= 3 points:
/// around across vertices, 2 around across triangles.
[[nodiscard]] SurfaceMesh make_torus(double major_radius, double minor_radius, std::uint32_t around, std::uint32_t across);

/// An open rectangle from (0, 0) to (width, depth) in z = 0, facing up, of cells_x times cells_y cells:
/// (cells_x + 1) (cells_y + 1) vertices, 2 cells_x cells_y triangles.
[[nodiscard]] SurfaceMesh make_grid_sheet(double width, double depth, std::uint32_t cells_x, std::uint32_t cells_y);

/// The prism from z = 0 to `height` over a simple polygon of n >= 3 corners, concave or not, turning either way:
/// 2 n vertices (bottom, then top), 4 n - 4 triangles.
[[nodiscard]] SurfaceMesh extrude(std::span<const Vec2d> outline, double height);

/// The solid a simple polygon of n >= 3 corners (radius, z), radius >= 0, sweeps in a full turn about the z axis in
/// `around` >= 3 steps. With m corners on the axis and s sides along it: around (n - m) + m vertices (fewer where a corner
/// lies between two sides along the axis: it is left out); a side gives 2 around triangles, around where one end is on the
/// axis, none along it. A corner that touches the axis alone gives a pinch.
[[nodiscard]] SurfaceMesh revolve(std::span<const Vec2d> profile, std::uint32_t around);

}  // namespace mortise
