// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Steps of a repair that take faces away: those without area, duplicates, opposite pairs.
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "mortise/mesh/face_marks.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/repair_steps.h"
#include "mortise/mesh/repeats_vertex.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

bool is_before(const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

/// The half-edges along an edge while faces change: those of the mesh as it was that still run there, and new ones.
class ChangingEdges {
 public:
  explicit ChangingEdges(const SurfaceMesh& mesh) : mesh_(mesh), topology_(build_topology(mesh)) {}

  [[nodiscard]] std::vector<HalfEdge> uses_of(VertexId a, VertexId b) const {
    const std::array<VertexId, 2> edge{std::min(a, b), std::max(a, b)};
    std::vector<HalfEdge> uses;
    if (const MeshEdgeId old = find_edge(topology_, a, b); old.is_valid()) {
      for (const HalfEdge h : topology_.uses_of(old)) uses.push_back(h);
    }
    if (const auto added = added_.find(edge); added != added_.end()) uses.insert(uses.end(), added->second.begin(), added->second.end());
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    uses.erase(std::remove_if(uses.begin(), uses.end(), [&](HalfEdge h) { return edge_of(h) != edge; }), uses.end());
    return uses;
  }

  /// To be called when a face has got other vertices.
  void add_face(FaceId f) {
    const auto first = static_cast<HalfEdge>(3 * f.index());
    for (HalfEdge h = first; h < first + 3; ++h) added_[edge_of(h)].push_back(h);
  }

 private:
  [[nodiscard]] std::array<VertexId, 2> edge_of(HalfEdge h) const {
    const VertexId a = origin_of(mesh_, h), b = origin_of(mesh_, next_in_face(h));
    return {std::min(a, b), std::max(a, b)};
  }

  const SurfaceMesh& mesh_;
  MeshTopology topology_;
  std::map<std::array<VertexId, 2>, std::vector<HalfEdge>> added_;
};

/// Drops faces without area so that what was closed stays closed.
///
///        m                m
///      /   \            / | \ .
///     p-----q    ->    p  |  q     p q m has no area; the face p q w is cut at m
///      \   /            \ | /
///        w                w
///
/// A face whose neighbour there has no area either waits until that has got some. Where no face gets any, as in a fold, the
/// neighbour is cut all the same: the longest sides of the two become shorter.
class DegenerateFaces {
 public:
  explicit DegenerateFaces(MeshInRepair& repair)
      : repair_(repair), mesh_(repair.mesh), edges_(repair.mesh), is_kept_(repair.mesh.triangles.size(), true) {}

  void drop_all(const std::vector<FaceId>& faces) {
    waiting_ = faces;
    while (!waiting_.empty()) {
      const std::vector<FaceId> round = std::exchange(waiting_, {});
      bool any = false;
      for (const FaceId f : round) any = drop_with_neighbours(f) || any;
      if (!any) drop(round.front(), true);
    }
    keep_faces(repair_, is_kept_);
  }

 private:
  /// Drops the face if it can be dropped now, then those that waited for it.
  bool drop_with_neighbours(FaceId first) {
    std::vector<FaceId> stack{first};
    bool any = false;
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      if (!is_to_drop(f)) {
        any = any || f == first;
        continue;
      }
      const Triangle corners = mesh_.triangles[f.index()];
      if (!drop(f, false)) {
        if (f == first) waiting_.push_back(f);
        continue;
      }
      any = true;
      for (std::size_t i = 0; i < 3; ++i) {
        for (const HalfEdge h : edges_.uses_of(corners[i], corners[(i + 1) % 3])) stack.push_back(face_of(h));
      }
    }
    return any;
  }

  [[nodiscard]] bool is_to_drop(FaceId f) const { return is_kept_[f.index()] && is_degenerate(mesh_, f); }

  /// Is the face gone? Unless forced it stays when only faces without area could be cut.
  bool drop(FaceId f, bool is_forced) {
    if (!repeats_vertex(mesh_.triangles[f.index()])) {
      const HalfEdge h = side_across_middle(f);
      const std::vector<HalfEdge> others = others_on(h);
      if (balance_beside(h, others) != 0) {
        const HalfEdge across = best_partner(h, others);
        if (!is_forced && is_degenerate(mesh_, face_of(across))) return false;
        cut_partner(h, across);
        return true;
      }
    }
    is_kept_[f.index()] = false;
    return true;
  }

  /// The side whose ends have the third corner between them on their line.
  [[nodiscard]] HalfEdge side_across_middle(FaceId f) const {
    const auto first = static_cast<HalfEdge>(3 * f.index());
    for (HalfEdge h = first; h < first + 2; ++h) {
      const Vec3d& middle = point(next_in_face(next_in_face(h)));
      if (is_before(point(h), middle) == is_before(middle, point(next_in_face(h)))) return h;
    }
    return first + 2;
  }

  [[nodiscard]] std::vector<HalfEdge> others_on(HalfEdge h) const {
    std::vector<HalfEdge> others;
    for (const HalfEdge use : edges_.uses_of(origin_of(mesh_, h), origin_of(mesh_, next_in_face(h)))) {
      if (use != h && is_kept_[face_of(use).index()]) others.push_back(use);
    }
    return others;
  }

  [[nodiscard]] int balance_beside(HalfEdge h, const std::vector<HalfEdge>& others) const {
    int balance = 0;
    for (const HalfEdge use : others) balance += origin_of(mesh_, use) == origin_of(mesh_, h) ? 1 : -1;
    return balance;
  }

  /// Rather one that runs back, as closed meshes need; of those rather a face with area.
  [[nodiscard]] HalfEdge best_partner(HalfEdge h, const std::vector<HalfEdge>& others) const {
    HalfEdge best = others.front();
    int best_rank = -1;
    for (const HalfEdge use : others) {
      const int rank = (origin_of(mesh_, use) != origin_of(mesh_, h) ? 2 : 0) + (is_degenerate(mesh_, face_of(use)) ? 0 : 1);
      if (rank <= best_rank) continue;
      best_rank = rank;
      best = use;
    }
    return best;
  }

  void cut_partner(HalfEdge h, HalfEdge across) {
    const FaceId f = face_of(h), g = face_of(across);
    const VertexId middle = origin_of(mesh_, next_in_face(next_in_face(h)));
    const VertexId p = origin_of(mesh_, across), q = origin_of(mesh_, next_in_face(across));
    const VertexId w = origin_of(mesh_, next_in_face(next_in_face(across)));
    if (w == middle) {  // the same three vertices: they cancel
      is_kept_[f.index()] = false;
      is_kept_[g.index()] = false;
      return;
    }
    const FaceData data(mesh_, g);
    repair_.source[f.index()] = repair_.source[g.index()];
    copy_face_marks(g, f, mesh_);
    set_corners(g, {p, middle, w}, mesh_);
    set_corners(f, {middle, q, w}, mesh_);
    for (const FaceId changed : {f, g}) {
      data.give_to(changed, mesh_);
      edges_.add_face(changed);
      if (is_degenerate(mesh_, changed)) waiting_.push_back(changed);
    }
  }

  [[nodiscard]] const Vec3d& point(HalfEdge h) const { return mesh_.points[origin_of(mesh_, h).index()]; }

  MeshInRepair& repair_;
  SurfaceMesh& mesh_;
  ChangingEdges edges_;
  std::vector<bool> is_kept_;
  std::vector<FaceId> waiting_;
};

