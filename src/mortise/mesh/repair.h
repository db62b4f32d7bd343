// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Mends meshes, only as asked, and says what it did. Every decision is exact.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// What to do, in this order. Nothing is done unless asked.
struct RepairSteps {
  bool drop_degenerate = false;    ///< faces without area; the neighbour across the longest side takes the middle corner up
  bool drop_duplicates = false;    ///< faces that run round the same vertices the same way as an earlier one
  bool cancel_opposites = false;   ///< pairs of faces that run round the same vertices opposite ways
  bool orient = false;             ///< faces joined by edges of two faces run as most of them do
  bool flip_inside_out = false;    ///< closed shells that make the winding behind them negative, with all that lies in them
  bool fill_planar_holes = false;  ///< simple boundary loops that lie in one plane exactly
};

enum class RepairStep : std::uint8_t { DropDegenerate, DropDuplicates, CancelOpposites, Orient, FlipInsideOut, FillPlanarHoles };

enum class RepairOutcome : std::uint8_t {
  Done,
  NotOrientable,  ///< one-sided, as a Moebius strip: left as it is
  NotPlanar,      ///< a hole whose corners lie in no plane: left open
  NotSimple,      ///< a hole whose boundary meets itself, runs in both ways, or lies in or round another one: left open
  WouldOverlap,   ///< a hole whose filling would lie on the faces next to it, as round a flat sheet: left open
};

/// "dropDegenerate", ...
[[nodiscard]] std::string_view repair_step_name(RepairStep step);
/// "done", "notOrientable", ...
[[nodiscard]] std::string_view repair_outcome_name(RepairOutcome outcome);

struct RepairNote {
  RepairStep step = RepairStep::DropDegenerate;
  RepairOutcome outcome = RepairOutcome::Done;
  std::uint64_t count = 0;    ///< faces; surfaces that are not orientable; holes
  std::vector<FaceId> faces;  ///< of the mesh as given, ascending: the faces themselves, or those round the holes
};

struct RepairedMesh {
  SurfaceMesh mesh;                        ///< equal positions welded; vertices without faces left out; data at corners, none of fillings
  std::vector<std::uint32_t> source_face;  ///< per face: the one it is or is a part of; none for a filling
  std::vector<VertexId> source_vertex;     ///< per vertex: the lowest one at its position
  std::vector<RepairNote> done;            ///< in the order of the steps; a step that found nothing to do is not in it
  static constexpr std::uint32_t none = 0xffffffffU;
};

/// The mesh after the steps asked for. What cannot be mended is said in a note and stays as it is.
/// @throws what validate() throws
/// O(n log n) in faces, plus rays for closed shells and the triangulation of fillings.
[[nodiscard]] RepairedMesh repair(const SurfaceMesh& mesh, const RepairSteps& steps);

}  // namespace mortise
