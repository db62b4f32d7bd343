// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Step of a repair that closes holes: boundary loops of one plane that are simple polygons apart from each other.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/face_marks.h"
#include "mortise/mesh/repair_steps.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/triangulate_polygon.h"

namespace mortise {
namespace {

/// A closed walk along boundary edges, against the faces there: as a face that fills the hole runs.
struct Hole {
  std::vector<VertexId> corners;
  std::vector<HalfEdge> sides;  ///< the half-edge of the face next to corners[i], corners[i + 1]
  std::vector<Vec3d> points;
  std::array<Vec3d, 3> plane;
  Axis axis = Axis::X;
  RepairOutcome outcome = RepairOutcome::Done;
};

/// Takes boundary edges one after the other and cuts a loop off wherever the walk comes back to a vertex.
class HoleWalk {
 public:
  explicit HoleWalk(const SurfaceMesh& mesh) : mesh_(mesh) {
    const MeshTopology topology = build_topology(mesh);
    for (const MeshEdgeId e : find_boundary_edges(topology)) sides_.push_back(topology.uses_of(e)[0]);
    std::sort(sides_.begin(), sides_.end(), [&](HalfEdge a, HalfEdge b) { return std::pair(from(a), a) < std::pair(from(b), b); });
    is_used_.resize(sides_.size(), false);
    place_on_path_.resize(mesh.points.size(), off_path);
  }

  std::vector<Hole> find_holes() {
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (!is_used_[i]) walk_from(i);
    }
    return std::move(holes_);
  }
  /// Boundary half-edges on no closed walk: the faces round that hole run in both ways.
  [[nodiscard]] const std::vector<HalfEdge>& dead_ends() const { return dead_ends_; }

 private:
  static constexpr std::size_t off_path = static_cast<std::size_t>(-1);

  // A filling runs along the side from the end of its half-edge to the origin.
  [[nodiscard]] VertexId from(HalfEdge h) const { return origin_of(mesh_, next_in_face(h)); }
  [[nodiscard]] VertexId to(HalfEdge h) const { return origin_of(mesh_, h); }

  void walk_from(std::size_t first) {
    std::vector<HalfEdge> path;
    for (std::optional<std::size_t> i = first; i; i = next_unused(to(path.back()))) {
      is_used_[*i] = true;
      place_on_path_[from(sides_[*i]).index()] = path.size();
      path.push_back(sides_[*i]);
      const std::size_t begin = place_on_path_[to(path.back()).index()];
      if (begin != off_path) cut_off(path, begin);
      if (path.empty()) return;
    }
    for (const HalfEdge h : path) place_on_path_[from(h).index()] = off_path;
    dead_ends_.insert(dead_ends_.end(), path.begin(), path.end());
  }

  [[nodiscard]] std::optional<std::size_t> next_unused(VertexId v) const {
    const auto begin = std::lower_bound(sides_.begin(), sides_.end(), v, [&](HalfEdge h, VertexId w) { return from(h) < w; });
    for (auto i = static_cast<std::size_t>(begin - sides_.begin()); i < sides_.size() && from(sides_[i]) == v; ++i) {
      if (!is_used_[i]) return i;
    }
    return std::nullopt;
  }

  void cut_off(std::vector<HalfEdge>& path, std::size_t begin) {
    Hole hole;
    for (std::size_t i = begin; i < path.size(); ++i) {
      hole.sides.push_back(path[i]);
      hole.corners.push_back(from(path[i]));
      hole.points.push_back(mesh_.points[from(path[i]).index()]);
      place_on_path_[from(path[i]).index()] = off_path;
    }
    path.resize(begin);
    holes_.push_back(std::move(hole));
  }

  const SurfaceMesh& mesh_;
  std::vector<HalfEdge> sides_;  ///< by the vertex a filling leaves
  std::vector<bool> is_used_;
  std::vector<std::size_t> place_on_path_;  ///< per vertex
  std::vector<Hole> holes_;
  std::vector<HalfEdge> dead_ends_;
};

/// Sets the plane of a hole; false when its corners lie in no plane, or all on a line.
bool find_plane(Hole& hole) {
  const std::vector<Vec3d>& p = hole.points;
  for (std::size_t i = 0; i < p.size(); ++i) {
    hole.plane = {p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]};
    const std::optional<Axis> axis = projection_axis(hole.plane[0], hole.plane[1], hole.plane[2]);
    if (!axis) continue;
    hole.axis = *axis;
    return std::all_of(p.begin(), p.end(),
                       [&](const Vec3d& q) { return orient3d(hole.plane[0], hole.plane[1], hole.plane[2], q) == Sign::Zero; });
  }
  return false;
}

/// Which way a simple polygon turns in its projection: as at its smallest corner.
Sign turn_of(const Hole& hole) {
  const std::size_t n = hole.points.size(), u = (static_cast<std::size_t>(hole.axis) + 1) % 3, v = (u + 1) % 3;
  std::size_t i = 0;
  for (std::size_t k = 1; k < n; ++k) {
    const Vec3d &p = hole.points[k], &q = hole.points[i];
    if (p[u] != q[u] ? p[u] < q[u] : p[v] < q[v]) i = k;
  }
  return orient2d(hole.points[(i + n - 1) % n], hole.points[i], hole.points[(i + 1) % n], hole.axis);
}

