// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Touched faces and their neighbours are a mesh of their own; its division, and what is kept, are put together.
#include "mortise/brep/rebuild_brep.h"

#include <algorithm>
#include <optional>
#include <string>

#include "mortise/base/error.h"
#include "mortise/brep/assemble_brep.h"
#include "mortise/brep/divide_mesh.h"
#include "mortise/mesh/select_faces.h"

namespace mortise {
namespace {

constexpr const char* stage_name = "rebuild_brep";

void refuse_bad_input(const SurfaceMesh& mesh, const Provenance& provenance, const BrepRules& rules) {
  const std::size_t count = mesh.triangles.size();
  if (provenance.source_operand.size() != count || provenance.source_face.size() != count || provenance.flipped.size() != count)
    throw Error(ErrorCode::InvalidArgument, stage_name, "there is not one source per triangle");
  if (!rules.features.groups.empty() && rules.features.groups.size() != count)
    throw Error(ErrorCode::InvalidArgument, stage_name, "there is not one group per triangle");
}

class BrepRebuilder {
 public:
  BrepRebuilder(const SurfaceMesh& mesh, const Provenance& provenance, std::span<const OperandModel> operands, const BrepRules& rules)
      : mesh_(mesh),
        provenance_(provenance),
        operands_(operands),
        rules_(rules),
        kept_(find_kept_faces(mesh, provenance, operands, rules.features)),
        is_touched_vertex_(mesh.points.size(), 0) {}

  [[nodiscard]] RebuiltBrep rebuild() {
    const std::vector<FaceId> faces = faces_to_visit();
    const bool is_worth_it = 2 * faces.size() <= mesh_.triangles.size() || 8 * result_.touched < mesh_.triangles.size();
    return is_worth_it ? rebuild_part(faces) : build_anew();
  }

 private:
  [[nodiscard]] RebuiltBrep build_anew() {
    std::vector<FaceId> all;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) all.emplace_back(t);
    result_.model = build_brep(mesh_, rules_, normals_of(all));
    result_.visited = all.size();
    return std::move(result_);
  }

  [[nodiscard]] RebuiltBrep rebuild_part(const std::vector<FaceId>& faces) {
    part_ = select_faces(mesh_, faces);
    topology_ = build_topology(part_.mesh);
    divided_ = divide_mesh(part_.mesh, topology_, part_rules(), normals_of(part_.source_face), known_faces());
    number_faces();
    mark_corners();
    add_paths();
    add_loops();
    result_.model = assemble_brep(mesh_, std::move(parts_));
    result_.visited = faces.size();
    return std::move(result_);
  }

  struct Path {
    std::array<VertexId, 2> lowest;  // mesh edge
    std::vector<VertexId> vertices;
    bool is_seam = false;
    std::vector<FaceUse> round;  // where there are more than two
  };

  [[nodiscard]] bool is_touched(FaceId t) const { return kept_.is_touched[kept_.face_of_triangle[t.index()]] != 0; }
  [[nodiscard]] bool is_kept(std::size_t operand, ModelFaceId f) const { return kept_.is_touched[kept_.old_face(operand, f)] == 0; }
  [[nodiscard]] VertexId of_result(VertexId v) const { return part_.source_vertex[v.index()]; }
  [[nodiscard]] HalfEdge of_result(HalfEdge h) const {
    return static_cast<HalfEdge>(3 * part_.source_face[face_of(h).index()].index() + h % 3);
  }

  // Of an edge that only untouched faces use.
  [[nodiscard]] bool is_kept(std::size_t operand, ModelEdgeId e) const {
    const auto uses = operands_[operand].model.brep.faces_of_edge.of(e);
    return std::all_of(uses.begin(), uses.end(), [&](const FaceUse& use) { return is_kept(operand, use.face); });
  }

  template <class Visit>
  void for_each_kept_edge(Visit visit) const {
    for (std::size_t k = 0; k < operands_.size(); ++k) {
      for (std::size_t e = 0; e < operands_[k].model.brep.edges.size(); ++e) {
        if (is_kept(k, ModelEdgeId(e))) visit(k, ModelEdgeId(e));
      }
    }
  }

