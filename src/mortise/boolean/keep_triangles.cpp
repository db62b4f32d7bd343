// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Compaction of parallel arrays.
#include "mortise/boolean/keep_triangles.h"

#include <algorithm>

#include "mortise/mesh/corner_data.h"

namespace mortise {
namespace {

void keep_other_sources(Provenance& p, const std::vector<std::uint8_t>& is_kept) {
  std::vector<std::uint8_t> keeps_entry(p.other_source_face.size(), 0);
  std::vector<std::uint32_t> begin{0};
  for (std::size_t t = 0; t < is_kept.size(); ++t) {
    if (is_kept[t] == 0) continue;
    const std::uint32_t count = p.other_source_begin[t + 1] - p.other_source_begin[t];
    std::fill_n(keeps_entry.begin() + p.other_source_begin[t], count, std::uint8_t{1});
    begin.push_back(begin.back() + count);
  }
  keep_marked(p.other_source_operand, keeps_entry);
  keep_marked(p.other_source_face, keeps_entry);
  keep_marked(p.other_source_flipped, keeps_entry);
  p.other_source_begin = std::move(begin);
}

void keep_corner_data(const std::vector<std::uint8_t>& is_kept, SurfaceMesh& mesh) {
  if (mesh.corner_data.empty()) return;
  std::size_t next = 0;
  for (std::size_t t = 0; t < is_kept.size(); ++t) {
    if (is_kept[t] != 0) copy_corner_data(FaceId(t), FaceId(next++), mesh);
  }
  resize_corner_data(mesh);
}

std::vector<std::uint8_t> drop_unused_vertices(SurfaceMesh& mesh, Provenance& provenance) {
  std::vector<std::uint8_t> is_used(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) is_used[v.index()] = 1;
  }
  const std::vector<std::uint32_t> numbers = numbers_of_kept(is_used);
  for (Triangle& t : mesh.triangles) {
    for (VertexId& v : t) v = VertexId(numbers[v.index()]);
  }
  keep_marked(mesh.points, is_used);
  keep_marked(provenance.vertex_operand, is_used);
  keep_marked(provenance.vertex_source, is_used);
  return is_used;
}

}  // namespace

std::vector<std::uint32_t> numbers_of_kept(std::span<const std::uint8_t> is_kept) {
  std::vector<std::uint32_t> numbers;
  std::uint32_t next = 0;
  for (const std::uint8_t stays : is_kept) numbers.push_back(stays != 0 ? next++ : Provenance::none);
  return numbers;
}

std::vector<std::uint32_t> renumbered(std::span<const std::uint32_t> ids, std::span<const std::uint8_t> is_kept) {
  const std::vector<std::uint32_t> numbers = numbers_of_kept(is_kept);
  std::vector<std::uint32_t> result;
  for (const std::uint32_t id : ids) {
    if (is_kept[id] != 0) result.push_back(numbers[id]);
  }
  return result;
}

std::vector<std::uint8_t> keep_triangles(const std::vector<std::uint8_t>& is_kept, SurfaceMesh& mesh, Provenance& provenance) {
  keep_other_sources(provenance, is_kept);
  keep_marked(mesh.triangles, is_kept);
  keep_marked(mesh.face_labels, is_kept);
  keep_marked(mesh.walls, is_kept);
  keep_marked(mesh.diagonals, is_kept);
  keep_corner_data(is_kept, mesh);
  keep_marked(provenance.source_operand, is_kept);
  keep_marked(provenance.source_face, is_kept);
  keep_marked(provenance.flipped, is_kept);
  keep_marked(provenance.category, is_kept);
  keep_marked(provenance.covering, is_kept);
  keep_marked(provenance.covering_front, is_kept);
  return drop_unused_vertices(mesh, provenance);
}

void keep_triangles(const std::vector<std::uint8_t>& is_kept, MergedMesh& merged) {
  keep_marked(merged.facet_of_triangle, is_kept);
  keep_marked(merged.is_repaired, is_kept);
  keep_marked(merged.point_of_vertex, keep_triangles(is_kept, merged.mesh, merged.provenance));
}

}  // namespace mortise
