// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Shells joined through inside wedges, cavities located by rays.
#include "mortise/mesh/find_regions.h"

#include <algorithm>
#include <span>

#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/ray_crossing.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

struct FaceAtEdge {
  FaceId face;
  Vec3d apex;
  bool is_forward;
};

const Vec3d& position(const SurfaceMesh& mesh, FaceId f, std::size_t i) { return mesh.points[mesh.triangles[f.index()][i].index()]; }

FaceAtEdge face_at_edge(const SurfaceMesh& mesh, HalfEdge h, VertexId u) {
  const VertexId apex = origin_of(mesh, next_in_face(next_in_face(h)));
  return {face_of(h), mesh.points[apex.index()], origin_of(mesh, h) == u};
}

// Counterclockwise round u -> v, looking from v, beginning with the first.
void sort_round_edge(const Vec3d& u, const Vec3d& v, std::vector<FaceAtEdge>& around) {
  const Vec3d reference = around.front().apex;
  std::stable_sort(around.begin() + 1, around.end(), [&](const FaceAtEdge& a, const FaceAtEdge& b) {
    const Sign to_a = orient3d(u, v, reference, a.apex);
    const Sign to_b = orient3d(u, v, reference, b.apex);
    if (to_a != to_b) return to_a > to_b;
    return to_a != Sign::Zero && orient3d(u, v, a.apex, b.apex) == Sign::Positive;
  });
}

// Joins the two faces of every inside wedge at an edge.
void join_at_edge(const SurfaceMesh& mesh, const MeshTopology& topology, MeshEdgeId e, UnionFind& shells) {
  const auto uses = topology.uses_of(e);
  if (uses.size() == 2) return shells.join(face_of(uses[0]).value, face_of(uses[1]).value);
  const auto [u, v] = topology.edges[e.index()];
  std::vector<FaceAtEdge> around;
  for (const HalfEdge h : uses) around.push_back(face_at_edge(mesh, h, u));
  sort_round_edge(mesh.points[u.index()], mesh.points[v.index()], around);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const FaceAtEdge& next = around[(i + 1) % around.size()];
    if (!around[i].is_forward && next.is_forward) shells.join(around[i].face.value, next.face.value);
  }
}

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
  const MeshTopology topology = build_topology(mesh);
  UnionFind joined(mesh.triangles.size());
  for (std::size_t e = 0; e < topology.edges.size(); ++e) join_at_edge(mesh, topology, MeshEdgeId(e), joined);
  const FaceComponents components = number_components(joined);
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