/// The vertices of a face in ascending order, and whether it runs round them so.
struct FaceKey {
  Triangle vertices;
  bool is_even;
  FaceId face;
};

FaceKey key_of(const Triangle& t, FaceId f) {
  FaceKey key{t, true, f};
  const auto order = [&](std::size_t i, std::size_t j) {
    if (!(key.vertices[j] < key.vertices[i])) return;
    std::swap(key.vertices[i], key.vertices[j]);
    key.is_even = !key.is_even;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return key;
}

/// Faces with three different vertices, those round the same vertices together: odd ones first, each by number.
std::vector<FaceKey> sorted_keys(const SurfaceMesh& mesh) {
  std::vector<FaceKey> keys;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (!repeats_vertex(mesh.triangles[f])) keys.push_back(key_of(mesh.triangles[f], FaceId(f)));
  }
  std::sort(keys.begin(), keys.end(), [](const FaceKey& a, const FaceKey& b) {
    if (a.vertices != b.vertices) return a.vertices < b.vertices;
    return a.is_even != b.is_even ? b.is_even : a.face < b.face;
  });
  return keys;
}

void drop_faces(MeshInRepair& repair, RepairStep step, const std::vector<FaceId>& faces) {
  add_note(repair, step, RepairOutcome::Done, faces.size(), faces);
  std::vector<bool> is_kept(repair.mesh.triangles.size(), true);
  for (const FaceId f : faces) is_kept[f.index()] = false;
  keep_faces(repair, is_kept);
}

}  // namespace

void drop_degenerate_faces(MeshInRepair& repair) {
  std::vector<FaceId> faces;
  for (std::size_t f = 0; f < repair.mesh.triangles.size(); ++f) {
    if (is_degenerate(repair.mesh, FaceId(f))) faces.push_back(FaceId(f));
  }
  if (faces.empty()) return;
  add_note(repair, RepairStep::DropDegenerate, RepairOutcome::Done, faces.size(), faces);
  DegenerateFaces(repair).drop_all(faces);
}

void drop_duplicate_faces(MeshInRepair& repair) {
  const std::vector<FaceKey> keys = sorted_keys(repair.mesh);
  std::vector<FaceId> dropped;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].vertices == keys[i - 1].vertices && keys[i].is_even == keys[i - 1].is_even) dropped.push_back(keys[i].face);
  }
  drop_faces(repair, RepairStep::DropDuplicates, dropped);
}

void cancel_opposite_faces(MeshInRepair& repair) {
  const std::vector<FaceKey> keys = sorted_keys(repair.mesh);
  std::vector<FaceId> dropped;
  for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    while (end < keys.size() && keys[end].vertices == keys[begin].vertices) ++end;
    std::size_t even = begin;
    while (even < end && !keys[even].is_even) ++even;
    const std::size_t pairs = std::min(even - begin, end - even);
    for (std::size_t i = 0; i < pairs; ++i) {
      dropped.push_back(keys[begin + i].face);
      dropped.push_back(keys[even + i].face);
    }
  }
  drop_faces(repair, RepairStep::CancelOpposites, dropped);
}

}  // namespace mortise
