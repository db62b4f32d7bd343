// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Shells with pinches split, cavities located by rays.
#include "mortise/mesh/find_regions.h"

#include <algorithm>

#include "mortise/geom/box_tree.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/ray_crossing.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

const Vec3d& position(const SurfaceMesh& mesh, FaceId f, std::size_t i) { return mesh.points[mesh.triangles[f.index()][i].index()]; }

struct Shell {
  std::vector<FaceId> faces;
  double volume = 0, area = 0;
};

void measure(const SurfaceMesh& mesh, Shell& shell) {
  SurfaceMesh part;
  for (const FaceId f : shell.faces) {
    Triangle t;
    for (std::size_t i = 0; i < 3; ++i) {
      t[i] = VertexId(part.points.size());
      part.points.push_back(position(mesh, f, i));
    }
    part.triangles.push_back(t);
  }
  shell.volume = enclosed_volume(part);
  shell.area = surface_area(part);
}

std::vector<Shell> find_shells(const SurfaceMesh& mesh, std::vector<std::uint32_t>& shell_of_face) {
  const FaceComponents components = split_pinches(mesh, build_topology(mesh)).shells;  // joined through inside wedges
  shell_of_face = components.component_of;
  std::vector<Shell> shells(components.count);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) shells[shell_of_face[f]].faces.push_back(FaceId(f));
  for (Shell& shell : shells) measure(mesh, shell);
  return shells;
}

// The smallest body round a cavity: bodies that contain it contain one another.
std::uint32_t find_body(const SurfaceMesh& mesh, const BoxTree& tree, const std::vector<Shell>& shells,
                        const std::vector<std::uint32_t>& shell_of_face, std::uint32_t cavity) {
  const FaceId first = shells[cavity].faces.front();
  const RayStart start{position(mesh, first, 0), position(mesh, first, 1), position(mesh, first, 2)};
  std::vector<int> winding(shells.size(), 0);
  tree.for_each_meeting(ray_box(start), [&](std::uint32_t f) {
    const std::uint32_t shell = shell_of_face[f];
    if (shell == cavity || shells[shell].volume <= 0) return;
    winding[shell] += winding_step(position(mesh, FaceId(f), 0), position(mesh, FaceId(f), 1), position(mesh, FaceId(f), 2), start);
  });
  std::uint32_t body = cavity;
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    if (winding[s] > 0 && (body == cavity || shells[s].volume < shells[body].volume)) body = s;
  }
  return body;
}

BoxTree face_tree(const SurfaceMesh& mesh) {
  std::vector<Box3> boxes;
  boxes.reserve(mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    Box3 box;
    for (std::size_t i = 0; i < 3; ++i) box.extend(position(mesh, FaceId(f), i));
    boxes.push_back(box);
  }
  return BoxTree(boxes);
}

// The shell that stands for the body of each shell.
std::vector<std::uint32_t> find_bodies(const SurfaceMesh& mesh, const std::vector<Shell>& shells,
                                       const std::vector<std::uint32_t>& shell_of_face) {
  std::vector<std::uint32_t> body(shells.size());
  const bool has_cavity = std::any_of(shells.begin(), shells.end(), [](const Shell& s) { return s.volume <= 0; });
  const BoxTree tree = has_cavity ? face_tree(mesh) : BoxTree();
  for (std::uint32_t s = 0; s < shells.size(); ++s) body[s] = shells[s].volume > 0 ? s : find_body(mesh, tree, shells, shell_of_face, s);
  return body;
}

}  // namespace

MeshRegions find_regions(const SurfaceMesh& mesh) {
  std::vector<std::uint32_t> shell_of_face;
  const std::vector<Shell> shells = find_shells(mesh, shell_of_face);
  const std::vector<std::uint32_t> body = find_bodies(mesh, shells, shell_of_face);
  std::vector<std::uint32_t> number(shells.size(), 0xffffffffU);
  MeshRegions result;
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    std::uint32_t& region = number[body[s]];
    if (region == 0xffffffffU) {
      region = static_cast<std::uint32_t>(result.regions.size());
      result.regions.emplace_back();
    }
    result.regions[region].volume += shells[s].volume;
    result.regions[region].area += shells[s].area;
  }
  for (const std::uint32_t s : shell_of_face) result.region_of_face.push_back(number[body[s]]);
  return result;
}

}  // namespace mortise
