// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Rounding to float32: vertices meet, faces collapse to edges and to lines.
#include "mortise/mesh/round_to_float32.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "mortise/base/error.h"
#include "mortise/geom/coordinates.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/face_marks.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/validate.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

void round_points(std::vector<Vec3d>& points) {
  std::vector<std::uint32_t> too_large;
  for (std::size_t v = 0; v < points.size(); ++v) {
    Vec3d& p = points[v];
    if (fits_float32(p)) {
      p = nearest_float32(p);
    } else {
      too_large.push_back(static_cast<std::uint32_t>(v));
    }
  }
  if (too_large.empty()) return;
  throw Error(ErrorCode::OutOfRange, "round_to_float32", "a coordinate is too large for float32")
      .with_ids(IdKind::Vertices, std::move(too_large));
}

bool has_three_corners(const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

void drop_collapsed_faces(SurfaceMesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (!has_three_corners(mesh.triangles[f])) continue;
    mesh.triangles[kept] = mesh.triangles[f];
    copy_face_marks(FaceId(f), FaceId(kept), mesh);
    ++kept;
  }
  mesh.triangles.resize(kept);
  resize_face_marks(mesh);
}

/// The half-edge along the longest side of a face.
HalfEdge longest_side(const SurfaceMesh& mesh, FaceId f) {
  HalfEdge longest = static_cast<HalfEdge>(3 * f.index());
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const HalfEdge h = static_cast<HalfEdge>(3 * f.index() + k);
    const double size = length(mesh.points[origin_of(mesh, next_in_face(h)).index()] - mesh.points[origin_of(mesh, h).index()]);
    if (size > most) {
      most = size;
      longest = h;
    }
  }
  return longest;
}

bool are_joined(const MeshTopology& topology, VertexId a, VertexId b) {
  const std::array<VertexId, 2> edge{std::min(a, b), std::max(a, b)};
  return std::binary_search(topology.edges.begin(), topology.edges.end(), edge);
}

/// Gives the longest side of each face without area another diagonal; the faces of one round do not touch in an edge.
///
///      a               a
///    /   \           / | \ .
///   u-----v   ->    u  |  v     u v a has no area
///    \   /           \ | /
///      w               w
class AreaRepair {
 public:
  explicit AreaRepair(SurfaceMesh& mesh) : mesh_(mesh), topology_(build_topology(mesh)), is_touched_(mesh.triangles.size(), 0) {}

  /// Was any side swapped?
  bool run() {
    bool any = false;
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (is_degenerate(mesh_, FaceId(f)) && swap(longest_side(mesh_, FaceId(f)))) any = true;
    }
    return any;
  }

 private:
  bool swap(HalfEdge h) {
    const auto uses = topology_.uses_of(topology_.edge_of[h]);
    if (uses.size() != 2) return false;
    const HalfEdge across = uses[0] == h ? uses[1] : uses[0];
    const VertexId u = origin_of(mesh_, h), v = origin_of(mesh_, next_in_face(h));
    const VertexId a = origin_of(mesh_, next_in_face(next_in_face(h))), w = origin_of(mesh_, next_in_face(next_in_face(across)));
    const bool runs_back = origin_of(mesh_, across) == v;
    if (!runs_back || a == w || touches_swapped(h) || touches_swapped(across) || are_joined(topology_, a, w)) return false;
    const FaceData data(mesh_, face_of(across));
    copy_face_marks(face_of(across), face_of(h), mesh_);
    set_corners(face_of(h), {a, u, w}, mesh_);
    set_corners(face_of(across), {w, v, a}, mesh_);
    for (const FaceId f : {face_of(h), face_of(across)}) data.give_to(f, mesh_);
    touch(h);
    touch(across);
    return true;
  }

  [[nodiscard]] bool touches_swapped(HalfEdge h) const { return is_touched_[h / 3] != 0; }

  // The topology is as before the swaps: faces round the swapped ones wait for the next round.
  void touch(HalfEdge h) {
    const HalfEdge first = h - h % 3;
    for (HalfEdge side = first; side < first + 3; ++side) {
      for (const HalfEdge use : topology_.uses_of(topology_.edge_of[side])) is_touched_[use / 3] = 1;
    }
  }

  SurfaceMesh& mesh_;
  MeshTopology topology_;
  std::vector<std::uint8_t> is_touched_;
};

}  // namespace

SurfaceMesh round_to_float32(const SurfaceMesh& mesh) {
  validate(mesh);
  SurfaceMesh result = mesh;
  round_points(result.points);
  result = weld(result).mesh;
  drop_collapsed_faces(result);
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds && AreaRepair(result).run(); ++round) {
  }
  return result;
}

}  // namespace mortise
