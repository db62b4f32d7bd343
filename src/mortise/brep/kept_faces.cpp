// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Triangles against their sources, then vertices against their counterparts, then faces.
#include "mortise/brep/kept_faces.h"

#include <algorithm>
#include <optional>
#include <string>

#include "mortise/base/error.h"

namespace mortise {
namespace {

class KeptFacesFinder {
 public:
  KeptFacesFinder(const SurfaceMesh& mesh, const Provenance& provenance, std::span<const OperandModel> operands, const FeatureRules& rules)
      : mesh_(mesh), provenance_(provenance), operands_(operands), rules_(rules), counterparts_(mesh.points.size()) {}

  [[nodiscard]] KeptFaces find() {
    number_faces();
    match_triangles();
    compare_stars();
    find_touched();
    if (rules_.weak_angle_deg || rules_.least_dangling > 0) spread_along_features();
    return std::move(kept_);
  }

 private:
  // The vertex of an operand that a vertex of the result was.
  struct Counterpart {
    std::uint32_t operand = Provenance::none, vertex = 0, triangles = 0;
    bool is_flipped = false, is_changed = false;
  };

  void number_faces() {
    kept_.first_face.push_back(0);
    for (const OperandModel& operand : operands_) {
      kept_.first_face.push_back(kept_.first_face.back() + static_cast<std::uint32_t>(operand.model.brep.faces.size()));
    }
    is_whole_.assign(mesh_.triangles.size(), 0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::uint32_t k = provenance_.source_operand[t], f = provenance_.source_face[t];
      if (k >= operands_.size() || f >= operands_[k].mesh.triangles.size())
        throw Error(ErrorCode::InvalidArgument, "rebuild_brep",
                    "facet " + std::to_string(t) + " comes from a triangle that no operand has");
      kept_.face_of_triangle.push_back(kept_.old_face(k, operands_[k].model.classification.face_of_triangle[f]));
    }
  }

  void match_triangles() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::optional<Triangle> source = whole_source(t);
      is_whole_[t] = source ? 1 : 0;
      for (std::size_t i = 0; i < 3; ++i) {
        Counterpart& c = counterparts_[mesh_.triangles[t][i].index()];
        if (source) {
          meet(c, provenance_.source_operand[t], (*source)[i].value, provenance_.flipped[t] != 0);
        } else {
          c.is_changed = true;
        }
      }
    }
    for (const auto& edge : rules_.user_edges) {
      for (const VertexId v : edge) {
        if (v.index() < counterparts_.size()) counterparts_[v.index()].is_changed = true;
      }
    }
  }

  // The corners of the source of a facet, as those of the facet, when it is all of it and of nothing else.
  [[nodiscard]] std::optional<Triangle> whole_source(std::size_t t) const {
    const Provenance& p = provenance_;
    if (!p.other_source_begin.empty() && p.other_source_begin[t] != p.other_source_begin[t + 1]) return {};
    const SurfaceMesh& operand = operands_[p.source_operand[t]].mesh;
    Triangle source = operand.triangles[p.source_face[t]];
    if (p.flipped[t] != 0) std::swap(source[1], source[2]);
    for (std::size_t turn = 0; turn < 3; ++turn) {
      const auto is_same = [&](std::size_t i) { return mesh_.points[mesh_.triangles[t][i].index()] == operand.points[source[i].index()]; };
      if (is_same(0) && is_same(1) && is_same(2)) return source;
      std::rotate(source.begin(), source.begin() + 1, source.end());
    }
    return {};
  }

  static void meet(Counterpart& c, std::uint32_t operand, std::uint32_t vertex, bool is_flipped) {
    if (c.operand == Provenance::none) {
      c.operand = operand;
      c.vertex = vertex;
      c.is_flipped = is_flipped;
    }
    if (c.operand != operand || c.vertex != vertex || c.is_flipped != is_flipped) c.is_changed = true;
    ++c.triangles;
  }

