// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sides of triangles joined round every mesh edge: shells, their vertices and edges counted one by one.
#include "mortise/brep/validate_brep.h"

#include <algorithm>
#include <map>
#include <set>

#include "mortise/mesh/order_round_edge.h"

namespace mortise {
namespace {

// Corner 3 s + k of side s: the side's triangle at its corner k.
using SideCorner = std::uint32_t;

class FaultFinder {
 public:
  FaultFinder(const SurfaceMesh& mesh, const ClassifiedBrep& model)
      : mesh_(mesh), topology_(build_topology(mesh)), brep_(model.brep), on_(model.classification) {}

  [[nodiscard]] std::vector<std::string> find() {
    check_sizes();
    if (!faults_.empty()) return std::move(faults_);
    check_vertices();
    check_paths();
    check_triangles();
    check_loops();
    check_inverses();
    check_shells();
    return std::move(faults_);
  }

 private:
  void fault(const std::string& what) { faults_.push_back(what); }
  void expect(bool holds, const std::string& what) {
    if (!holds) fault(what);
  }
  static std::string name(const char* kind, std::size_t i) { return std::string(kind) + " " + std::to_string(i); }

  void check_sizes() {
    expect(on_.face_of_triangle.size() == mesh_.triangles.size(), "not one model face per triangle");
    expect(on_.entity_of_vertex.size() == mesh_.points.size(), "not one entity per mesh vertex");
    expect(on_.mesh_vertex.size() == brep_.vertex_count, "not one mesh vertex per model vertex");
    expect(on_.path.size() == brep_.edges.size(), "not one path per model edge");
    expect(brep_.loops_of_face.size() == brep_.faces.size(), "not one list of loops per face");
    for (const ModelFaceId f : on_.face_of_triangle) {
      if (f.index() >= brep_.faces.size()) return fault("a triangle lies on no model face");
    }
  }

  [[nodiscard]] ModelEntity entity(VertexId v) const { return on_.entity_of_vertex[v.index()]; }

  void check_vertices() {
    std::vector<std::uint8_t> is_used(mesh_.points.size(), 0);
    for (const Triangle& t : mesh_.triangles) {
      for (const VertexId v : t) is_used[v.index()] = 1;
    }
    for (std::size_t v = 0; v < is_used.size(); ++v) {
      const bool is_classified = on_.entity_of_vertex[v].dimension != EntityDimension::None;
      expect(is_classified == (is_used[v] != 0), name("mesh vertex", v) + " is classified and unused, or neither");
    }
    for (std::uint32_t i = 0; i < brep_.vertex_count; ++i) {
      const ModelEntity own{EntityDimension::Vertex, i};
      expect(entity(on_.mesh_vertex[ModelVertexId(i)]) == own, name("model vertex", i) + " is not where its mesh vertex says");
    }
    const auto on_vertices = std::count_if(on_.entity_of_vertex.begin(), on_.entity_of_vertex.end(),
                                           [](const ModelEntity& e) { return e.dimension == EntityDimension::Vertex; });
    expect(static_cast<std::size_t>(on_vertices) == brep_.vertex_count, "mesh vertices lie on one model vertex");
  }

