// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Features part faces; corners part edges; shells bound regions; then the tables of what bounds what.
#include "mortise/brep/build_brep.h"

#include <algorithm>
#include <string>

#include "mortise/base/error.h"
#include "mortise/brep/trace_edges.h"
#include "mortise/mesh/find_shells.h"
#include "mortise/mesh/repeats_vertex.h"
#include "mortise/mesh/validate.h"

namespace mortise {
namespace {

constexpr const char* stage_name = "build_brep";

void refuse_bad_input(const SurfaceMesh& mesh, const BrepRules& rules) {
  validate(mesh);
  if (!(rules.edge_angle_deg >= 0 && rules.edge_angle_deg <= 180))
    throw Error(ErrorCode::InvalidArgument, stage_name, "angles lie between 0 and 180 degrees");
  std::vector<std::uint32_t> bad;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    if (repeats_vertex(mesh.triangles[f])) bad.push_back(f);
  }
  if (!bad.empty())
    throw Error(ErrorCode::InvalidArgument, stage_name, "triangles repeat a vertex: repair the mesh first").with_ids(IdKind::Faces, bad);
}

FaceComponents connect_smoothly(const HalfEdgesAcross& across) {
  UnionFind faces(across.size() / 3);
  for (HalfEdge h = 0; h < across.size(); ++h) {
    if (across[h] != no_half_edge && h < across[h]) faces.join(face_of(h).value, face_of(across[h]).value);
  }
  return number_components(faces);
}

/// The mesh in pieces, their boundaries in paths: all a Brep is made of.
struct DividedMesh {
  FaceComponents pieces;
  FeatureEdges features;
  FaceBoundaries boundaries;
  std::vector<std::uint8_t> is_corner;  // per mesh vertex
  TracedEdges edges;
};

/// Makes features of seams.
void open_along(const std::vector<MeshEdgeId>& seams, const SurfaceMesh& mesh, const MeshTopology& topology, HalfEdgesAcross& across,
                FeaturesRound& round, DividedMesh& d) {
  std::vector<std::uint8_t> opened(d.pieces.count, 0);
  for (const MeshEdgeId e : seams) {
    d.features.is_feature[e.index()] = d.features.is_seam[e.index()] = 1;
    for (const HalfEdge h : topology.uses_of(e)) {
      across[h] = no_half_edge;
      opened[d.pieces.component_of[face_of(h).index()]] = 1;
    }
  }
  round = edges_round_vertices(topology, d.features.is_feature, mesh.points.size());
  walk_again(across, d.pieces, opened, d.boundaries);
  add_corners_on_seams(mesh, topology, d.features, round, d.pieces, seams, d.is_corner);
}

DividedMesh divide(const SurfaceMesh& mesh, const MeshTopology& topology, const BrepRules& rules, const FaceNormals& normals) {
  DividedMesh d;
  d.features.is_feature = find_feature_edges(mesh, topology, normals, rules.features);
  d.features.is_seam.assign(topology.edges.size(), 0);
  HalfEdgesAcross across = half_edges_across(topology, d.features.is_feature);
  d.pieces = connect_smoothly(across);
  d.boundaries = find_face_boundaries(mesh, across, d.pieces);
  FeaturesRound round = edges_round_vertices(topology, d.features.is_feature, mesh.points.size());
  d.is_corner = find_corners(mesh, topology, d.features, round, d.pieces, d.boundaries, rules.edge_angle_deg);
  const std::vector<MeshEdgeId> seams = find_seams(rules.seams, mesh, topology, d.pieces, d.boundaries, d.is_corner);
  if (!seams.empty()) open_along(seams, mesh, topology, across, round, d);
  d.edges = trace_edges(topology, d.features.is_feature, round, d.is_corner);
  return d;
}

class BrepBuilder {
 public:
  BrepBuilder(const SurfaceMesh& mesh, const MeshTopology& topology, DividedMesh&& divided)
      : mesh_(mesh), topology_(topology), divided_(std::move(divided)) {}

  [[nodiscard]] ClassifiedBrep build() && {
    classify();
    add_edges();
    add_loops();
    add_regions();
    return std::move(result_);
  }