  void compare_stars() {
    std::vector<std::vector<std::uint32_t>> triangles_at;
    for (const OperandModel& operand : operands_) {
      triangles_at.emplace_back(operand.mesh.points.size(), 0);
      kept_.image.emplace_back(operand.mesh.points.size());
      for (const Triangle& t : operand.mesh.triangles) {
        for (const VertexId v : t) ++triangles_at.back()[v.index()];
      }
    }
    for (std::size_t v = 0; v < counterparts_.size(); ++v) {
      Counterpart& c = counterparts_[v];
      if (c.operand == Provenance::none) continue;
      if (c.triangles != triangles_at[c.operand][c.vertex]) c.is_changed = true;
      if (!c.is_changed) kept_.image[c.operand][c.vertex] = VertexId(v);
    }
  }

  // Untouched: as many triangles as were there, all unchanged and of one kind.
  void find_touched() {
    const std::size_t count = kept_.first_face.back();
    IdVector<OldFaceId, std::uint32_t> missing(count);
    for (std::size_t k = 0; k < operands_.size(); ++k) {
      for (const ModelFaceId f : operands_[k].model.classification.face_of_triangle) ++missing[kept_.old_face(k, f)];
    }
    kept_.is_touched.resize(count);
    kept_.is_flipped.resize(count);
    IdVector<OldFaceId, FaceId> first(count);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const OldFaceId f = kept_.face_of_triangle[t];
      if (!first[f].is_valid()) first[f] = FaceId(t);
      const auto is_changed = [&](VertexId v) { return counterparts_[v.index()].is_changed; };
      const Triangle& corners = mesh_.triangles[t];
      if (is_whole_[t] != 0 && std::none_of(corners.begin(), corners.end(), is_changed)) --missing[f];
      if (!are_alike(FaceId(t), first[f])) kept_.is_touched[f] = 1;
      kept_.is_flipped[f] = provenance_.flipped[t];
    }
    for (std::size_t f = 0; f < count; ++f) {
      if (missing[OldFaceId(f)] != 0) kept_.is_touched[OldFaceId(f)] = 1;
    }
  }

  [[nodiscard]] bool are_alike(FaceId t, FaceId other) const {
    const auto agree = [&](const auto& marks) { return marks.empty() || marks[t.index()] == marks[other.index()]; };
    return agree(mesh_.walls) && agree(rules_.groups);
  }

  // Faces are touched together that edges join, over vertices too.
  void spread_along_features() {
    for (std::size_t k = 0; k < operands_.size(); ++k) {
      const Brep& brep = operands_[k].model.brep;
      const auto face_count = static_cast<std::uint32_t>(brep.faces.size());
      UnionFind joined(face_count + brep.vertex_count);
      for (const ModelLoop& loop : brep.loops) joined.join(loop.face.value, face_count + loop.start.value);
      for (std::size_t e = 0; e < brep.edges.size(); ++e) {
        const ModelEdge& edge = brep.edges[ModelEdgeId(e)];
        joined.join(face_count + edge.start.value, face_count + edge.end.value);
        for (const FaceUse& use : brep.faces_of_edge.of(ModelEdgeId(e))) joined.join(use.face.value, face_count + edge.start.value);
      }
      std::vector<std::uint8_t> is_touched(joined.size(), 0);
      for (std::uint32_t f = 0; f < face_count; ++f) is_touched[joined.find(f)] |= kept_.is_touched[kept_.old_face(k, ModelFaceId(f))];
      for (std::uint32_t f = 0; f < face_count; ++f) kept_.is_touched[kept_.old_face(k, ModelFaceId(f))] = is_touched[joined.find(f)];
    }
  }

  const SurfaceMesh& mesh_;
  const Provenance& provenance_;
  std::span<const OperandModel> operands_;
  const FeatureRules& rules_;
  std::vector<Counterpart> counterparts_;  // per vertex of the result
  std::vector<std::uint8_t> is_whole_;     // per triangle
  KeptFaces kept_;
};

}  // namespace

KeptFaces find_kept_faces(const SurfaceMesh& mesh, const Provenance& provenance, std::span<const OperandModel> operands,
                          const FeatureRules& rules) {
  return KeptFacesFinder(mesh, provenance, operands, rules).find();
}

}  // namespace mortise