/// Does a face next to the hole lie in its plane, on the side to be filled?
bool overlaps_neighbours(const SurfaceMesh& mesh, const Hole& hole) {
  const Sign turn = turn_of(hole);
  return std::any_of(hole.sides.begin(), hole.sides.end(), [&](HalfEdge h) {
    const Vec3d& apex = mesh.points[origin_of(mesh, next_in_face(next_in_face(h))).index()];
    const Vec3d &a = mesh.points[origin_of(mesh, next_in_face(h)).index()], &b = mesh.points[origin_of(mesh, h).index()];
    return orient3d(hole.plane[0], hole.plane[1], hole.plane[2], apex) == Sign::Zero && orient2d(a, b, apex, hole.axis) == turn;
  });
}

RepairOutcome judge(const SurfaceMesh& mesh, Hole& hole) {
  if (!find_plane(hole)) return RepairOutcome::NotPlanar;
  if (!is_simple_polygon(hole.points, hole.axis)) return RepairOutcome::NotSimple;
  return overlaps_neighbours(mesh, hole) ? RepairOutcome::WouldOverlap : RepairOutcome::Done;
}

/// Is a point of the plane of a simple polygon inside it, its boundary left out? Sides across the line through the point are counted.
bool is_inside(const Hole& hole, const Vec3d& q) {
  const std::size_t n = hole.points.size(), u = (static_cast<std::size_t>(hole.axis) + 1) % 3;
  bool inside = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3d *a = &hole.points[i], *b = &hole.points[(i + 1) % n];
    if ((*b)[u] < (*a)[u]) std::swap(a, b);
    Box3 box;
    box.extend(*a);
    box.extend(*b);
    const Sign side = orient2d(*a, *b, q, hole.axis);
    if (side == Sign::Zero && boxes_meet(box, {q, q})) return false;
    if ((*a)[u] <= q[u] && q[u] < (*b)[u] && side == Sign::Negative) inside = !inside;
  }
  return inside;
}

Box3 box_of(const Hole& hole) {
  Box3 box;
  for (const Vec3d& p : hole.points) box.extend(p);
  return box;
}

bool lie_in_one_plane(const Hole& a, const Hole& b) {
  return std::all_of(b.plane.begin(), b.plane.end(),
                     [&](const Vec3d& p) { return orient3d(a.plane[0], a.plane[1], a.plane[2], p) == Sign::Zero; });
}

/// Does a corner of b lie in a? (b lies in the plane of a.)
bool holds(const Hole& a, const Hole& b) {
  return std::any_of(b.points.begin(), b.points.end(), [&](const Vec3d& p) { return is_inside(a, p); });
}

/// Of holes in one plane that lie in one another, none is filled.
void refuse_nested(std::vector<Hole>& holes) {
  std::vector<Box3> boxes;
  for (const Hole& hole : holes) boxes.push_back(box_of(hole));
  std::vector<bool> is_nested(holes.size(), false);
  for_each_meeting_pair_within(BoxTree(boxes), [&](std::uint32_t i, std::uint32_t j) {
    if (holes[i].outcome != RepairOutcome::Done || holes[j].outcome != RepairOutcome::Done || !lie_in_one_plane(holes[i], holes[j])) return;
    if (!holds(holes[i], holes[j]) && !holds(holes[j], holes[i])) return;
    is_nested[i] = true;
    is_nested[j] = true;
  });
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (is_nested[i]) holes[i].outcome = RepairOutcome::NotSimple;
  }
}

void fill(MeshInRepair& repair, const Hole& hole) {
  SurfaceMesh& mesh = repair.mesh;
  const std::size_t neighbour = face_of(*std::min_element(hole.sides.begin(), hole.sides.end())).index();
  for (const std::array<std::uint32_t, 3>& t : triangulate_polygon(hole.points).triangles) {
    mesh.triangles.push_back({hole.corners[t[0]], hole.corners[t[1]], hole.corners[t[2]]});
    repair.source.push_back(RepairedMesh::none);
    append_face_marks(mesh, FaceId(neighbour), mesh);
    forget_diagonals(FaceId(mesh.triangles.size() - 1), mesh);
    forget_corner_data(FaceId(mesh.triangles.size() - 1), mesh);
  }
}

void note_holes(MeshInRepair& repair, const std::vector<Hole>& holes, RepairOutcome outcome, const std::vector<HalfEdge>& dead_ends) {
  std::vector<FaceId> round;
  for (const HalfEdge h : dead_ends) round.push_back(face_of(h));
  std::uint64_t count = dead_ends.empty() ? 0 : 1;
  for (const Hole& hole : holes) {
    if (hole.outcome != outcome) continue;
    for (const HalfEdge h : hole.sides) round.push_back(face_of(h));
    ++count;
  }
  add_note(repair, RepairStep::FillPlanarHoles, outcome, count, round);
}

}  // namespace

void fill_planar_holes(MeshInRepair& repair) {
  HoleWalk walk(repair.mesh);
  std::vector<Hole> holes = walk.find_holes();
  for (Hole& hole : holes) hole.outcome = judge(repair.mesh, hole);
  refuse_nested(holes);
  for (const RepairOutcome outcome :
       {RepairOutcome::Done, RepairOutcome::NotPlanar, RepairOutcome::NotSimple, RepairOutcome::WouldOverlap}) {
    note_holes(repair, holes, outcome, outcome == RepairOutcome::NotSimple ? walk.dead_ends() : std::vector<HalfEdge>());
  }
  for (const Hole& hole : holes) {
    if (hole.outcome == RepairOutcome::Done) fill(repair, hole);
  }
}

}  // namespace mortise
