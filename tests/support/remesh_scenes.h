// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes with their models, to be remeshed, and what is asked of the result by code the remesher has no part in.
#pragma once

#include <array>
#include <vector>

#include "mortise/brep/build_brep.h"
#include "mortise/remesh/deviation.h"
#include "mortise/remesh/quality_report.h"
#include "mortise/remesh/remesh.h"
#include "support/boolean_scenes.h"

namespace mortise::test {

/// A mesh, the normals its model was made with, and the model, without seams.
struct ModelScene {
  SurfaceMesh mesh;
  FaceNormals normals;
  ClassifiedBrep model;
};

[[nodiscard]] BrepRules without_seams(double edge_angle_deg = 45);

[[nodiscard]] ModelScene scene_of(SurfaceMesh mesh, FaceNormals normals, const BrepRules& rules = without_seams());
[[nodiscard]] ModelScene scene_of(const SurfaceMesh& mesh, const BrepRules& rules = without_seams());
/// With the normals of the triangles of the operands.
[[nodiscard]] ModelScene scene_of(const BooleanResult& result, const std::vector<SurfaceMesh>& operands,
                                  const BrepRules& rules = without_seams());
[[nodiscard]] ModelScene scene_of(Operation operation, const std::vector<SurfaceMesh>& operands, const BrepRules& rules = without_seams());

/// Two cylinders of radius 1 and 0.6 and length 4 that cross, the axes a little apart, with facets as long as they are.
[[nodiscard]] std::vector<SurfaceMesh> crossing_cylinders(std::uint32_t around);

/// A ball, a ring through its side and a sheet with a corner that goes through both and ends outside (Fig. 26).
[[nodiscard]] std::vector<SurfaceMesh> ball_ring_and_corner_sheet();
inline constexpr Vec3d ring_centre{0.7, 0.1, 0.3};
inline constexpr double corner_of_sheet = 0.05;  ///< y and z of the line where its floor and its wall meet

/// A turret on a round base with a barrel, standing on z = 0 (Fig. 28).
[[nodiscard]] SurfaceMesh gun();

/// A cylinder of 64 sides through a plate.
struct Drilling {
  Vec3d centre;
  double radius = 0;
};
inline constexpr std::uint32_t sides_of_drill = 64;
inline constexpr std::array<Drilling, 3> drillings{{{{0.8, 0.8, 0}, 0.5}, {{2.2, 1.9, 0}, 0.3}, {{3.2, 0.9, 0}, 0.6}}};

/// A plate [0, 4] x [0, 3] x [0, 1] of twelve triangles and the drills through it (Fig. 27).
[[nodiscard]] std::vector<SurfaceMesh> plate_and_drills();
/// Every side of a hole asks for its own length.
[[nodiscard]] std::vector<SizeSource> sources_at_rims(double growth);

/// The given model with the mesh of the result.
[[nodiscard]] ClassifiedBrep model_after(const ModelScene& scene, const RemeshResult& result);
/// How far the result is from the mesh it came from, faces and model edges by number.
[[nodiscard]] Deviation deviation_after(const ModelScene& scene, const RemeshResult& result, const SizingProxy& sizes);

/// From each triangle to each neighbour across an edge of two, by the edges of equilateral triangles as large; ascending, at least 1.
[[nodiscard]] std::vector<double> growths_of(const SurfaceMesh& mesh);

/// The triangles of one model face.
[[nodiscard]] SurfaceMesh part_of(const RemeshResult& result, ModelFaceId face);

/// How many of the triangles marked with 0 are not in the other mesh bit for bit, from the same or another corner on.
[[nodiscard]] std::size_t count_lost(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& marks, const SurfaceMesh& other);

/// The triangles of the other mesh without a corner where a triangle marked with 0 has one.
[[nodiscard]] SurfaceMesh part_away_from(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& marks, const SurfaceMesh& other);

/// Pairs of triangles that cross or overlap, by an oracle.
[[nodiscard]] std::size_t count_crossings(const SurfaceMesh& mesh);

}  // namespace mortise::test