  // Paths run from vertex to vertex over edges of the mesh that no other has.
  void check_paths() {
    edge_of_.assign(topology_.edges.size(), {});
    for (std::uint32_t i = 0; i < brep_.edges.size(); ++i) {
      const auto path = on_.path.of(ModelEdgeId(i));
      const ModelEdge& edge = brep_.edges[ModelEdgeId(i)];
      if (path.size() < 2) return fault(name("model edge", i) + " has no path");
      expect(path.front() == on_.mesh_vertex[edge.start] && path.back() == on_.mesh_vertex[edge.end],
             name("model edge", i) + " does not run between its vertices");
      for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        const ModelEntity own{EntityDimension::Edge, i};
        expect(k == 0 || entity(path[k]) == own, name("model edge", i) + " has a mesh vertex that is not on it");
        const MeshEdgeId e = find_edge(topology_, path[k], path[k + 1]);
        if (!e.is_valid() || edge_of_[e.index()].is_valid()) return fault(name("model edge", i) + " has a gap, or shares mesh edges");
        edge_of_[e.index()] = ModelEdgeId(i);
      }
    }
    std::size_t inner = 0;
    for (std::uint32_t i = 0; i < brep_.edges.size(); ++i) inner += on_.path.of(ModelEdgeId(i)).size() - 2;
    const auto on_edges = std::count_if(on_.entity_of_vertex.begin(), on_.entity_of_vertex.end(),
                                        [](const ModelEntity& e) { return e.dimension == EntityDimension::Edge; });
    expect(static_cast<std::size_t>(on_edges) == inner, "mesh vertices are classified on edges whose paths pass them by");
    for (std::size_t e = 0; e < edge_of_.size(); ++e) {
      if (!edge_of_[e].is_valid())
        expect(is_inside_a_face(MeshEdgeId(e)), name("mesh edge", e) + " is on no model edge and inside no face");
    }
  }

  [[nodiscard]] ModelFaceId face(HalfEdge h) const { return on_.face_of_triangle[face_of(h).index()]; }

  [[nodiscard]] bool is_inside_a_face(MeshEdgeId e) const {
    const auto uses = topology_.uses_of(e);
    return uses.size() == 2 && face(uses[0]) == face(uses[1]) && origin_of(mesh_, uses[0]) != origin_of(mesh_, uses[1]);
  }

  // The corners of a triangle lie on the closure of its face.
  void check_triangles() {
    std::vector<std::set<ModelEntity>> closure(brep_.faces.size());
    for (std::uint32_t f = 0; f < brep_.faces.size(); ++f) {
      closure[f].insert({EntityDimension::Face, f});
      for (const LoopId l : brep_.loops_of_face.of(ModelFaceId(f))) {
        closure[f].insert({EntityDimension::Vertex, brep_.loops[l].start.value});
        for (const EdgeUse& use : brep_.uses_of_loop.of(l)) {
          closure[f].insert({EntityDimension::Edge, use.edge.value});
          closure[f].insert({EntityDimension::Vertex, brep_.edges[use.edge].start.value});
          closure[f].insert({EntityDimension::Vertex, brep_.edges[use.edge].end.value});
        }
      }
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::set<ModelEntity>& own = closure[on_.face_of_triangle[t].index()];
      for (const VertexId v : mesh_.triangles[t]) {
        expect(own.count(entity(v)) == 1, name("triangle", t) + " has a corner that is not on the closure of its face");
      }
    }
  }

  void check_loops() {
    for (std::size_t i = 0; i < brep_.loops.size(); ++i) {
      const auto uses = brep_.uses_of_loop.of(LoopId(i));
      ModelVertexId at = brep_.loops[LoopId(i)].start;
      for (const EdgeUse& use : uses) {
        const ModelEdge& edge = brep_.edges[use.edge];
        expect((use.is_reversed ? edge.end : edge.start) == at, name("loop", i) + " is not connected");
        at = use.is_reversed ? edge.start : edge.end;
      }
      expect(at == brep_.loops[LoopId(i)].start, name("loop", i) + " is not closed");
    }
    check_uses_against_triangles();
  }

  // A face uses an edge as often, and in the same senses, as its triangles use each mesh edge of it.
  void check_uses_against_triangles() {
    std::map<std::pair<ModelEdgeId, ModelFaceId>, std::array<int, 2>> uses;
    for (std::size_t i = 0; i < brep_.loops.size(); ++i) {
      for (const EdgeUse& use : brep_.uses_of_loop.of(LoopId(i))) ++uses[{use.edge, brep_.loops[LoopId(i)].face}][use.is_reversed ? 1 : 0];
    }
    for (std::uint32_t i = 0; i < brep_.edges.size(); ++i) {
      const auto path = on_.path.of(ModelEdgeId(i));
      for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        std::map<ModelFaceId, std::array<int, 2>> seen;
        for (const HalfEdge h : topology_.uses_of(find_edge(topology_, path[k], path[k + 1])))
          ++seen[face(h)][origin_of(mesh_, h) == path[k] ? 0 : 1];
        std::size_t of_edge = 0;
        for (const auto& [f, times] : seen) {
          const auto found = uses.find({ModelEdgeId(i), f});
          expect(found != uses.end() && found->second == times, name("model edge", i) + " is not used as its mesh edges are");
          of_edge += static_cast<std::size_t>(times[0] + times[1]);
        }
        expect(of_edge == brep_.faces_of_edge.of(ModelEdgeId(i)).size(), name("model edge", i) + " has uses without triangles");
      }
    }
  }

