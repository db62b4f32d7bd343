// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Steps of a repair that take faces away: those without area, duplicates, opposite pairs.
#include <algorithm>
#include <array>
#include <utility>

#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/repair_steps.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

bool is_before(const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

/// Drops faces without area so that what was closed stays closed. The faces of one round do not touch in an edge.
///
///        m                m
///      /   \            / | \ .
///     p-----q    ->    p  |  q     p q m has no area; the face p q w is cut at m
///      \   /            \ | /
///        w                w
class DegenerateRound {
 public:
  explicit DegenerateRound(MeshInRepair& repair)
      : repair_(repair),
        mesh_(repair.mesh),
        topology_(build_topology(repair.mesh)),
        is_touched_(mesh_.triangles.size(), false),
        is_kept_(mesh_.triangles.size(), true) {}

  /// The faces it dropped, as they were given.
  std::vector<std::uint32_t> run() {
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (is_kept_[f] && is_degenerate(mesh_, FaceId(f))) drop(FaceId(f));
    }
    keep_faces(repair_, is_kept_);
    return std::move(dropped_);
  }

 private:
  void drop(FaceId f) {
    if (touches_changed(f)) return;
    const std::uint32_t source = repair_.source[f.index()];
    touch(f);
    dropped_.push_back(source);
    is_kept_[f.index()] = false;
    if (repeats_vertex(mesh_.triangles[f.index()])) return;
    const HalfEdge h = side_across_middle(f);
    if (needs_partner(h)) cut_partner(h, partner_of(h));
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

  /// Do the other faces on the side not balance without this one?
  [[nodiscard]] bool needs_partner(HalfEdge h) const {
    int others = 0;
    for (const HalfEdge use : topology_.uses_of(topology_.edge_of[h])) {
      if (use != h) others += origin_of(mesh_, use) == origin_of(mesh_, h) ? 1 : -1;
    }
    return others != 0;
  }

  /// Another use of the side: rather one that runs back, rather one of a face with area.
  [[nodiscard]] HalfEdge partner_of(HalfEdge h) const {
    HalfEdge best = h;
    int best_rank = -1;
    for (const HalfEdge use : topology_.uses_of(topology_.edge_of[h])) {
      if (use == h) continue;
      const int rank = (origin_of(mesh_, use) != origin_of(mesh_, h) ? 2 : 0) + (is_degenerate(mesh_, face_of(use)) ? 0 : 1);
      if (rank > best_rank) {
        best_rank = rank;
        best = use;
      }
    }
    return best;
  }

  void cut_partner(HalfEdge h, HalfEdge across) {
    const std::size_t f = face_of(h).index(), g = face_of(across).index();
    const VertexId middle = origin_of(mesh_, next_in_face(next_in_face(h)));
    const VertexId p = origin_of(mesh_, across), q = origin_of(mesh_, next_in_face(across));
    const VertexId w = origin_of(mesh_, next_in_face(next_in_face(across)));
    touch(FaceId(g));
    if (w == middle) {
      is_kept_[g] = false;
      dropped_.push_back(repair_.source[g]);
      return;
    }
    mesh_.triangles[g] = {p, middle, w};
    mesh_.triangles[f] = {middle, q, w};
    is_kept_[f] = true;
    repair_.source[f] = repair_.source[g];
    if (!mesh_.face_labels.empty()) mesh_.face_labels[f] = mesh_.face_labels[g];
  }

  [[nodiscard]] const Vec3d& point(HalfEdge h) const { return mesh_.points[origin_of(mesh_, h).index()]; }

  template <class Visit>
  void for_each_use_round(FaceId f, Visit visit) const {
    const auto first = static_cast<HalfEdge>(3 * f.index());
    for (HalfEdge side = first; side < first + 3; ++side) {
      if (!topology_.edge_of[side].is_valid()) continue;
      for (const HalfEdge use : topology_.uses_of(topology_.edge_of[side])) visit(face_of(use).index());
    }
  }

  // The topology is as before the changes: faces next to changed ones wait for the next round.
  [[nodiscard]] bool touches_changed(FaceId f) const {
    bool touches = is_touched_[f.index()];
    for_each_use_round(f, [&](std::size_t g) { touches = touches || is_touched_[g]; });
    return touches;
  }
  void touch(FaceId f) {
    for_each_use_round(f, [&](std::size_t g) { is_touched_[g] = true; });
  }

  MeshInRepair& repair_;
  SurfaceMesh& mesh_;
  MeshTopology topology_;
  std::vector<bool> is_touched_, is_kept_;
  std::vector<std::uint32_t> dropped_;
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
  RepairNote note{RepairStep::DropDegenerate, RepairOutcome::Done, 0, {}};
  for (;;) {
    const std::vector<std::uint32_t> dropped = DegenerateRound(repair).run();
    if (dropped.empty()) break;
    note.count += dropped.size();
    for (const std::uint32_t source : dropped) note.faces.push_back(FaceId(source));
  }
  std::sort(note.faces.begin(), note.faces.end());
  note.faces.erase(std::unique(note.faces.begin(), note.faces.end()), note.faces.end());
  if (note.count != 0) repair.done.push_back(std::move(note));
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
