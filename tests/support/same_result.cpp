// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Compares results array by array.
#include "support/same_result.h"

#include <cstring>
#include <type_traits>
#include <vector>

#include "mortise/base/error.h"
#include "support/mesh_checks.h"

namespace mortise::test {
namespace {

class Differences {
 public:
  template <class T>
  void compare(const char* name, const T& a, const T& b) {
    if (!is_same(a, b)) names_ += std::string(name) + " ";
  }
  [[nodiscard]] std::string names() && { return std::move(names_); }

 private:
  template <class T>
  static bool is_same(const T& a, const T& b) {
    return a == b;
  }
  static bool is_same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
  template <class Numbers>
  static bool has_same_bytes(const Numbers& a, const Numbers& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
  }
  static bool is_same(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) { return has_same_bytes(a, b); }
  static bool is_same(const std::vector<double>& a, const std::vector<double>& b) { return has_same_bytes(a, b); }

  std::string names_;
};

void compare(const std::vector<DataChannel>& a, const std::vector<DataChannel>& b, Differences& differences) {
  differences.compare("number of channels", a.size(), b.size());
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    differences.compare("channel name", a[i].name, b[i].name);
    differences.compare("components", a[i].components, b[i].components);
    differences.compare("channel kind", a[i].kind, b[i].kind);
    differences.compare("values", a[i].values, b[i].values);
  }
}

void compare(const SurfaceMesh& a, const SurfaceMesh& b, Differences& differences) {
  differences.compare("points", a.points, b.points);
  differences.compare("triangles", a.triangles, b.triangles);
  differences.compare("face_labels", a.face_labels, b.face_labels);
  differences.compare("label_names", a.label_names, b.label_names);
  differences.compare("walls", a.walls, b.walls);
  differences.compare("diagonals", a.diagonals, b.diagonals);
  compare(a.vertex_data, b.vertex_data, differences);
  compare(a.corner_data, b.corner_data, differences);
}

void compare(const Provenance& a, const Provenance& b, Differences& differences) {
  differences.compare("source_operand", a.source_operand, b.source_operand);
  differences.compare("source_face", a.source_face, b.source_face);
  differences.compare("flipped", a.flipped, b.flipped);
  differences.compare("category", a.category, b.category);
  differences.compare("covering", a.covering, b.covering);
  differences.compare("covering_sets", a.covering_sets, b.covering_sets);
  differences.compare("covering_front", a.covering_front, b.covering_front);
  differences.compare("other_source_begin", a.other_source_begin, b.other_source_begin);
  differences.compare("other_source_operand", a.other_source_operand, b.other_source_operand);
  differences.compare("other_source_face", a.other_source_face, b.other_source_face);
  differences.compare("other_source_flipped", a.other_source_flipped, b.other_source_flipped);
  differences.compare("vertex_operand", a.vertex_operand, b.vertex_operand);
  differences.compare("vertex_source", a.vertex_source, b.vertex_source);
}

void compare(const Certificate& a, const Certificate& b, Differences& differences) {
  differences.compare("status", a.status, b.status);
  differences.compare("level", a.level, b.level);
  differences.compare("triangles_tested", a.triangles_tested, b.triangles_tested);
  differences.compare("pairs_tested", a.pairs_tested, b.pairs_tested);
  differences.compare("inherited_pairs", a.inherited_pairs, b.inherited_pairs);
  differences.compare("largest_displacement", a.largest_displacement, b.largest_displacement);
  differences.compare("repair_displacement", a.repair_displacement, b.repair_displacement);
  differences.compare("merge_rounds", a.merge_rounds, b.merge_rounds);
  differences.compare("swap_rounds", a.swap_rounds, b.swap_rounds);
  differences.compare("failed_faces", a.failed_faces, b.failed_faces);
}

void compare(const BooleanReport& a, const BooleanReport& b, Differences& differences) {
  compare(a.certificate, b.certificate, differences);
  differences.compare("contact.points", a.contact.points, b.contact.points);
  differences.compare("contact.length", a.contact.length, b.contact.length);
  differences.compare("contact.area", a.contact.area, b.contact.area);
  differences.compare("self_contacts", a.self_contacts, b.self_contacts);
  differences.compare("number of sheets", a.sheets.size(), b.sheets.size());
  for (std::size_t i = 0; i < a.sheets.size() && i < b.sheets.size(); ++i) {
    differences.compare("sheet", a.sheets[i].operand, b.sheets[i].operand);
    differences.compare("open_edges", a.sheets[i].open_edges, b.sheets[i].open_edges);
  }
  differences.compare("notes", a.notes, b.notes);
}

void compare(const ImprintedOperand& a, const ImprintedOperand& b, Differences& differences) {
  compare(a.mesh, b.mesh, differences);
  differences.compare("vertex_ids", a.vertex_ids, b.vertex_ids);
  differences.compare("facet_ids", a.facet_ids, b.facet_ids);
  differences.compare("source_vertex", a.source_vertex, b.source_vertex);
  differences.compare("source_face", a.source_face, b.source_face);
  differences.compare("category", a.category, b.category);
}

}  // namespace

std::string difference_of(const BooleanResult& a, const BooleanResult& b) {
  Differences differences;
  compare(a.mesh, b.mesh, differences);
  compare(a.provenance, b.provenance, differences);
  differences.compare("graph.points", a.graph.points, b.graph.points);
  differences.compare("graph.edges", a.graph.edges, b.graph.edges);
  differences.compare("graph.chains", a.graph.chains, b.graph.chains);
  compare(a.report, b.report, differences);
  return std::move(differences).names();
}

std::string difference_of(const ImprintResult& a, const ImprintResult& b) {
  Differences differences;
  differences.compare("number of operands", a.operands.size(), b.operands.size());
  for (std::size_t k = 0; k < a.operands.size() && k < b.operands.size(); ++k) compare(a.operands[k], b.operands[k], differences);
  return difference_of(a.whole, b.whole) + std::move(differences).names();
}

std::string difference_of(const Error& a, const Error& b) {
  Differences differences;
  differences.compare("code", a.code, b.code);
  differences.compare("stage", a.stage, b.stage);
  differences.compare("message", a.message, b.message);
  differences.compare("id_kind", a.id_kind, b.id_kind);
  differences.compare("ids", a.ids, b.ids);
  differences.compare("operand", a.operand, b.operand);
  return std::move(differences).names();
}

}  // namespace mortise::test