  [[nodiscard]] VertexId image(std::size_t operand, VertexId v) const { return kept_.image[operand][v.index()]; }

  [[nodiscard]] std::vector<VertexId> image_of_path(std::size_t operand, ModelEdgeId e) const {
    std::vector<VertexId> vertices;
    for (const VertexId v : operands_[operand].model.classification.path.of(e)) vertices.push_back(image(operand, v));
    return vertices;
  }

  // All triangles at vertices of touched faces.
  [[nodiscard]] std::vector<FaceId> faces_to_visit() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!is_touched(FaceId(t))) continue;
      ++result_.touched;
      for (const VertexId v : mesh_.triangles[t]) is_touched_vertex_[v.index()] = 1;
    }
    std::vector<FaceId> faces;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& corners = mesh_.triangles[t];
      if (std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return is_touched_vertex_[v.index()] != 0; }))
        faces.emplace_back(t);
    }
    return faces;
  }

  [[nodiscard]] std::optional<VertexId> in_part(VertexId v) const {
    const auto found = std::lower_bound(part_.source_vertex.begin(), part_.source_vertex.end(), v);
    if (found == part_.source_vertex.end() || *found != v) return {};
    return VertexId(static_cast<std::size_t>(found - part_.source_vertex.begin()));
  }

  [[nodiscard]] std::optional<MeshEdgeId> edge_in_part(VertexId a, VertexId b) const {
    const std::optional<VertexId> p = in_part(a), q = in_part(b);
    if (!p || !q) return {};
    const MeshEdgeId edge = find_edge(topology_, *p, *q);
    return edge.is_valid() ? std::optional(edge) : std::nullopt;
  }

  // Both ends of every user edge are touched.
  [[nodiscard]] BrepRules part_rules() const {
    BrepRules rules = rules_;
    for (auto& ends : rules.features.user_edges) {
      const std::optional<MeshEdgeId> edge = edge_in_part(ends[0], ends[1]);
      if (!edge) refuse_user_edge(ends, stage_name);
      ends = topology_.edges[edge->index()];
    }
    if (rules.features.groups.empty()) return rules;
    rules.features.groups.clear();
    for (const FaceId t : part_.source_face) rules.features.groups.push_back(rules_.features.groups[t.index()]);
    return rules;
  }

  [[nodiscard]] FaceNormals normals_of(const std::vector<FaceId>& faces) const {
    std::vector<std::uint32_t> first_plane{0};
    for (const OperandModel& operand : operands_) {
      first_plane.push_back(first_plane.back() + static_cast<std::uint32_t>(operand.mesh.triangles.size()));
    }
    FaceNormals normals;
    for (const FaceId t : faces) {
      const std::uint32_t k = provenance_.source_operand[t.index()], f = provenance_.source_face[t.index()];
      const Vec3d& normal = operands_[k].normals.normals[f];
      normals.normals.push_back(provenance_.flipped[t.index()] != 0 ? -1.0 * normal : normal);
      normals.planes.push_back(first_plane[k] + f);
    }
    return normals;
  }

  [[nodiscard]] KnownFaces known_faces() const {
    KnownFaces known;
    for (const FaceId t : part_.source_face) {
      known.face_of_triangle.push_back(is_touched(t) ? KnownFaces::none : kept_.face_of_triangle[t.index()].value);
    }
    for_each_kept_edge([&](std::size_t k, ModelEdgeId e) {
      if (!operands_[k].model.brep.edges[e].is_seam) return;
      const std::vector<VertexId> path = image_of_path(k, e);
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (const auto edge = edge_in_part(path[i], path[i + 1])) known.seams.push_back(*edge);
      }
    });
    return known;
  }

  // By their lowest triangles.
  void number_faces() {
    constexpr std::uint32_t none = 0xffffffffU;
    new_face_.assign(divided_.pieces.count, ModelFaceId());
    kept_face_.resize(kept_.is_touched.size());
    std::size_t s = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      ModelFaceId* face = nullptr;
      std::uint32_t piece = none;
      if (is_touched(FaceId(t))) {
        while (part_.source_face[s] != FaceId(t)) ++s;
        piece = divided_.pieces.component_of[s];
        face = &new_face_[piece];
      } else {
        face = &kept_face_[kept_.face_of_triangle[t]];
      }
      if (!face->is_valid()) {
        *face = ModelFaceId(parts_.genus.size());
        parts_.genus.push_back(piece == none ? old_genus(kept_.face_of_triangle[t]) : divided_.boundaries.genus[piece]);
      }
      parts_.faces.component_of.push_back(face->value);
    }
    parts_.faces.count = static_cast<std::uint32_t>(parts_.genus.size());
  }

  [[nodiscard]] std::uint32_t old_genus(OldFaceId f) const {
    const auto next = std::upper_bound(kept_.first_face.begin(), kept_.first_face.end(), f.value);
    const auto k = static_cast<std::size_t>(next - kept_.first_face.begin()) - 1;
    return operands_[k].model.brep.faces[ModelFaceId(f.index() - kept_.first_face[k])].genus;
  }

  void mark_corners() {
    parts_.is_corner.assign(mesh_.points.size(), 0);
    for (std::size_t k = 0; k < operands_.size(); ++k) {
      for (const VertexId w : operands_[k].model.classification.mesh_vertex) {
        if (const VertexId v = image(k, w); v.is_valid()) parts_.is_corner[v.index()] = 1;
      }
    }
    for (std::size_t v = 0; v < part_.source_vertex.size(); ++v) {
      const VertexId of_mesh = part_.source_vertex[v];
      if (is_touched_vertex_[of_mesh.index()] != 0) parts_.is_corner[of_mesh.index()] = divided_.is_corner[v];
    }
  }

  void add_paths() {
    std::vector<Path> paths;
    add_new_paths(paths);
    for_each_kept_edge([&](std::size_t k, ModelEdgeId e) { paths.push_back(kept_path(k, e)); });
    std::sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) { return a.lowest < b.lowest; });
    for (Path& path : paths) {
      parts_.path.items.insert(parts_.path.items.end(), path.vertices.begin(), path.vertices.end());
      const ModelEdgeId id = parts_.path.close();
      parts_.is_seam.push_back(path.is_seam ? 1 : 0);
      if (!path.round.empty()) parts_.crowded.push_back({id, std::move(path.round)});
    }
  }

  // Those that bound a new face, from their lowest mesh edges.
  void add_new_paths(std::vector<Path>& paths) const {
    std::vector<std::uint8_t> is_seen(divided_.edges.path.size(), 0);
    for (std::size_t i = 0; i < topology_.edges.size(); ++i) {
      const MeshEdgeId edge(i);
      const ModelEdgeId e = divided_.edges.edge_of[i];
      if (!e.is_valid() || is_seen[e.index()] != 0) continue;
      is_seen[e.index()] = 1;
      const auto uses = topology_.uses_of(edge);
      if (std::none_of(uses.begin(), uses.end(), [&](HalfEdge h) { return new_face_at(h).is_valid(); })) continue;
      Path path{{of_result(topology_.edges[i][0]), of_result(topology_.edges[i][1])}, {}, divided_.features.is_seam[i] != 0, {}};
      for (const VertexId v : divided_.edges.path.of(e)) path.vertices.push_back(of_result(v));
      if (uses.size() > 2)
        path.round = faces_round(mesh_, parts_.faces, {path.vertices[0], path.vertices[1]},
                                 half_edges_of_result(edge_in_part(path.vertices[0], path.vertices[1]).value()));
      paths.push_back(std::move(path));
    }
  }

  [[nodiscard]] ModelFaceId new_face_at(HalfEdge h) const { return new_face_[divided_.pieces.component_of[face_of(h).index()]]; }

  [[nodiscard]] std::vector<HalfEdge> half_edges_of_result(MeshEdgeId e) const {
    std::vector<HalfEdge> half_edges;
    for (const HalfEdge h : topology_.uses_of(e)) half_edges.push_back(of_result(h));
    return half_edges;
  }

  // From the lower end on, round a closed one to the lower neighbour.
  [[nodiscard]] Path kept_path(std::size_t k, ModelEdgeId e) const {
    Path path{{}, image_of_path(k, e), operands_[k].model.brep.edges[e].is_seam, {}};
    std::vector<VertexId>& v = path.vertices;
    const bool is_closed = v.front() == v.back();
    const bool is_turned = is_closed ? v[v.size() - 2] < v[1] : v.back() < v.front();
    if (is_turned) std::reverse(v.begin(), v.end());
    path.lowest = sorted_ends(v[0], v[1]);
    for (std::size_t i = 1; i + 1 < v.size(); ++i) path.lowest = std::min(path.lowest, sorted_ends(v[i], v[i + 1]));
    path.round = kept_round(k, e, is_turned);
    return path;
  }

  [[nodiscard]] std::vector<FaceUse> kept_round(std::size_t k, ModelEdgeId e, bool is_turned) const {
    std::vector<FaceUse> round;
    const auto uses = operands_[k].model.brep.faces_of_edge.of(e);
    if (uses.size() <= 2) return round;
    for (const FaceUse& use : uses) {
      const OldFaceId face = kept_.old_face(k, use.face);
      round.push_back({kept_face_[face], (use.is_reversed != is_turned) != (kept_.is_flipped[face] != 0)});
    }
    if (is_turned) std::reverse(round.begin(), round.end());
    std::rotate(round.begin(), std::min_element(round.begin(), round.end()), round.end());
    return round;
  }

  void add_loops() {
    for (std::size_t k = 0; k < operands_.size(); ++k) {
      const Brep& brep = operands_[k].model.brep;
      for (std::size_t l = 0; l < brep.loops.size(); ++l) {
        if (is_kept(k, brep.loops[LoopId(l)].face)) add_kept_loop(k, LoopId(l));
      }
    }
    for (std::size_t b = 0; b < divided_.boundaries.piece.size(); ++b) {
      const ModelFaceId face = new_face_[divided_.boundaries.piece[b]];
      if (!face.is_valid()) continue;
      for (const HalfEdge h : divided_.boundaries.half_edges.of(BoundaryId(b))) {
        parts_.loops.items.push_back(of_result(origin_of(part_.mesh, h)));
      }
      close_loop(face);
    }
    for (const TouchedVertex& t : divided_.boundaries.touched) {
      if (!new_face_[t.piece].is_valid()) continue;
      parts_.loops.items.push_back(of_result(t.vertex));
      close_loop(new_face_[t.piece]);
    }
  }

  void add_kept_loop(std::size_t k, LoopId l) {
    const auto& [brep, classification] = operands_[k].model;
    const OldFaceId face = kept_.old_face(k, brep.loops[l].face);
    std::vector<VertexId> vertices;
    for (const EdgeUse& use : brep.uses_of_loop.of(l)) {
      std::vector<VertexId> along = image_of_path(k, use.edge);
      if (use.is_reversed) std::reverse(along.begin(), along.end());
      vertices.insert(vertices.end(), along.begin(), along.end() - 1);
    }
    if (vertices.empty()) vertices.push_back(image(k, classification.mesh_vertex[brep.loops[l].start]));
    if (kept_.is_flipped[face] != 0) std::reverse(vertices.begin(), vertices.end());
    parts_.loops.items.insert(parts_.loops.items.end(), vertices.begin(), vertices.end());
    close_loop(kept_face_[face]);
  }

  void close_loop(ModelFaceId face) {
    parts_.loops.close();
    parts_.face_of_loop.push_back(face);
  }

  const SurfaceMesh& mesh_;
  const Provenance& provenance_;
  std::span<const OperandModel> operands_;
  const BrepRules& rules_;
  KeptFaces kept_;
  std::vector<std::uint8_t> is_touched_vertex_;  // per vertex of the result: of a touched face
  MeshPart part_;                                // what is visited
  MeshTopology topology_;                        // of the part
  DividedMesh divided_;                          // the part
  std::vector<ModelFaceId> new_face_;            // per piece of the part; invalid for known ones
  IdVector<OldFaceId, ModelFaceId> kept_face_;
  BrepParts parts_;
  RebuiltBrep result_;
};

}  // namespace

RebuiltBrep rebuild_brep(const SurfaceMesh& mesh, const Provenance& provenance, std::span<const OperandModel> operands,
                         const BrepRules& rules) {
  refuse_bad_input(mesh, provenance, rules);
  return BrepRebuilder(mesh, provenance, operands, rules).rebuild();
}

}  // namespace mortise
