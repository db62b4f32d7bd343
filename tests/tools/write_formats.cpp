// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Writes a labelled partition of two boxes in every format of analysis programs and as GLB, and says what a file holds, for
// scripts/check-formats.
// usage: write_formats OUT_FOLDER | write_formats --read FILE   (both print counts, areas and names of groups)
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/io/files.h"
#include "mortise/io/formats.h"
#include "mortise/mesh/corner_data.h"
#include "mortise/mesh/shapes.h"

using namespace mortise;

namespace {

constexpr std::array analysis_formats{Format::Msh41, Format::Msh22,  Format::Vtk,    Format::Vtu,
                                      Format::Medit, Format::Abaqus, Format::Nastran};

SurfaceMesh labelled_box(double lo, double hi, const std::string& label) {
  SurfaceMesh box = make_box({lo / 3, lo / 3, lo / 3}, {hi / 3, hi / 3, hi / 3});
  box.face_labels.assign(box.triangles.size(), 0);
  box.label_names = {label};
  return box;
}

/// Faces by label and regions on both sides.
using FaceKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

void add_faces(const BooleanResult& result, const ResultRegions& regions, EntityMesh& mesh) {
  std::vector<FaceKey> keys;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    keys.emplace_back(result.mesh.face_labels[i], regions.region_of_facet[i], regions.region_in_front[i]);
  }
  std::map<FaceKey, std::uint32_t> face_of;
  for (const FaceKey& key : keys) face_of.emplace(key, 0);
  for (auto& [key, face] : face_of) {
    const auto& [label, behind, in_front] = key;
    face = static_cast<std::uint32_t>(mesh.entities[2].size());
    const auto tag = static_cast<std::int32_t>(face + 10);
    mesh.entities[2].push_back({tag, {label}, {}});
    if (behind != ResultRegions::none) mesh.entities[3][behind].boundary.push_back(tag);
    if (in_front != ResultRegions::none) mesh.entities[3][in_front].boundary.push_back(-tag);
  }
  for (const FaceKey& key : keys) mesh.triangle_entities.push_back(face_of.at(key));
}

/// Lines where faces meet, as one edge.
void add_seams(EntityMesh& mesh) {
  std::map<std::array<VertexId, 2>, std::set<std::uint32_t>> faces_of;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3];
      faces_of[{std::min(a, b), std::max(a, b)}].insert(mesh.triangle_entities[i]);
    }
  }
  for (const auto& [edge, faces] : faces_of) {
    if (faces.size() > 1) mesh.lines.push_back(edge);
  }
  mesh.line_entities.assign(mesh.lines.size(), 0);
  mesh.entities[1] = {{5, {2}, {}}};
}

EntityMesh make_partition() {
  const BooleanResult result = partition({labelled_box(0, 2, "steel skin")}, {labelled_box(1, 3, "air: skin, outer")});
  const ResultRegions regions = find_result_regions(result);
  EntityMesh mesh;
  mesh.points = result.mesh.points;
  mesh.triangles = result.mesh.triangles;
  for (const std::string& label : result.mesh.label_names)
    mesh.names.push_back({2, static_cast<std::int32_t>(mesh.names.size() + 1), label});
  mesh.names.push_back({1, 1, "seams"});
  mesh.names.push_back({0, 1, "fix"});
  for (std::size_t region = 0; region < regions.regions.size(); ++region) {
    const auto tag = static_cast<std::int32_t>(region + 1);
    mesh.entities[3].push_back({tag, {static_cast<std::uint32_t>(mesh.names.size())}, {}});
    mesh.names.push_back({3, tag, "region " + std::to_string(tag)});
  }
  add_faces(result, regions, mesh);
  add_seams(mesh);
  mesh.point_elements = {VertexId(0)};
  mesh.point_entities = {0};
  mesh.entities[0] = {{1, {3}, {}}};
  return mesh;
}

double area_of(const EntityMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  double area = 0;
  for (const std::uint32_t i : triangles) {
    const Vec3d& a = mesh.points[mesh.triangles[i][0].index()];
    const Vec3d n = cross(mesh.points[mesh.triangles[i][1].index()] - a, mesh.points[mesh.triangles[i][2].index()] - a);
    area += std::sqrt(dot(n, n)) / 2;
  }
  return area;
}

void print_summary(const EntityMesh& mesh) {
  std::printf("points %zu\nlines %zu\ntriangles %zu\n", mesh.points.size(), mesh.lines.size(), mesh.triangles.size());
  for (std::uint32_t name = 0; name < mesh.names.size(); ++name) {
    const PhysicalName& group = mesh.names[name];
    if (group.dimension == 3) continue;
    if (group.dimension == 2) {
      const std::vector<std::uint32_t> triangles = triangles_of_group(mesh, name);
      std::printf("group 2 %zu %.12f %s\n", triangles.size(), area_of(mesh, triangles), group.name.c_str());
    } else {
      std::printf("group %d %zu 0 %s\n", int{group.dimension}, nodes_of_group(mesh, name).size(), group.name.c_str());
    }
  }
}

/// A cube with all the data a GLB file keeps: texture coordinates and colours that part its sides, normals.
SurfaceMesh painted_cube() {
  SurfaceMesh cube = labelled_box(0, 3, "cube");
  DataChannel uv{"uv", 2, DataKind::Value, {}}, color{"color", 3, DataKind::Value, {}}, normal{"normal", 3, DataKind::Normal, {}};
  for (std::size_t face = 0; face < cube.triangles.size(); ++face) {
    const auto side = static_cast<double>(face / 2);
    for (std::size_t k = 0; k < 3; ++k) {
      uv.values.insert(uv.values.end(), {side / 8, 0.25});
      color.values.insert(color.values.end(), {side / 8, 0.5, 1});
      normal.values.insert(normal.values.end(), 3, no_value);  // that of the triangle
    }
  }
  cube.corner_data = {uv, color, normal};
  return cube;
}

void write_all(const std::string& folder) {
  const EntityMesh mesh = make_partition();
  for (const Format format : analysis_formats) {
    const std::string name(format_name(format));
    write_file(folder + "/boxes-" + name + "." + (format == Format::Msh22 ? "msh" : name), write_entity_mesh(mesh, format));
  }
  write_file(folder + "/boxes.glb", write_entity_mesh(mesh, Format::Glb));
  write_mesh_file(folder + "/painted.glb", painted_cube());
  print_summary(mesh);
}

void read_one(const std::string& path) { print_summary(read_entity_mesh(read_file(path), path)); }

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 2) {
      write_all(argv[1]);
    } else if (argc == 3 && std::string(argv[1]) == "--read") {
      read_one(argv[2]);
    } else {
      std::fputs("usage: write_formats OUT_FOLDER | write_formats --read FILE\n", stderr);
      return 2;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_formats: %s\n", error.what());
    return 1;
  }
  return 0;
}
