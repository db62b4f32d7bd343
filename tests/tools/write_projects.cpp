// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Writes results for Gmsh to fill with tetrahedra, and says what has to arrive there, for scripts/check-formats.
// usage: write_projects OUT_FOLDER   (NAME.msh, NAME.geo, NAME.txt for each project)
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "mortise/brep/attributes.h"
#include "mortise/brep/model_mesh.h"
#include "mortise/io/files.h"
#include "mortise/io/gmsh_script.h"
#include "support/data.h"
#include "support/models.h"

using namespace mortise;
using namespace mortise::test;

namespace {

SurfaceMesh with_label(SurfaceMesh mesh, const std::string& label) {
  mesh.face_labels.assign(mesh.triangles.size(), 0);
  mesh.label_names = {label};
  return mesh;
}

std::string exact(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

/// The regions of the result are made of what the operands are called.
std::vector<Attribute> materials_of(const ResultModel& m, const std::vector<std::string>& names) {
  std::vector<std::vector<Attribute>> given;
  for (const std::string& name : names) {
    AttributePolicy policy;
    policy.on_merge = OnMerge::Error;
    given.push_back({{name, AttributeKind::Material, "null", {{EntityDimension::Region, 1}}, policy}});
  }
  std::vector<OperandAttributes> operands;
  for (std::size_t k = 0; k < given.size(); ++k) operands.push_back({given[k], &m.operand_models[k].brep});
  return transfer_attributes(m.lineage, operands);
}

/// A line for each region, "region VOLUME NAME", for each pair of regions with common faces, "pair AREA NAME|NAME", and for each name of
/// faces, "faces TRIANGLES AREA NAME".
std::string summary_of(const ModelView& view, const EntityMesh& mesh) {
  std::string text;
  const auto name_of_region = [&](const ModelRegionId region) {
    for (const MeshEntity& entity : mesh.entities[3]) {
      if (entity.tag == static_cast<std::int32_t>(region.value)) return spoken_name(mesh.names[entity.names.front()]);
    }
    return std::string();
  };
  for (const MeshEntity& region : mesh.entities[3]) {
    const ModelRegionId id(static_cast<std::uint32_t>(region.tag));
    text += "region " + exact(measure(view, {EntityDimension::Region, id.value})) + " " + name_of_region(id) + "\n";
  }
  for (std::uint32_t f = 0; f < view.model.brep.faces.size(); ++f) {
    const ModelFace& face = view.model.brep.faces[ModelFaceId(f)];
    const std::string behind = name_of_region(face.region_behind), in_front = name_of_region(face.region_in_front);
    if (behind.empty() || in_front.empty()) continue;
    text += "pair " + exact(measure(view, {EntityDimension::Face, f})) + " " + behind + "|" + in_front + "\n";
  }
  for (std::uint32_t n = 0; n < mesh.names.size(); ++n) {
    if (mesh.names[n].dimension != 2) continue;
    double area = 0;
    for (std::uint32_t f = 0; f < mesh.entities[2].size(); ++f) {
      for (const std::uint32_t name : mesh.entities[2][f].names) area += name == n ? measure(view, {EntityDimension::Face, f}) : 0;
    }
    text += "faces " + std::to_string(triangles_of_group(mesh, n).size()) + " " + exact(area) + " " + mesh.names[n].name + "\n";
  }
  return text;
}

void write_project(const std::string& stem, const std::string& name, const ResultModel& m, const std::vector<Attribute>& attributes) {
  const EntityMesh mesh = entity_mesh_of(m.result, attributes);
  const GmshProject project = write_gmsh_project(mesh, name + ".msh");
  write_file(stem + name + ".msh", project.mesh);
  write_file(stem + name + ".geo", project.script);
  write_file(stem + name + ".txt", summary_of(m.result, mesh));
}

void write_boxes(const std::string& folder) {
  const ResultModel m(Operation::Union,
                      {with_label(box({0, 0, 0}, {2, 2, 2}), "hull, outer"), with_label(box({1, 1, 1}, {3, 3, 3}), "tower")});
  write_project(folder, "boxes", m, materials_of(m, {"steel"}));
}

/// Two boxes that share a part of a face, a third inside the first.
void write_parts(const std::string& folder) {
  const ResultModel m(Operation::Partition, {with_label(box({0, 0, 0}, {3, 3, 3}), "block"), with_label(box({3, 1, 1}, {4, 2, 2}), "knob"),
                                             with_label(box({1, 1, 1}, {2, 2, 2}), "core")});
  write_project(folder, "parts", m, {});
}

/// Five solids of a heat exchange, air and metal, that fill a box and touch to within the last bits.
void write_exchanger(const std::string& folder) {
  const std::vector<std::string> names{"bottomAir", "leftSolid", "rightSolid", "topAir", "heater"};
  std::vector<SurfaceMesh> solids;
  for (const std::string& name : names) solids.push_back(read_data("cad/cht_" + name + ".stl"));
  BooleanOptions options;
  options.tolerance = 1e-12;
  const ResultModel m(Operation::Partition, solids, {}, options);
  std::vector<Attribute> attributes = materials_of(m, names);
  for (const Attribute& a : interface_attributes(m.result, m.lineage, [&](const OperandEntity& e) { return names[e.operand]; })) {
    attributes.push_back(a);
    std::erase_if(attributes.back().targets, [](const ModelEntity& e) { return e.dimension != EntityDimension::Face; });
  }
  write_project(folder, "exchanger", m, attributes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: write_projects OUT_FOLDER\n", stderr);
    return 2;
  }
  try {
    const std::string folder = std::string(argv[1]) + "/";
    write_boxes(folder);
    write_parts(folder);
    if (data_folder()) write_exchanger(folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_projects: %s\n", error.what());
    return 1;
  }
  return 0;
}
