// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The steps of a repair; each adds a note when it did something or could not.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/mesh/repair.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A welded mesh while it is mended.
struct MeshInRepair {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> source;  ///< per face: face as given, or RepairedMesh::none
  std::vector<RepairNote> done;
};

/// Removes the faces that are not to be kept.
void keep_faces(MeshInRepair& repair, const std::vector<bool>& is_kept);
/// Adds a note about faces of the mesh as it is now, unless the count is zero.
void add_note(MeshInRepair& repair, RepairStep step, RepairOutcome outcome, std::uint64_t count, const std::vector<FaceId>& faces);

void drop_degenerate_faces(MeshInRepair& repair);
void drop_duplicate_faces(MeshInRepair& repair);
void cancel_opposite_faces(MeshInRepair& repair);
void orient_faces(MeshInRepair& repair);
void flip_inside_out_shells(MeshInRepair& repair);
void fill_planar_holes(MeshInRepair& repair);

}  // namespace mortise
