// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Compacts points, turns facets outwards, joins label names, writes provenance.
#include "mortise/boolean/merge.h"

#include <algorithm>
#include <map>
#include <string>

#include "mortise/base/error.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/face_marks.h"

namespace mortise {
namespace {

// Vertices of the result for the points in use, ascending.
std::vector<VertexId> number_points(const OperandFaces& faces, const Facets& facets, std::span<const KeptFacet> kept, MergedMesh& merged) {
  std::vector<VertexId> vertex_of(faces.points.size());
  std::vector<std::uint8_t> is_used(faces.points.size(), 0);
  for (const KeptFacet& k : kept) {
    for (const PointId p : facets.corners[k.facet]) is_used[p.index()] = 1;
  }
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i] == 0) continue;
    vertex_of[i] = VertexId(merged.mesh.points.size());
    merged.mesh.points.push_back(faces.points.nearest(PointId(i)));
    merged.point_of_vertex.push_back(PointId(i));
  }
  return vertex_of;
}

void add_facet(const OperandFaces& faces, const Facets& facets, const KeptFacet& kept, Provenance& provenance) {
  const auto sources = facets.sources_of(kept.facet);
  const SourceId first = sources.front().face;
  provenance.source_operand.push_back(faces.operand[first].value);
  provenance.source_face.push_back(faces.face_in_operand(first));
  provenance.flipped.push_back(kept.is_flipped ? 1 : 0);
  provenance.category.push_back(kept.category);
  provenance.other_source_begin.push_back(static_cast<std::uint32_t>(provenance.other_source_face.size()));
  for (const FacetSource& s : sources.subspan(1)) {
    provenance.other_source_operand.push_back(faces.operand[s.face].value);
    provenance.other_source_face.push_back(faces.face_in_operand(s.face));
    provenance.other_source_flipped.push_back(s.is_opposite != kept.is_flipped ? 1 : 0);
  }
}

// Numbers the sets of operands round the kept facets: equal ones are stored once, in the order of the first facet.
class CoveringSets {
 public:
  CoveringSets(const Selection& selection, std::vector<std::vector<std::uint32_t>>& sets)
      : selection_(selection), sets_(sets), number_of_region_(selection.operands_inside.size(), Provenance::none) {}

  [[nodiscard]] std::uint32_t number_of(RegionId r) {
    std::uint32_t& number = number_of_region_[r];
    if (number != Provenance::none) return number;
    const std::vector<OperandId>& operands = selection_.operands_inside[r];
    const auto [found, is_new] = number_of_set_.try_emplace(operands, static_cast<std::uint32_t>(sets_.size()));
    number = found->second;
    if (!is_new) return number;
    sets_.emplace_back();
    for (const OperandId o : operands) sets_.back().push_back(o.value);
    return number;
  }
  [[nodiscard]] IdVector<RegionId, std::uint32_t> take() { return std::move(number_of_region_); }

 private:
  const Selection& selection_;
  std::vector<std::vector<std::uint32_t>>& sets_;
  std::map<std::vector<OperandId>, std::uint32_t> number_of_set_;
  IdVector<RegionId, std::uint32_t> number_of_region_;
};

void add_covering(const Selection& selection, MergedMesh& merged) {
  Provenance& provenance = merged.provenance;
  CoveringSets sets(selection, provenance.covering_sets);
  provenance.keeps_regions_apart = selection.keeps_regions_apart;
  for (const KeptFacet& k : selection.kept) {
    provenance.covering.push_back(sets.number_of(k.inside));
    if (selection.keeps_walls) provenance.covering_front.push_back(sets.number_of(k.outside));
  }
  merged.covering_of_region = sets.take();
}

void add_walls(MergedMesh& merged) {
  if (std::none_of(merged.facet_of_triangle.begin(), merged.facet_of_triangle.end(), [](const KeptFacet& k) { return k.is_wall; })) return;
  for (const KeptFacet& k : merged.facet_of_triangle) merged.mesh.walls.push_back(k.is_wall ? 1 : 0);
}

void add_vertex_sources(const OperandFaces& faces, MergedMesh& merged) {
  std::vector<std::uint32_t> operand(faces.points.input_count(), Provenance::none);
  std::vector<std::uint32_t> vertex(faces.points.input_count(), Provenance::none);
  for (std::size_t k = faces.operand_count(); k-- > 0;) {
    const std::vector<PointId>& point_of = faces.point_of_vertex[OperandId(k)];
    for (std::size_t v = point_of.size(); v-- > 0;) {
      operand[point_of[v].index()] = static_cast<std::uint32_t>(k);
      vertex[point_of[v].index()] = static_cast<std::uint32_t>(v);
    }
  }
  for (const PointId p : merged.point_of_vertex) {
    const bool is_input = faces.points.is_input(p);
    merged.provenance.vertex_operand.push_back(is_input ? operand[p.index()] : Provenance::none);
    merged.provenance.vertex_source.push_back(is_input ? vertex[p.index()] : Provenance::none);
  }
}

