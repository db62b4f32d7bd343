// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Classification, then loops as uses of edges, then shells and regions.
#include "mortise/brep/assemble_brep.h"

#include <algorithm>

#include "mortise/mesh/find_shells.h"
#include "mortise/mesh/order_round_edge.h"

namespace mortise {
namespace {

// Finds the edge that leaves a corner towards a mesh vertex.
class EdgesAtCorners {
 public:
  explicit EdgesAtCorners(const Lists<ModelEdgeId, VertexId>& path) {
    for (std::size_t e = 0; e < path.size(); ++e) {
      const auto p = path.of(ModelEdgeId(e));
      starts_.push_back({p[0], p[1], {ModelEdgeId(e), false}});
      starts_.push_back({p[p.size() - 1], p[p.size() - 2], {ModelEdgeId(e), true}});
    }
    std::sort(starts_.begin(), starts_.end());
  }

  [[nodiscard]] EdgeUse find(VertexId corner, VertexId next) const {
    return std::lower_bound(starts_.begin(), starts_.end(), Start{corner, next, {}})->use;
  }

 private:
  struct Start {
    VertexId corner, next;
    EdgeUse use;

    bool operator<(const Start& o) const { return corner != o.corner ? corner < o.corner : next < o.next; }
  };

  std::vector<Start> starts_;
};

class BrepAssembler {
 public:
  BrepAssembler(const SurfaceMesh& mesh, BrepParts&& parts) : mesh_(mesh), parts_(std::move(parts)) {}

  [[nodiscard]] ClassifiedBrep assemble() && {
    classify();
    add_edges();
    add_loops();
    add_regions();
    return std::move(result_);
  }

 private:
  [[nodiscard]] ModelVertexId model_vertex(VertexId v) const { return ModelVertexId(classes()[v.index()].id); }
  [[nodiscard]] std::size_t face_count() const { return parts_.genus.size(); }
  [[nodiscard]] const std::vector<ModelEntity>& classes() const { return result_.classification.entity_of_vertex; }
  [[nodiscard]] bool is_corner(VertexId v) const { return parts_.is_corner[v.index()] != 0; }

  // Faces first, then what lies on their boundaries.
  void classify() {
    Classification& c = result_.classification;
    c.entity_of_vertex.resize(mesh_.points.size());
    c.face_of_triangle.reserve(mesh_.triangles.size());
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      const std::uint32_t face = parts_.faces.component_of[f];
      c.face_of_triangle.emplace_back(face);
      for (const VertexId v : mesh_.triangles[f]) c.entity_of_vertex[v.index()] = {EntityDimension::Face, face};
    }
    c.path = std::move(parts_.path);
    for (std::uint32_t e = 0; e < c.path.size(); ++e) {
      for (const VertexId v : c.path.of(ModelEdgeId(e))) c.entity_of_vertex[v.index()] = {EntityDimension::Edge, e};
    }
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      if (!is_corner(VertexId(v))) continue;
      c.entity_of_vertex[v] = {EntityDimension::Vertex, static_cast<std::uint32_t>(c.mesh_vertex.size())};
      c.mesh_vertex.push_back(VertexId(v));
    }
    result_.brep.vertex_count = c.mesh_vertex.size();
  }

