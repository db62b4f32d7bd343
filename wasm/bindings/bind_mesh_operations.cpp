// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Operations on one mesh: parts, repair, solids of sheets, sections.
#include <emscripten/bind.h>

#include <string>
#include <vector>

#include "arrays.h"
#include "border.h"
#include "mortise/mesh/corners_to_vertices.h"
#include "mortise/mesh/extrude_to.h"
#include "mortise/mesh/group_by_label.h"
#include "mortise/mesh/repair.h"
#include "mortise/mesh/slice.h"
#include "mortise/mesh/split_parts.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/weld.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

val part_out(const MeshPart& part) {
  val object = mesh_out(part.mesh);
  object.set("sourceFace", ids_out(part.source_face));
  object.set("sourceVertex", ids_out(part.source_vertex));
  return object;
}

val split_mesh(const val& mesh, const std::string& by) {
  return answer([&] {
    val parts = val::array();
    for (const MeshPart& part : split_parts(mesh_in(mesh), by == "regions" ? SplitBy::Regions : SplitBy::Components)) {
      parts.call<void>("push", part_out(part));
    }
    return parts;
  });
}

val split_mesh_pinches(const val& mesh) {
  return answer([&] {
    const WeldedMesh welded = weld(mesh_in(mesh));
    SplitPinches split = split_pinches(welded.mesh, build_topology(welded.mesh));
    for (VertexId& v : split.source) v = welded.old_vertex[v.index()];
    val object = mesh_out(split.mesh);
    object.set("sourceVertex", ids_out(split.source));
    object.set("shell", copy_out(split.shells.component_of));
    return object;
  });
}

/// @param names  array of the steps asked for
RepairSteps steps_in(const val& names) {
  const auto asks_for = [&](RepairStep step) { return names.call<bool>("includes", std::string(repair_step_name(step))); };
  RepairSteps steps;
  steps.drop_degenerate = asks_for(RepairStep::DropDegenerate);
  steps.drop_duplicates = asks_for(RepairStep::DropDuplicates);
  steps.cancel_opposites = asks_for(RepairStep::CancelOpposites);
  steps.orient = asks_for(RepairStep::Orient);
  steps.flip_inside_out = asks_for(RepairStep::FlipInsideOut);
  steps.fill_planar_holes = asks_for(RepairStep::FillPlanarHoles);
  return steps;
}

val note_out(const RepairNote& note) {
  val object = val::object();
  object.set("step", std::string(repair_step_name(note.step)));
  object.set("outcome", std::string(repair_outcome_name(note.outcome)));
  object.set("count", static_cast<double>(note.count));
  object.set("faces", ids_out(note.faces));
  return object;
}

val repair_mesh(const val& mesh, const val& names) {
  return answer([&] {
    const RepairedMesh repaired = repair(mesh_in(mesh), steps_in(names));
    val done = val::array();
    for (const RepairNote& note : repaired.done) done.call<void>("push", note_out(note));
    val object = val::object();
    object.set("mesh", mesh_out(repaired.mesh));
    object.set("done", done);
    object.set("sourceFace", copy_out(repaired.source_face));
    object.set("sourceVertex", ids_out(repaired.source_vertex));
    return object;
  });
}

val extrude_mesh_to(const val& mesh, double z) {
  return answer([&] { return mesh_out(extrude_to(mesh_in(mesh), z)); });
}

/// @param numbers  of the plane: normal and offset
val slice_mesh(const val& mesh, const val& numbers) {
  return answer([&] {
    const Section section = slice(mesh_in(mesh), plane_in(numbers));
    val polygons = val::array();
    for (const std::vector<Vec3d>& polygon : section.polygons) polygons.call<void>("push", points_out(polygon));
    val object = val::object();
    object.set("polygons", polygons);
    object.set("areas", copy_out(section.areas));
    object.set("area", section.area);
    return object;
  });
}

val make_corners_vertices(const val& mesh, double missing) {
  return answer([&] {
    const MeshOfVertices result = corners_to_vertices(mesh_in(mesh), missing);
    val object = mesh_out(result.mesh);
    object.set("sourceVertex", ids_out(result.source_vertex));
    return object;
  });
}

/// Groups count in indices of `triangles`, as renderers do.
val group_mesh_by_label(const val& mesh) {
  return answer([&] {
    const GroupedMesh grouped = group_by_label(mesh_in(mesh));
    val groups = val::array();
    for (const FaceGroup& g : grouped.groups) {
      val group = val::object();
      group.set("start", 3.0 * g.first);
      group.set("count", 3.0 * g.count);
      group.set("materialIndex", g.label);
      groups.call<void>("push", group);
    }
    val object = part_out(grouped.part);
    object.set("groups", groups);
    return object;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mortise_mesh_operations) {
  emscripten::function("splitMesh", &split_mesh);
  emscripten::function("splitPinches", &split_mesh_pinches);
  emscripten::function("repairMesh", &repair_mesh);
  emscripten::function("extrudeTo", &extrude_mesh_to);
  emscripten::function("sliceMesh", &slice_mesh);
  emscripten::function("cornersToVertices", &make_corners_vertices);
  emscripten::function("groupByLabel", &group_mesh_by_label);
}

}  // namespace mortise::wasm