 private:
  [[nodiscard]] ModelVertexId model_vertex(VertexId v) const { return ModelVertexId(classes()[v.index()].id); }
  [[nodiscard]] std::size_t face_count() const { return divided_.boundaries.genus.size(); }
  [[nodiscard]] const std::vector<ModelEntity>& classes() const { return result_.classification.entity_of_vertex; }

  // Faces first, then what lies on their boundaries.
  void classify() {
    Classification& c = result_.classification;
    c.entity_of_vertex.resize(mesh_.points.size());
    c.face_of_triangle.reserve(mesh_.triangles.size());
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      const std::uint32_t face = divided_.pieces.component_of[f];
      c.face_of_triangle.emplace_back(face);
      for (const VertexId v : mesh_.triangles[f]) c.entity_of_vertex[v.index()] = {EntityDimension::Face, face};
    }
    c.path = std::move(divided_.edges.path);
    for (std::uint32_t e = 0; e < c.path.size(); ++e) {
      for (const VertexId v : c.path.of(ModelEdgeId(e))) c.entity_of_vertex[v.index()] = {EntityDimension::Edge, e};
    }
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      if (divided_.is_corner[v] == 0) continue;
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
      brep.edges.push_back({model_vertex(vertices.front()), model_vertex(vertices.back()), false});
      ends.emplace_back(brep.edges[ModelEdgeId(i)].start, ModelEdgeId(i));
      ends.emplace_back(brep.edges[ModelEdgeId(i)].end, ModelEdgeId(i));
    }
    for (std::size_t e = 0; e < divided_.features.is_seam.size(); ++e) {
      if (divided_.features.is_seam[e] != 0) brep.edges[divided_.edges.edge_of[e]].is_seam = true;
    }
    brep.edges_of_vertex = lists_of<ModelVertexId, ModelEdgeId>(
        ends, brep.vertex_count, [](const auto& end) { return end.first; }, [](const auto& end) { return end.second; });
  }

  void add_loops() {
    std::vector<std::pair<ModelLoop, std::vector<EdgeUse>>> loops;
    for (std::size_t b = 0; b < divided_.boundaries.piece.size(); ++b) loops.push_back(loop_along(BoundaryId(b)));
    for (const TouchedVertex& t : divided_.boundaries.touched) loops.push_back({{ModelFaceId(t.piece), model_vertex(t.vertex)}, {}});
    std::stable_sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.first.face < b.first.face; });
    Brep& brep = result_.brep;
    std::vector<std::pair<ModelEdgeId, FaceUse>> face_uses;
    for (const auto& [loop, uses] : loops) {
      brep.loops.push_back(loop);
      for (const EdgeUse& use : uses) {
        brep.uses_of_loop.items.push_back(use);
        face_uses.emplace_back(use.edge, FaceUse{loop.face, use.is_reversed});
      }
      brep.uses_of_loop.close();
    }
    std::vector<LoopId> numbers;
    for (std::size_t i = 0; i < loops.size(); ++i) numbers.emplace_back(i);
    brep.loops_of_face = lists_of<ModelFaceId, LoopId>(
        numbers, face_count(), [&](LoopId l) { return brep.loops[l].face; }, [](LoopId l) { return l; });
    brep.faces_of_edge = lists_of<ModelEdgeId, FaceUse>(
        face_uses, brep.edges.size(), [](const auto& use) { return use.first; }, [](const auto& use) { return use.second; });
  }

  [[nodiscard]] bool is_corner(HalfEdge h) const { return divided_.is_corner[origin_of(mesh_, h).index()] != 0; }

  // From the first half-edge that leaves a corner on.
  [[nodiscard]] std::pair<ModelLoop, std::vector<EdgeUse>> loop_along(BoundaryId b) const {
    const auto half_edges = divided_.boundaries.half_edges.of(b);
    const auto first = std::find_if(half_edges.begin(), half_edges.end(), [&](HalfEdge h) { return is_corner(h); });
    const ModelLoop loop{ModelFaceId(divided_.boundaries.piece[b.index()]), model_vertex(origin_of(mesh_, *first))};
    std::vector<EdgeUse> uses;
    const auto add = [&](HalfEdge h) {
      if (is_corner(h)) uses.push_back(use_of(h));
    };
    std::for_each(first, half_edges.end(), add);
    std::for_each(half_edges.begin(), first, add);
    return {loop, uses};
  }

  // A half-edge that leaves a corner starts along a model edge or, from its end, against it.
  [[nodiscard]] EdgeUse use_of(HalfEdge h) const {
    const ModelEdgeId edge = divided_.edges.edge_of[topology_.edge_of[h].index()];
    const auto path = result_.classification.path.of(edge);
    return {edge, origin_of(mesh_, h) != path[0] || origin_of(mesh_, next_in_face(h)) != path[1]};
  }

  void add_regions() {
    Brep& brep = result_.brep;
    const SurfaceShells shells = find_shells(mesh_, topology_, surface_pieces());
    brep.region_count = shells.cell_count;
    const auto region_of = [&](std::uint32_t shell) { return ModelRegionId(shells.cell_of_shell[shell]); };
    std::vector<std::pair<ShellId, FaceSide>> sides;
    for (std::uint32_t f = 0; f < face_count(); ++f) {
      brep.faces.push_back({divided_.boundaries.genus[f], region_of(shells.behind[f]), region_of(shells.in_front[f])});
      sides.emplace_back(ShellId(shells.behind[f]), FaceSide{ModelFaceId(f), false});
      sides.emplace_back(ShellId(shells.in_front[f]), FaceSide{ModelFaceId(f), true});
    }
    std::vector<ShellId> numbers;
    for (std::uint32_t s = 0; s < shells.cell_of_shell.size(); ++s) {
      brep.region_of_shell.push_back(region_of(s));
      numbers.emplace_back(s);
    }
    brep.sides_of_shell = lists_of<ShellId, FaceSide>(
        sides, numbers.size(), [](const auto& side) { return side.first; }, [](const auto& side) { return side.second; });
    brep.shells_of_region = lists_of<ModelRegionId, ShellId>(
        numbers, brep.region_count, [&](ShellId s) { return brep.region_of_shell[s]; }, [](ShellId s) { return s; });
  }

  // One mesh edge stands for its model edge: the same faces follow one another round all of it.
  [[nodiscard]] SurfacePieces surface_pieces() {
    SurfacePieces pieces;
    pieces.of_face = std::move(divided_.pieces);
    std::vector<std::uint8_t> has_one(result_.brep.edges.size(), 0);
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
      const ModelEdgeId edge = divided_.edges.edge_of[e];
      if (!edge.is_valid() || has_one[edge.index()] != 0) continue;
      has_one[edge.index()] = 1;
      pieces.edges.emplace_back(e);
    }
    return pieces;
  }

  const SurfaceMesh& mesh_;
  const MeshTopology& topology_;
  DividedMesh divided_;
  ClassifiedBrep result_;
};

ClassifiedBrep build_from(const SurfaceMesh& mesh, const MeshTopology& topology, const BrepRules& rules, const FaceNormals& normals) {
  return BrepBuilder(mesh, topology, divide(mesh, topology, rules, normals)).build();
}

}  // namespace

ClassifiedBrep build_brep(const SurfaceMesh& mesh, const BrepRules& rules, const FaceNormals& normals) {
  refuse_bad_input(mesh, rules);
  if (normals.normals.size() != mesh.triangles.size() || (!normals.planes.empty() && normals.planes.size() != mesh.triangles.size()))
    throw Error(
        ErrorCode::InvalidArgument, stage_name,
        "there are " + std::to_string(normals.normals.size()) + " normals for " + std::to_string(mesh.triangles.size()) + " triangles");
  return build_from(mesh, build_topology(mesh), rules, normals);
}

ClassifiedBrep build_brep(const SurfaceMesh& mesh, const BrepRules& rules) {
  refuse_bad_input(mesh, rules);
  const MeshTopology topology = build_topology(mesh);
  return build_from(mesh, topology, rules, measure_normals(mesh, topology));
}

}  // namespace mortise
