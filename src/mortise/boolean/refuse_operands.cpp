// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Turns unbalanced edges of the arrangement into errors about edges of the operand.
#include "mortise/boolean/refuse_operands.h"

#include <algorithm>
#include <string>

namespace mortise {
namespace {

constexpr const char* stage_name = "categorize";

// A directed edge of an operand as often as its faces run along it, less as often as they run against it.
struct EdgeOfOperand {
  std::uint64_t key;  // smaller point, larger point
  std::uint32_t from, to;
  bool is_forward;
};

std::vector<EdgeOfOperand> edges_of(const SurfaceMesh& mesh, const OperandFaces& faces, OperandId k) {
  std::vector<EdgeOfOperand> edges;
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) {
    if (faces.is_wall[SourceId(f)] != 0 && faces.kind[k] != OperandKind::Sheet) continue;
    const PlanePoints& c = faces.corners[SourceId(f)];
    const Triangle& t = mesh.triangles[faces.face_in_operand(SourceId(f))];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (c[i] == c[j]) continue;
      const std::uint64_t key = (std::uint64_t{std::min(c[i], c[j]).value} << 32U) | std::max(c[i], c[j]).value;
      edges.push_back({key, t[i].value, t[j].value, c[i] < c[j]});
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const EdgeOfOperand& a, const EdgeOfOperand& b) { return a.key < b.key; });
  return edges;
}

enum class Which { Open, Even, Any };

// Vertex pairs of the given edges along which not as many faces run one way as the other.
std::vector<std::uint32_t> unbalanced_pairs(const std::vector<EdgeOfOperand>& edges, Which which) {
  std::vector<std::uint32_t> pairs;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    int sum = 0;
    for (; end < edges.size() && edges[end].key == edges[i].key; ++end) sum += edges[end].is_forward ? 1 : -1;
    const bool is_open = (end - i) % 2 != 0;
    if (sum != 0 && (which == Which::Any || is_open == (which == Which::Open))) {
      pairs.push_back(edges[i].from);
      pairs.push_back(edges[i].to);
    }
    i = end;
  }
  return pairs;
}

[[noreturn]] void refuse_unbalanced(const SurfaceMesh& mesh, const OperandFaces& faces, OperandId k, bool is_open) {
  const std::vector<EdgeOfOperand> edges = edges_of(mesh, faces, k);
  std::vector<std::uint32_t> pairs = unbalanced_pairs(edges, is_open ? Which::Open : Which::Even);
  // Edges that only show after splitting lie on given edges that do not balance either.
  if (pairs.empty()) pairs = unbalanced_pairs(edges, Which::Any);
  const std::string operand = "operand " + std::to_string(k.value);
  const std::string count = std::to_string(pairs.size() / 2);
  const std::string sheet = operand + " is a sheet, not a solid: " + count + " open edges";
  const std::string twisted = operand + " is not consistently oriented: faces run the same way along " + count + " edges";
  Error error = is_open ? Error(ErrorCode::NotClosed, stage_name, sheet) : Error(ErrorCode::NotOriented, stage_name, twisted);
  throw std::move(error).with_ids(IdKind::VertexPairs, pairs).in_operand(k.index());
}

void refuse_inside_out(const OperandFaces& faces, OperandId k) {
  std::vector<std::uint32_t> ids(faces.first[OperandId(k.index() + 1)] - faces.first[k]);
  for (std::uint32_t i = 0; i < ids.size(); ++i) ids[i] = i;
  throw Error(ErrorCode::InsideOut, stage_name,
              "operand " + std::to_string(k.value) + " is inside out: its faces run clockwise seen from outside")
      .with_ids(IdKind::Faces, ids)
      .in_operand(k.index());
}

}  // namespace

std::vector<OperandId> find_sheets(const Categories& categories) {
  std::vector<OperandId> sheets;
  for (const UnbalancedEdge& e : categories.patches.unbalanced) {
    if (e.is_open) sheets.push_back(e.operand);
  }
  std::sort(sheets.begin(), sheets.end());
  sheets.erase(std::unique(sheets.begin(), sheets.end()), sheets.end());
  return sheets;
}

std::vector<std::uint32_t> open_edges(const SurfaceMesh& mesh, const OperandFaces& faces, OperandId k) {
  return unbalanced_pairs(edges_of(mesh, faces, k), Which::Open);
}

void refuse_operands(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, const Categories& categories) {
  const auto& unbalanced = categories.patches.unbalanced;
  if (!unbalanced.empty()) {
    const OperandId k = std::min_element(unbalanced.begin(), unbalanced.end(), [](const UnbalancedEdge& a, const UnbalancedEdge& b) {
                          return a.operand < b.operand;
                        })->operand;
    const bool is_open =
        std::any_of(unbalanced.begin(), unbalanced.end(), [&](const UnbalancedEdge& e) { return e.operand == k && e.is_open; });
    refuse_operand(operands, faces, k, is_open ? ErrorCode::NotClosed : ErrorCode::NotOriented);
  }
  if (!categories.inside_out.empty()) refuse_operand(operands, faces, categories.inside_out.front(), ErrorCode::InsideOut);
}

void refuse_operand(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces, OperandId k, ErrorCode code) {
  if (code == ErrorCode::NotClosed || code == ErrorCode::NotOriented)
    refuse_unbalanced(*operands[k.index()], faces, k, code == ErrorCode::NotClosed);
  if (code == ErrorCode::InsideOut) refuse_inside_out(faces, k);
}

}  // namespace mortise
