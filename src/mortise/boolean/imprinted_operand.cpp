// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Facets sorted by operand and face, then one operand after the other.
#include "mortise/boolean/imprinted_operand.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mortise/boolean/facet_sources.h"
#include "mortise/mesh/face_marks.h"

namespace mortise {
namespace {

// A triangle of an operand: one of its faces on one facet.
struct OperandTriangle {
  std::uint32_t face, facet;
  bool is_flipped;
  FacetCategory category;
};

std::vector<std::vector<OperandTriangle>> triangles_by_operand(const Provenance& provenance, std::size_t operand_count) {
  std::vector<std::vector<OperandTriangle>> triangles(operand_count);
  for (std::uint32_t f = 0; f < provenance.source_face.size(); ++f) {
    if (provenance.other_source_begin[f] == provenance.other_source_begin[f + 1]) {
      triangles[provenance.source_operand[f]].push_back({provenance.source_face[f], f, provenance.flipped[f] != 0, provenance.category[f]});
      continue;
    }
    const std::vector<SourceFace> sources = facet_sources(provenance, f);
    for (const SourceFace& s : sources) {
      triangles[s.operand].push_back({s.face, f, s.is_flipped, category_seen_from(s, sources, provenance, f)});
    }
  }
  for (auto& list : triangles) {
    std::stable_sort(list.begin(), list.end(), [](const OperandTriangle& a, const OperandTriangle& b) { return a.face < b.face; });
  }
  return triangles;
}

// Reads operands off the whole, one after the other.
class OperandReader {
 public:
  explicit OperandReader(const SurfaceMesh& whole) : whole_(whole), number_(whole.points.size()) {}

  [[nodiscard]] ImprintedOperand read(const SurfaceMesh& given, const std::vector<OperandTriangle>& triangles) {
    result_ = {};
    number_vertices(triangles);
    for (const OperandTriangle& t : triangles) add(t, given);
    for (const std::uint32_t id : result_.vertex_ids) number_[id] = VertexId();
    result_.mesh.label_names = given.label_names;
    for (std::size_t i = 0; i < triangles.size(); ++i) add_marks(FaceId(i), FaceId(triangles[i].face), given);
    return std::move(result_);
  }

 private:
  void number_vertices(const std::vector<OperandTriangle>& triangles) {
    std::vector<std::uint32_t>& ids = result_.vertex_ids;
    for (const OperandTriangle& t : triangles) {
      for (const VertexId v : whole_.triangles[t.facet]) {
        if (number_[v.index()].is_valid()) continue;
        number_[v.index()] = VertexId(0U);
        ids.push_back(v.value);
      }
    }
    std::sort(ids.begin(), ids.end());
    for (std::size_t i = 0; i < ids.size(); ++i) number_[ids[i]] = VertexId(i);
    for (const std::uint32_t id : ids) result_.mesh.points.push_back(whole_.points[id]);
    result_.source_vertex.assign(ids.size(), Provenance::none);
  }

  void add(const OperandTriangle& t, const SurfaceMesh& given) {
    const Triangle& c = whole_.triangles[t.facet];
    Triangle corners{number_[c[0].index()], number_[c[1].index()], number_[c[2].index()]};
    if (t.is_flipped) std::swap(corners[1], corners[2]);
    for (const VertexId v : corners) find_source(v, given, given.triangles[t.face]);
    result_.mesh.triangles.push_back(corners);
    result_.facet_ids.push_back(t.facet);
    result_.source_face.push_back(t.face);
    result_.category.push_back(t.category);
  }

  void add_marks(FaceId f, FaceId source, const SurfaceMesh& given) {
    append_face_marks(given, source, result_.mesh);
    if (given.diagonals.empty()) return;
    std::uint8_t& bits = result_.mesh.diagonals.back();
    bits = diagonals_from(positions_of(given, source), bits, positions_of(result_.mesh, f));
  }

  static std::array<Vec3d, 3> positions_of(const SurfaceMesh& mesh, FaceId f) {
    const Triangle& t = mesh.triangles[f.index()];
    return {mesh.points[t[0].index()], mesh.points[t[1].index()], mesh.points[t[2].index()]};
  }

  // A vertex of the operand is a corner of one of the faces round it.
  void find_source(VertexId v, const SurfaceMesh& given, const Triangle& face) {
    std::uint32_t& source = result_.source_vertex[v.index()];
    for (const VertexId corner : face) {
      if (given.points[corner.index()] == result_.mesh.points[v.index()]) source = std::min(source, corner.value);
    }
  }

  const SurfaceMesh& whole_;
  std::vector<VertexId> number_;  // per vertex of the whole: in the operand being read
  ImprintedOperand result_;
};

}  // namespace

std::vector<ImprintedOperand> read_operands(std::span<const SurfaceMesh* const> operands, const SurfaceMesh& all_facets,
                                            const Provenance& provenance) {
  const auto triangles = triangles_by_operand(provenance, operands.size());
  OperandReader reader(all_facets);
  std::vector<ImprintedOperand> imprinted;
  for (std::size_t k = 0; k < operands.size(); ++k) imprinted.push_back(reader.read(*operands[k], triangles[k]));
  return imprinted;
}

std::vector<const SurfaceMesh*> meshes_of(std::span<const ImprintedOperand> operands) {
  std::vector<const SurfaceMesh*> meshes;
  for (const ImprintedOperand& o : operands) meshes.push_back(&o.mesh);
  return meshes;
}

}  // namespace mortise
