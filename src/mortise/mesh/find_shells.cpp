// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Each edge-connected surface has one outer shell and one for every cell in it.
#include "mortise/mesh/find_shells.h"

#include <algorithm>
#include <map>

#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"
#include "mortise/geom/lexicographic.h"
#include "mortise/mesh/order_round_edge.h"
#include "mortise/mesh/ray_crossing.h"

namespace mortise {
namespace {

constexpr std::uint32_t none = 0xffffffffU;

// A point below p in y, exactly at its x and z.
Vec3d below(const Vec3d& p) { return {p.x, p.y > 0 ? p.y / 2 : p.y == 0 ? -1 : 2 * p.y, p.z}; }

class ShellFinder {
 public:
  ShellFinder(const SurfaceMesh& mesh, const SurfacePieces& pieces)
      : mesh_(mesh),
        pieces_(pieces),
        surfaces_(connect_pieces()),
        sides_(2 * std::size_t{pieces.of_face.count} + 1),
        unbounded_side_(2 * pieces.of_face.count) {}

  [[nodiscard]] SurfaceShells find() {
    join_round_edges();
    SurfaceShells shells = number_shells();
    find_outer_shells();
    place_surfaces();
    number_cells(shells);
    return shells;
  }

 private:
  // Where a surface is looked at from outside: its lexicographically smallest vertex, and an edge there with nothing below.
  struct Lookout {
    VertexId at, towards;
    FaceId face;  // at this edge
  };

  [[nodiscard]] const Vec3d& position(VertexId v) const { return mesh_.points[v.index()]; }
  [[nodiscard]] const Triangle& triangle(FaceId f) const { return mesh_.triangles[f.index()]; }
  [[nodiscard]] std::uint32_t piece_of(FaceId f) const { return pieces_.of_face.component_of[f.index()]; }
  [[nodiscard]] std::uint32_t surface_of(FaceId f) const { return surfaces_.component_of[piece_of(f)]; }
  // Side 2 p is behind piece p, side 2 p + 1 in front of it.
  [[nodiscard]] std::uint32_t side_behind(FaceId f) const { return 2 * piece_of(f); }
  [[nodiscard]] std::uint32_t side_in_front(FaceId f) const { return 2 * piece_of(f) + 1; }
  [[nodiscard]] std::uint32_t surface_of_side(std::uint32_t side) const { return surfaces_.component_of[side / 2]; }

  [[nodiscard]] FaceComponents connect_pieces() const {
    UnionFind connected(pieces_.of_face.count);
    for (std::size_t i = 0; i < pieces_.joints.size(); ++i) {
      const auto round = pieces_.joints.of(JointId(i));
      for (const PieceAtEdge& p : round) connected.join(round[0].piece, p.piece);
    }
    return number_components(connected);
  }

  // Going round an edge u -> v counterclockwise one comes to the back of a face that runs along it, and leaves from its front.
  void join_round_edges() {
    for (std::size_t i = 0; i < pieces_.joints.size(); ++i) {
      const auto round = pieces_.joints.of(JointId(i));
      for (std::size_t k = 0; k < round.size(); ++k) {
        const PieceAtEdge &p = round[k], &next = round[(k + 1) % round.size()];
        sides_.join(2 * p.piece + (p.runs_along ? 1 : 0), 2 * next.piece + (next.runs_along ? 0 : 1));
      }
    }
  }

  void find_outer_shells() {
    find_smallest_vertices();
    lookouts_.resize(surfaces_.count);
    for (std::uint32_t s = 0; s < surfaces_.count; ++s) lookouts_[s].at = smallest_[s];
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) try_lookout(FaceId(f));
    outer_side_.assign(surfaces_.count, none);
    std::vector<HalfEdge> lowest(surfaces_.count, none);
    for (HalfEdge h = 0; h < 3 * mesh_.triangles.size(); ++h) {
      const std::uint32_t s = surface_of(face_of(h));
      if (!is_at_lookout(h) || (lowest[s] != none && !comes_first(s, h, lowest[s]))) continue;
      lowest[s] = h;
      const bool runs_along = origin_of(mesh_, h) == lookouts_[s].at;
      outer_side_[s] = runs_along ? side_behind(face_of(h)) : side_in_front(face_of(h));
    }
  }

  void find_smallest_vertices() {
    smallest_.resize(surfaces_.count);
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      VertexId& smallest = smallest_[surface_of(FaceId(f))];
      for (const VertexId v : mesh_.triangles[f]) {
        if (!smallest.is_valid() || is_lexicographically_less(position(v), position(smallest))) smallest = v;
      }
    }
  }

  // The edge that leaves the smallest vertex at the smallest slope in (x, y).
  void try_lookout(FaceId f) {
    Lookout& lookout = lookouts_[surface_of(f)];
    const Triangle& t = triangle(f);
    if (std::find(t.begin(), t.end(), lookout.at) == t.end()) return;
    const Vec3d& at = position(lookout.at);
    for (const VertexId w : t) {
      const Vec3d& end = position(w);
      if (end.x == at.x && end.y == at.y) continue;
      const bool is_lower = !lookout.towards.is_valid() || orient2d(at, position(lookout.towards), end, Axis::Z) == Sign::Negative;
      if (!is_lower) continue;
      lookout.towards = w;
      lookout.face = f;
    }
  }

  [[nodiscard]] bool is_at_lookout(HalfEdge h) const {
    const Lookout& lookout = lookouts_[surface_of(face_of(h))];
    const VertexId from = origin_of(mesh_, h), to = origin_of(mesh_, next_in_face(h));
    return (from == lookout.at && to == lookout.towards) || (from == lookout.towards && to == lookout.at);
  }