  void add_edges() {
    Brep& brep = result_.brep;
    const Lists<ModelEdgeId, VertexId>& path = result_.classification.path;
    std::vector<std::pair<ModelVertexId, ModelEdgeId>> ends;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const auto vertices = path.of(ModelEdgeId(i));
      brep.edges.push_back({model_vertex(vertices.front()), model_vertex(vertices.back()), parts_.is_seam[i] != 0});
      ends.emplace_back(brep.edges[ModelEdgeId(i)].start, ModelEdgeId(i));
      ends.emplace_back(brep.edges[ModelEdgeId(i)].end, ModelEdgeId(i));
    }
    brep.edges_of_vertex = lists_of<ModelVertexId, ModelEdgeId>(
        ends, brep.vertex_count, [](const auto& end) { return end.first; }, [](const auto& end) { return end.second; });
  }

  void add_loops() {
    Brep& brep = result_.brep;
    const Lists<ModelFaceId, LoopId> given = lists_of<ModelFaceId, LoopId>(
        numbers<LoopId>(parts_.loops.size()), face_count(), [&](LoopId l) { return parts_.face_of_loop[l.index()]; },
        [](LoopId l) { return l; });
    const EdgesAtCorners edges(result_.classification.path);
    std::vector<std::pair<ModelEdgeId, FaceUse>> face_uses;
    for (const LoopId l : given.items) {
      const auto vertices = parts_.loops.of(l);
      const std::size_t count = vertices.size();
      const auto first = static_cast<std::size_t>(std::find_if(vertices.begin(), vertices.end(), [&](VertexId v) { return is_corner(v); }) -
                                                  vertices.begin());
      const ModelLoop loop{parts_.face_of_loop[l.index()], model_vertex(vertices[first])};
      for (std::size_t i = first; count > 1 && i < first + count; ++i) {
        if (!is_corner(vertices[i % count])) continue;
        const EdgeUse use = edges.find(vertices[i % count], vertices[(i + 1) % count]);
        brep.uses_of_loop.items.push_back(use);
        face_uses.emplace_back(use.edge, FaceUse{loop.face, use.is_reversed});
      }
      brep.uses_of_loop.close();
      brep.loops.push_back(loop);
    }
    brep.loops_of_face = lists_of<ModelFaceId, LoopId>(
        numbers<LoopId>(brep.loops.size()), face_count(), [&](LoopId l) { return brep.loops[l].face; }, [](LoopId l) { return l; });
    brep.faces_of_edge = lists_of<ModelEdgeId, FaceUse>(
        face_uses, brep.edges.size(), [](const auto& use) { return use.first; }, [](const auto& use) { return use.second; });
    for (const CrowdedEdge& crowded : parts_.crowded) {
      const auto first = static_cast<std::ptrdiff_t>(brep.faces_of_edge.begin[crowded.edge.index()]);
      std::copy(crowded.round.begin(), crowded.round.end(), brep.faces_of_edge.items.begin() + first);
    }
  }

  template <class Number>
  static std::vector<Number> numbers(std::size_t count) {
    std::vector<Number> all;
    for (std::size_t i = 0; i < count; ++i) all.emplace_back(i);
    return all;
  }

  void add_regions() {
    Brep& brep = result_.brep;
    const SurfaceShells shells = find_shells(mesh_, surface_pieces());
    brep.region_count = shells.cell_count;
    const auto region_of = [&](std::uint32_t shell) { return ModelRegionId(shells.cell_of_shell[shell]); };
    std::vector<std::pair<ShellId, FaceSide>> sides;
    for (std::uint32_t f = 0; f < face_count(); ++f) {
      brep.faces.push_back({parts_.genus[f], region_of(shells.behind[f]), region_of(shells.in_front[f])});
      sides.emplace_back(ShellId(shells.behind[f]), FaceSide{ModelFaceId(f), false});
      sides.emplace_back(ShellId(shells.in_front[f]), FaceSide{ModelFaceId(f), true});
    }
    for (std::uint32_t s = 0; s < shells.cell_of_shell.size(); ++s) brep.region_of_shell.push_back(region_of(s));
    const std::size_t shell_count = shells.cell_of_shell.size();
    brep.sides_of_shell = lists_of<ShellId, FaceSide>(
        sides, shell_count, [](const auto& side) { return side.first; }, [](const auto& side) { return side.second; });
    brep.shells_of_region = lists_of<ModelRegionId, ShellId>(
        numbers<ShellId>(shell_count), brep.region_count, [&](ShellId s) { return brep.region_of_shell[s]; }, [](ShellId s) { return s; });
  }

  [[nodiscard]] SurfacePieces surface_pieces() {
    SurfacePieces pieces;
    pieces.of_face = std::move(parts_.faces);
    pieces.joints.begin = result_.brep.faces_of_edge.begin;
    for (const FaceUse& use : result_.brep.faces_of_edge.items) pieces.joints.items.push_back({use.face.value, !use.is_reversed});
    return pieces;
  }

  const SurfaceMesh& mesh_;
  BrepParts parts_;
  ClassifiedBrep result_;
};

}  // namespace

std::vector<FaceUse> faces_round(const SurfaceMesh& mesh, const FaceComponents& faces, const std::array<VertexId, 2>& ends,
                                 std::vector<HalfEdge> half_edges) {
  sort_round_edge(mesh, ends, half_edges);
  std::vector<FaceUse> round;
  for (const HalfEdge h : half_edges) {
    round.push_back({ModelFaceId(faces.component_of[face_of(h).index()]), origin_of(mesh, h) != ends[0]});
  }
  std::rotate(round.begin(), std::min_element(round.begin(), round.end()), round.end());
  return round;
}

ClassifiedBrep assemble_brep(const SurfaceMesh& mesh, BrepParts&& parts) { return BrepAssembler(mesh, std::move(parts)).assemble(); }

}  // namespace mortise