  void check_inverses() {
    std::multiset<std::pair<ModelVertexId, ModelEdgeId>> ends, listed_ends;
    for (std::uint32_t i = 0; i < brep_.edges.size(); ++i) {
      ends.emplace(brep_.edges[ModelEdgeId(i)].start, ModelEdgeId(i));
      ends.emplace(brep_.edges[ModelEdgeId(i)].end, ModelEdgeId(i));
    }
    for (std::size_t v = 0; v < brep_.vertex_count; ++v) {
      for (const ModelEdgeId e : brep_.edges_of_vertex.of(ModelVertexId(v))) listed_ends.emplace(ModelVertexId(v), e);
    }
    expect(ends == listed_ends, "edges at vertices are not the ends of edges");
    for (std::size_t l = 0; l < brep_.loops.size(); ++l) {
      const auto loops = brep_.loops_of_face.of(brep_.loops[LoopId(l)].face);
      expect(std::find(loops.begin(), loops.end(), LoopId(l)) != loops.end(), name("loop", l) + " is missing at its face");
    }
    std::vector<int> times_listed(2 * brep_.faces.size(), 0);
    for (std::size_t s = 0; s < brep_.region_of_shell.size(); ++s) {
      const ModelRegionId region = brep_.region_of_shell[ShellId(s)];
      const auto shells = brep_.shells_of_region.of(region);
      expect(std::count(shells.begin(), shells.end(), ShellId(s)) == 1, name("shell", s) + " is missing at its region");
      for (const FaceSide& side : brep_.sides_of_shell.of(ShellId(s))) {
        const ModelFace& f = brep_.faces[side.face];
        expect((side.is_front ? f.region_in_front : f.region_behind) == region, name("shell", s) + " is not in the region of its faces");
        ++times_listed[2 * side.face.index() + (side.is_front ? 1 : 0)];
      }
    }
    expect(std::count(times_listed.begin(), times_listed.end(), 1) == static_cast<std::ptrdiff_t>(times_listed.size()),
           "a side of a face is not in one shell");
  }

  // Side 2 t is behind triangle t, side 2 t + 1 in front of it.
  static std::uint32_t side(HalfEdge h, bool is_front) { return 2 * face_of(h).value + (is_front ? 1 : 0); }

  // The corners of a side at the origin and at the end of a half-edge.
  static SideCorner at_origin(std::uint32_t side, HalfEdge h) { return 3 * side + h % 3; }
  static SideCorner at_end(std::uint32_t side, HalfEdge h) { return 3 * side + next_in_face(h) % 3; }

  struct Wedge {
    std::uint32_t side;  // one of the two it joins
    MeshEdgeId edge;
  };

