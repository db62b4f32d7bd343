// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Finds the pairs of faces that meet in more than they share, over a box tree.
#include "mortise/mesh/find_self_crossings.h"

#include <algorithm>

#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/embedded_fans.h"

namespace mortise {
namespace {

/// Boxes of the faces; an empty one, which meets nothing, for a face without area.
std::vector<Box3> boxes_of_faces(const SurfaceMesh& mesh) {
  std::vector<Box3> boxes(mesh.triangles.size());
  for (std::size_t f = 0; f < boxes.size(); ++f) {
    if (is_degenerate(mesh, FaceId(f))) continue;
    for (const VertexId v : mesh.triangles[f]) boxes[f].extend(mesh.points[v.index()]);
  }
  return boxes;
}

/// Do the faces share a vertex of an embedded fan?
bool share_embedded_fan(const std::vector<std::uint8_t>& is_embedded, const Triangle& a, const Triangle& b) {
  const auto is_shared = [&](VertexId v) { return (v == b[0] || v == b[1] || v == b[2]) && is_embedded[v.index()] != 0; };
  return is_shared(a[0]) || is_shared(a[1]) || is_shared(a[2]);
}

template <class Visit>
void for_each_self_crossing(const SurfaceMesh& mesh, const MeshTopology& topology, const BoxTree& tree, Visit visit) {
  const std::vector<std::uint8_t> is_embedded = find_embedded_fans(mesh, topology);
  for_each_meeting_pair_within(tree, [&](std::uint32_t i, std::uint32_t j) {
    if (share_embedded_fan(is_embedded, mesh.triangles[i], mesh.triangles[j])) return;
    const SelfCrossing pair{FaceId(i), FaceId(j), classify_meeting(mesh, FaceId(i), FaceId(j))};
    if (pair.kind != PairMeeting::Apart) visit(pair);
  });
}

}  // namespace

bool is_degenerate(const SurfaceMesh& mesh, FaceId face) {
  const Triangle& t = mesh.triangles[face.index()];
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  return are_collinear(mesh.points[t[0].index()], mesh.points[t[1].index()], mesh.points[t[2].index()]);
}

bool triangles_meet_beyond_shared(const SurfaceMesh& mesh, FaceId a, FaceId b) {
  return is_degenerate(mesh, a) || is_degenerate(mesh, b) || classify_meeting(mesh, a, b) != PairMeeting::Apart;
}

std::vector<SelfCrossing> find_self_crossings(const SurfaceMesh& mesh) {
  std::vector<SelfCrossing> pairs;
  for_each_self_crossing(mesh, build_topology(mesh), BoxTree(boxes_of_faces(mesh)), [&](const SelfCrossing& p) { pairs.push_back(p); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

SelfCrossingCounts count_self_crossings(const SurfaceMesh& mesh) { return count_self_crossings(mesh, build_topology(mesh)); }

SelfCrossingCounts count_self_crossings(const SurfaceMesh& mesh, const MeshTopology& topology) {
  SelfCrossingCounts counts;
  const std::vector<Box3> boxes = boxes_of_faces(mesh);
  for (const Box3& box : boxes) counts.degenerate_faces += box.is_empty() ? 1 : 0;
  for_each_self_crossing(mesh, topology, BoxTree(boxes), [&](const SelfCrossing& pair) {
    counts.crossing += pair.kind == PairMeeting::Crossing ? 1 : 0;
    counts.coplanar_overlap += pair.kind == PairMeeting::CoplanarOverlap ? 1 : 0;
    counts.touching += pair.kind == PairMeeting::Touching ? 1 : 0;
  });
  return counts;
}

}  // namespace mortise