  // Is the first half-edge's face met before the other's, turning counterclockwise round the edge from straight below?
  [[nodiscard]] bool comes_first(std::uint32_t surface, HalfEdge h, HalfEdge other) const {
    const Vec3d& u = position(lookouts_[surface].at);
    const Vec3d& v = position(lookouts_[surface].towards);
    const Vec3d& p = position(origin_of(mesh_, next_in_face(next_in_face(h))));
    const Vec3d& q = position(origin_of(mesh_, next_in_face(next_in_face(other))));
    const Sign to_p = orient3d(u, v, below(u), p), to_q = orient3d(u, v, below(u), q);
    return to_p != to_q ? to_p > to_q : orient3d(u, v, p, q) == Sign::Positive;
  }

  // A surface inside a cell of others belongs to the innermost of these: the surface that bounds it lies in most others itself.
  void place_surfaces() {
    if (surfaces_.count == 0) return;
    std::vector<std::vector<std::uint32_t>> around(surfaces_.count);  // sides of the shells round each surface
    if (surfaces_.count > 1) {
      const BoxTree tree = face_tree();
      for (std::uint32_t s = 0; s < surfaces_.count; ++s) around[s] = shells_round(tree, s);
    }
    const auto depth_of = [&](std::uint32_t side) { return around[surface_of_side(side)].size(); };
    for (std::uint32_t s = 0; s < surfaces_.count; ++s) {
      const auto innermost =
          std::max_element(around[s].begin(), around[s].end(), [&](std::uint32_t a, std::uint32_t b) { return depth_of(a) < depth_of(b); });
      sides_to_join_.emplace_back(outer_side_[s], innermost == around[s].end() ? unbounded_side_ : *innermost);
    }
    for (const auto& [side, other] : sides_to_join_) sides_.join(side, other);
  }

  [[nodiscard]] BoxTree face_tree() const {
    std::vector<Box3> boxes(mesh_.triangles.size());
    for (std::size_t f = 0; f < boxes.size(); ++f) {
      for (const VertexId v : mesh_.triangles[f]) boxes[f].extend(position(v));
    }
    return BoxTree(boxes);
  }

  // Shells of other surfaces, but for their outer ones, that wind round a surface.
  [[nodiscard]] std::vector<std::uint32_t> shells_round(const BoxTree& tree, std::uint32_t s) {
    const Lookout& lookout = lookouts_[s];
    const Triangle& t = triangle(lookout.face);
    const auto third = std::find_if(t.begin(), t.end(), [&](VertexId v) { return v != lookout.at && v != lookout.towards; });
    const RayStart start{position(lookout.at), position(lookout.towards), position(*third)};
    std::map<std::uint32_t, int> winding;  // by the smallest side of the shell
    tree.for_each_meeting(ray_box(start), [&](std::uint32_t i) {
      const FaceId f(i);
      if (surface_of(f) == s) return;
      const int step = winding_step(position(triangle(f)[0]), position(triangle(f)[1]), position(triangle(f)[2]), start);
      winding[sides_.find(side_behind(f))] += step;
      winding[sides_.find(side_in_front(f))] -= step;
    });
    std::vector<std::uint32_t> shells;
    for (const auto& [side, times] : winding) {
      const bool is_outer = sides_.find(outer_side_[surface_of_side(side)]) == side;
      if (times != 0 && !is_outer) shells.push_back(side);
    }
    return shells;
  }

  [[nodiscard]] SurfaceShells number_shells() {
    SurfaceShells shells;
    std::vector<std::uint32_t> number(sides_.size(), none);
    std::uint32_t count = 0;
    for (std::uint32_t side = 0; side < unbounded_side_; ++side) {
      std::uint32_t& shell = number[sides_.find(side)];
      if (shell == none) {
        shell = count++;
        side_of_shell_.push_back(side);
      }
      (side % 2 == 0 ? shells.behind : shells.in_front).push_back(shell);
    }
    return shells;
  }

  void number_cells(SurfaceShells& shells) {
    std::vector<std::uint32_t> cell_of_side(sides_.size(), none);
    cell_of_side[sides_.find(unbounded_side_)] = SurfaceShells::unbounded;
    for (const std::uint32_t side : side_of_shell_) {
      std::uint32_t& cell = cell_of_side[sides_.find(side)];
      if (cell == none) cell = shells.cell_count++;
      shells.cell_of_shell.push_back(cell);
    }
  }

  const SurfaceMesh& mesh_;
  const SurfacePieces& pieces_;
  FaceComponents surfaces_;  // of pieces
  UnionFind sides_;
  std::uint32_t unbounded_side_;
  std::vector<VertexId> smallest_;         // per surface
  std::vector<Lookout> lookouts_;          // per surface
  std::vector<std::uint32_t> outer_side_;  // per surface
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides_to_join_;
  std::vector<std::uint32_t> side_of_shell_;  // one of each
};

}  // namespace

void add_joint(const SurfaceMesh& mesh, std::span<const HalfEdge> half_edges, SurfacePieces& pieces) {
  const VertexId a = origin_of(mesh, half_edges[0]), b = origin_of(mesh, next_in_face(half_edges[0]));
  const std::array<VertexId, 2> edge{std::min(a, b), std::max(a, b)};
  std::vector<HalfEdge> sorted;
  if (half_edges.size() > 2) {
    sorted.assign(half_edges.begin(), half_edges.end());
    sort_round_edge(mesh, edge, sorted);
    half_edges = sorted;
  }
  for (const HalfEdge h : half_edges) {
    pieces.joints.items.push_back({pieces.of_face.component_of[face_of(h).index()], origin_of(mesh, h) == edge[0]});
  }
  pieces.joints.close();
}

SurfaceShells find_shells(const SurfaceMesh& mesh, const SurfacePieces& pieces) { return ShellFinder(mesh, pieces).find(); }

}  // namespace mortise