  // Going round every edge, the side one leaves and the side one comes to bound one wedge of space.
  void join_sides(UnionFind& sides, UnionFind& corners, std::vector<Wedge>& wedges) const {
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
      const auto uses = topology_.uses_of(MeshEdgeId(e));
      std::vector<HalfEdge> round(uses.begin(), uses.end());
      const VertexId low = topology_.edges[e][0];
      if (round.size() > 2) sort_round_edge(mesh_, topology_.edges[e], round);
      for (std::size_t i = 0; i < round.size(); ++i) {
        const HalfEdge h = round[i], next = round[(i + 1) % round.size()];
        const bool is_up = origin_of(mesh_, h) == low, next_is_up = origin_of(mesh_, next) == low;
        const std::uint32_t left = side(h, is_up), reached = side(next, !next_is_up);
        sides.join(left, reached);
        corners.join(is_up ? at_origin(left, h) : at_end(left, h), next_is_up ? at_origin(reached, next) : at_end(reached, next));
        corners.join(is_up ? at_end(left, h) : at_origin(left, h), next_is_up ? at_end(reached, next) : at_origin(reached, next));
        wedges.push_back({left, MeshEdgeId(e)});
      }
    }
  }

  struct Characteristic {
    std::int64_t of_mesh = 0, of_model = 0;
  };

  void check_shells() {
    const std::size_t side_count = 2 * mesh_.triangles.size();
    UnionFind sides(side_count), corners(3 * side_count);
    std::vector<Wedge> wedges;
    join_sides(sides, corners, wedges);
    std::map<std::uint32_t, Characteristic> shells;
    for (std::uint32_t s = 0; s < side_count; ++s) ++shells[sides.find(s)].of_mesh;
    for (SideCorner c = 0; c < 3 * side_count; ++c) {
      if (corners.find(c) != c) continue;
      Characteristic& shell = shells[sides.find(c / 3)];
      ++shell.of_mesh;
      const VertexId v = mesh_.triangles[c / 6][c % 3];
      if (entity(v).dimension == EntityDimension::Vertex) ++shell.of_model;
    }
    for (const Wedge& w : wedges) {
      Characteristic& shell = shells[sides.find(w.side)];
      --shell.of_mesh;
      if (is_first_of_its_path(w.edge)) --shell.of_model;
    }
    add_faces(sides, shells);
    expect(shells.size() == brep_.region_of_shell.size(), "the triangles have another number of shells");
    for (const auto& [lowest, shell] : shells) {
      expect(shell.of_mesh == shell.of_model, "the shell of triangle " + std::to_string(lowest / 2) + " has characteristic " +
                                                  std::to_string(shell.of_mesh) + ", its model " + std::to_string(shell.of_model));
      expect(shell.of_mesh % 2 == 0 && shell.of_mesh <= 2, "the shell of triangle " + std::to_string(lowest / 2) + " is no closed surface");
    }
  }

  [[nodiscard]] bool is_first_of_its_path(MeshEdgeId e) const {
    if (!edge_of_[e.index()].is_valid()) return false;
    const auto path = on_.path.of(edge_of_[e.index()]);
    return find_edge(topology_, path[0], path[1]) == e;
  }

  // Every side of a model face is in the shell of its triangles, with all its triangles.
  void add_faces(UnionFind& sides, std::map<std::uint32_t, Characteristic>& shells) {
    std::vector<std::uint32_t> lowest(2 * brep_.faces.size(), 0xffffffffU);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (const std::uint32_t is_front : {0U, 1U}) {
        std::uint32_t& shell = lowest[2 * on_.face_of_triangle[t].value + is_front];
        const std::uint32_t own = sides.find(2 * t + is_front);
        if (shell == 0xffffffffU) shell = own;
        expect(shell == own, "model face of triangle " + std::to_string(t) + " is in several shells");
      }
    }
    std::map<ShellId, std::uint32_t> triangles_of;
    for (std::uint32_t s = 0; s < brep_.region_of_shell.size(); ++s) {
      for (const FaceSide& one : brep_.sides_of_shell.of(ShellId(s))) {
        const std::uint32_t shell = lowest[2 * one.face.value + (one.is_front ? 1 : 0)];
        const auto [found, is_new] = triangles_of.try_emplace(ShellId(s), shell);
        expect(is_new || found->second == shell, name("shell", s) + " is not connected");
        const ModelFace& f = brep_.faces[one.face];
        shells[shell].of_model += 2 - 2 * std::int64_t{f.genus} - static_cast<std::int64_t>(brep_.loops_of_face.of(one.face).size());
      }
    }
  }

  const SurfaceMesh& mesh_;
  const MeshTopology topology_;
  const Brep& brep_;
  const Classification& on_;
  std::vector<ModelEdgeId> edge_of_;  // per mesh edge, by the paths
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> find_faults(const SurfaceMesh& mesh, const ClassifiedBrep& model) { return FaultFinder(mesh, model).find(); }

}  // namespace mortise
