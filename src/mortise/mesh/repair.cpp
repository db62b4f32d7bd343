// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The order of the steps, and what they share.
#include "mortise/mesh/repair.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mortise/mesh/face_marks.h"
#include "mortise/mesh/repair_steps.h"
#include "mortise/mesh/select_faces.h"
#include "mortise/mesh/validate.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

MeshInRepair begin_repair(const SurfaceMesh& welded) {
  MeshInRepair repair;
  repair.mesh = welded;
  repair.source.resize(welded.triangles.size());
  std::iota(repair.source.begin(), repair.source.end(), 0U);
  return repair;
}

/// The mesh without the vertices no face uses.
RepairedMesh end_repair(MeshInRepair repair, const std::vector<VertexId>& old_vertex) {
  std::vector<FaceId> all;
  for (std::size_t f = 0; f < repair.mesh.triangles.size(); ++f) all.push_back(FaceId(f));
  MeshPart part = select_faces(repair.mesh, all);
  for (VertexId& v : part.source_vertex) v = old_vertex[v.index()];
  return {std::move(part.mesh), std::move(repair.source), std::move(part.source_vertex), std::move(repair.done)};
}

}  // namespace

std::string_view repair_step_name(RepairStep step) {
  switch (step) {
    case RepairStep::DropDegenerate:
      return "dropDegenerate";
    case RepairStep::DropDuplicates:
      return "dropDuplicates";
    case RepairStep::CancelOpposites:
      return "cancelOpposites";
    case RepairStep::Orient:
      return "orient";
    case RepairStep::FlipInsideOut:
      return "flipInsideOut";
    default:
      return "fillPlanarHoles";
  }
}

std::string_view repair_outcome_name(RepairOutcome outcome) {
  switch (outcome) {
    case RepairOutcome::Done:
      return "done";
    case RepairOutcome::NotOrientable:
      return "notOrientable";
    case RepairOutcome::NotPlanar:
      return "notPlanar";
    case RepairOutcome::NotSimple:
      return "notSimple";
    default:
      return "wouldOverlap";
  }
}

void keep_faces(MeshInRepair& repair, const std::vector<bool>& is_kept) {
  SurfaceMesh& mesh = repair.mesh;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (!is_kept[f]) continue;
    mesh.triangles[kept] = mesh.triangles[f];
    repair.source[kept] = repair.source[f];
    copy_face_marks(FaceId(f), FaceId(kept), mesh);
    ++kept;
  }
  mesh.triangles.resize(kept);
  repair.source.resize(kept);
  resize_face_marks(mesh);
}

void add_note(MeshInRepair& repair, RepairStep step, RepairOutcome outcome, std::uint64_t count, const std::vector<FaceId>& faces) {
  if (count == 0) return;
  RepairNote note{step, outcome, count, {}};
  for (const FaceId f : faces) {
    if (repair.source[f.index()] != RepairedMesh::none) note.faces.push_back(FaceId(repair.source[f.index()]));
  }
  std::sort(note.faces.begin(), note.faces.end());
  note.faces.erase(std::unique(note.faces.begin(), note.faces.end()), note.faces.end());
  repair.done.push_back(std::move(note));
}

RepairedMesh repair(const SurfaceMesh& mesh, const RepairSteps& steps) {
  validate(mesh);
  const WeldedMesh welded = weld(mesh);
  MeshInRepair state = begin_repair(welded.mesh);
  if (steps.drop_degenerate) drop_degenerate_faces(state);
  if (steps.drop_duplicates) drop_duplicate_faces(state);
  if (steps.cancel_opposites) cancel_opposite_faces(state);
  if (steps.orient) orient_faces(state);
  if (steps.flip_inside_out) flip_inside_out_shells(state);
  if (steps.fill_planar_holes) fill_planar_holes(state);
  return end_repair(std::move(state), welded.old_vertex);
}

}  // namespace mortise