// Label of the result for each label of each operand; equal names are one label.
std::vector<std::vector<std::uint32_t>> join_label_names(std::span<const SurfaceMesh* const> operands, std::vector<std::string>& names) {
  std::vector<std::vector<std::uint32_t>> label_of(operands.size());
  const auto label = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::uint32_t>(found - names.begin());
    names.push_back(name);
    return static_cast<std::uint32_t>(names.size() - 1);
  };
  for (std::size_t k = 0; k < operands.size(); ++k) {
    if (operands[k]->face_labels.empty()) {
      label_of[k].push_back(label(""));
      continue;
    }
    for (const std::string& name : operands[k]->label_names) label_of[k].push_back(label(name));
  }
  return label_of;
}

void add_labels(std::span<const SurfaceMesh* const> operands, MergedMesh& merged) {
  if (std::all_of(operands.begin(), operands.end(), [](const SurfaceMesh* m) { return m->face_labels.empty(); })) return;
  const auto label_of = join_label_names(operands, merged.mesh.label_names);
  for (std::size_t f = 0; f < merged.mesh.triangles.size(); ++f) {
    const std::uint32_t k = merged.provenance.source_operand[f];
    const auto& labels = operands[k]->face_labels;
    merged.mesh.face_labels.push_back(label_of[k][labels.empty() ? 0 : labels[merged.provenance.source_face[f]]]);
  }
}

// The diagonals of faces that came through whole.
void add_diagonals(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, const Facets& facets, MergedMesh& merged) {
  if (std::all_of(operands.begin(), operands.end(), [](const SurfaceMesh* m) { return m->diagonals.empty(); })) return;
  for (std::size_t t = 0; t < merged.mesh.triangles.size(); ++t) {
    const auto& diagonals = operands[merged.provenance.source_operand[t]]->diagonals;
    const std::uint8_t bits = diagonals.empty() ? std::uint8_t{0} : diagonals[merged.provenance.source_face[t]];
    const SourceId face = facets.sources_of(merged.facet_of_triangle[t].facet).front().face;
    PlanePoints corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = merged.point_of_vertex[merged.mesh.triangles[t][i].index()];
    merged.mesh.diagonals.push_back(diagonals_from(faces.corners[face], bits, corners));
  }
  const auto& bits = merged.mesh.diagonals;
  if (std::all_of(bits.begin(), bits.end(), [](std::uint8_t b) { return b == 0; })) merged.mesh.diagonals.clear();
}

// How far the farthest moves.
double round_to_float32(std::vector<Vec3d>& points) {
  double farthest = 0;
  for (Vec3d& p : points) {
    if (!fits_float32(p)) throw Error(ErrorCode::OutOfRange, "merge", "a coordinate of the result is too large for float32");
    const Vec3d rounded = nearest_float32(p);
    farthest = std::max(farthest, length(rounded - p));
    p = rounded;
  }
  return farthest;
}

}  // namespace

MergedMesh merge(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, const Facets& facets, const Selection& selection,
                 Coordinates coordinates) {
  MergedMesh merged;
  const std::vector<KeptFacet>& kept = selection.kept;
  const std::vector<VertexId> vertex_of = number_points(faces, facets, kept, merged);
  if (coordinates == Coordinates::Float32) merged.rounding_displacement = round_to_float32(merged.mesh.points);
  merged.mesh.triangles.reserve(kept.size());
  merged.facet_of_triangle = kept;
  merged.keeps_all_sources = selection.keeps_all_sources;
  merged.is_repaired.assign(kept.size(), 0);
  for (const KeptFacet& k : kept) {
    const PlanePoints& c = facets.corners[k.facet];
    Triangle t{vertex_of[c[0].index()], vertex_of[c[1].index()], vertex_of[c[2].index()]};
    if (k.is_flipped) std::swap(t[1], t[2]);
    merged.mesh.triangles.push_back(t);
    add_facet(faces, facets, k, merged.provenance);
  }
  merged.provenance.other_source_begin.push_back(static_cast<std::uint32_t>(merged.provenance.other_source_face.size()));
  add_covering(selection, merged);
  if (selection.keeps_walls) add_walls(merged);
  add_vertex_sources(faces, merged);
  add_labels(operands, merged);
  add_diagonals(operands, faces, facets, merged);
  return merged;
}

}  // namespace mortise
