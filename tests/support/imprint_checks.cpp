// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Imprints operand by operand.
#include "support/imprint_checks.h"

#include <algorithm>
#include <map>
#include <set>

#include "support/equal_bits.h"

namespace mortise::test {
namespace {

using oracle::Rational;
using oracle::RationalPoint;
using Edge = std::array<std::uint32_t, 2>;

class Faults {
 public:
  void check(bool is_right, const std::string& fault, std::size_t at) {
    if (!is_right && text_.size() < 2000) text_ += fault + " at " + std::to_string(at) + "\n";
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The same corners in the same sense (1), the other sense (-1), or other corners (0).
int sense_of(const Triangle& a, const std::array<std::uint32_t, 3>& b) {
  for (std::size_t turn = 0; turn < 3; ++turn) {
    if (a[turn].value != b[0]) continue;
    if (a[(turn + 1) % 3].value == b[1] && a[(turn + 2) % 3].value == b[2]) return 1;
    if (a[(turn + 1) % 3].value == b[2] && a[(turn + 2) % 3].value == b[1]) return -1;
  }
  return 0;
}

/// (operand, face, sense) of every source of a facet.
std::vector<std::array<int, 3>> sources_of(const Provenance& p, std::size_t f) {
  std::vector<std::array<int, 3>> sources{
      {static_cast<int>(p.source_operand[f]), static_cast<int>(p.source_face[f]), p.flipped[f] != 0 ? -1 : 1}};
  for (std::size_t i = p.other_source_begin[f]; i < p.other_source_begin[f + 1]; ++i) {
    sources.push_back(
        {static_cast<int>(p.other_source_operand[i]), static_cast<int>(p.other_source_face[i]), p.other_source_flipped[i] != 0 ? -1 : 1});
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

std::array<std::uint32_t, 3> common_corners(const ImprintedOperand& operand, std::size_t t) {
  const Triangle& c = operand.mesh.triangles[t];
  return {operand.vertex_ids[c[0].index()], operand.vertex_ids[c[1].index()], operand.vertex_ids[c[2].index()]};
}

bool has_equal_sizes(const ImprintedOperand& operand) {
  const std::size_t triangles = operand.mesh.triangles.size(), vertices = operand.mesh.points.size();
  return operand.facet_ids.size() == triangles && operand.source_face.size() == triangles && operand.category.size() == triangles &&
         operand.vertex_ids.size() == vertices && operand.source_vertex.size() == vertices;
}

void check_vertices(const SurfaceMesh& given, const ImprintedOperand& operand, const SurfaceMesh& whole, Faults& faults) {
  for (std::size_t v = 0; v < operand.vertex_ids.size(); ++v) {
    faults.check(v == 0 || operand.vertex_ids[v - 1] < operand.vertex_ids[v], "vertex ids not ascending", v);
    faults.check(have_equal_bits(operand.mesh.points[v], whole.points.at(operand.vertex_ids[v])), "other doubles than the whole", v);
    const std::uint32_t source = operand.source_vertex[v];
    if (source != Provenance::none) faults.check(operand.mesh.points[v] == given.points.at(source), "moved input vertex", v);
  }
}

void check_triangles(const SurfaceMesh& given, const ImprintedOperand& operand, const SurfaceMesh& whole, Faults& faults) {
  for (std::size_t t = 0; t < operand.facet_ids.size(); ++t) {
    faults.check(sense_of(whole.triangles.at(operand.facet_ids[t]), common_corners(operand, t)) != 0, "other corners than its facet", t);
    faults.check(t == 0 || operand.source_face[t - 1] <= operand.source_face[t], "not in the order of the faces", t);
    faults.check(operand.source_face[t] < given.triangles.size(), "no such face", t);
  }
  const bool has_labels = !given.face_labels.empty();
  faults.check(operand.mesh.face_labels.size() == (has_labels ? operand.facet_ids.size() : 0), "labels of another size", 0);
  faults.check(operand.mesh.label_names == given.label_names, "other label names", 0);
  for (std::size_t t = 0; has_labels && t < operand.facet_ids.size(); ++t) {
    faults.check(operand.mesh.face_labels[t] == given.face_labels[operand.source_face[t]], "other label than its face", t);
  }
}

/// Input positions that faces with area use and no vertex of the operand has, nor the list of those that had to move.
void check_no_vertex_lost(std::uint32_t k, const SurfaceMesh& given, const ImprintResult& result, Faults& faults) {
  auto found = sorted_points(result.operands[k].mesh);
  for (const OperandVertex& moved : result.whole.report.certificate.moved_input_vertices) {
    if (moved.operand != k) continue;
    const Vec3d& p = given.points.at(moved.vertex);
    found.push_back({p.x, p.y, p.z});
  }
  std::sort(found.begin(), found.end());
  for (std::size_t f = 0; f < given.triangles.size(); ++f) {
    const oracle::Corners c = oracle::corners_of(given, f);
    const Vec3d normal = cross(c[1] - c[0], c[2] - c[0]);
    if (!(dot(normal, normal) > 0)) continue;
    for (const Vec3d& p : c) {
      const bool is_there = std::binary_search(found.begin(), found.end(), std::array<double, 3>{p.x, p.y, p.z});
      faults.check(is_there, "a vertex is lost at face", f);
    }
  }
}

RationalPoint difference(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Twice the vector of area.
RationalPoint area_vector(const std::array<RationalPoint, 3>& c) {
  const RationalPoint u = difference(c[1], c[0]), v = difference(c[2], c[0]);
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

bool is_zero(const RationalPoint& p) { return p[0] == 0 && p[1] == 0 && p[2] == 0; }

void check_areas(const SurfaceMesh& given, const ImprintedOperand& operand, const std::vector<RationalPoint>& positions, Faults& faults) {
  std::vector<RationalPoint> left;
  for (std::size_t f = 0; f < given.triangles.size(); ++f) {
    const oracle::Corners c = oracle::corners_of(given, f);
    left.push_back(area_vector({oracle::exact(c[0]), oracle::exact(c[1]), oracle::exact(c[2])}));
  }
  for (std::size_t t = 0; t < operand.facet_ids.size(); ++t) {
    const auto c = common_corners(operand, t);
    RationalPoint& of_face = left[operand.source_face[t]];
    of_face = difference(of_face, area_vector({positions[c[0]], positions[c[1]], positions[c[2]]}));
  }
  for (std::size_t f = 0; f < left.size(); ++f) faults.check(is_zero(left[f]), "triangles do not add up to face", f);
}

/// By a ray from the middle of the triangle; a winding counts where it is positive.
FacetCategory expected_category(std::span<const SurfaceMesh* const> operands, std::size_t own, const RationalPoint& middle,
                                const std::vector<std::array<int, 3>>& sources, int sense) {
  bool is_on = false;
  for (const auto& [operand, face, other_sense] : sources) {
    if (static_cast<std::size_t>(operand) == own) continue;
    if (other_sense == sense) return FacetCategory::OnSame;
    is_on = true;
  }
  if (is_on) return FacetCategory::OnOpposite;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    if (k != own && oracle::winding_number(*operands[k], middle).value_or(0) > 0) return FacetCategory::Inside;
  }
  return FacetCategory::Outside;
}

void check_categories(std::span<const SurfaceMesh* const> operands, std::size_t k, const ImprintResult& result,
                      const std::vector<RationalPoint>& positions, Faults& faults) {
  const ImprintedOperand& operand = result.operands[k];
  for (std::size_t t = 0; t < operand.facet_ids.size(); ++t) {
    const auto c = common_corners(operand, t);
    RationalPoint middle;
    for (std::size_t i = 0; i < 3; ++i) middle[i] = (positions[c[0]][i] + positions[c[1]][i] + positions[c[2]][i]) / 3;
    const int sense = sense_of(result.whole.mesh.triangles[operand.facet_ids[t]], c);
    const auto sources = sources_of(result.whole.provenance, operand.facet_ids[t]);
    faults.check(operand.category[t] == expected_category(operands, k, middle, sources, sense), "wrong category", t);
  }
}

void add_edges(const Triangle& t, const std::vector<std::uint32_t>* ids, std::set<Edge>& edges) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t u = ids != nullptr ? (*ids)[t[i].index()] : t[i].value;
    const std::uint32_t v = ids != nullptr ? (*ids)[t[(i + 1) % 3].index()] : t[(i + 1) % 3].value;
    edges.insert({std::min(u, v), std::max(u, v)});
  }
}

std::set<Edge> edges_of(const SurfaceMesh& mesh, const std::vector<std::uint32_t>* ids) {
  std::set<Edge> edges;
  for (const Triangle& t : mesh.triangles) add_edges(t, ids, edges);
  return edges;
}

}  // namespace

std::string faults_of_numbering(std::span<const SurfaceMesh* const> operands, const ImprintResult& result) {
  Faults faults;
  std::vector<std::vector<std::array<int, 3>>> found(result.whole.mesh.triangles.size());
  faults.check(result.operands.size() == operands.size(), "not all operands", result.operands.size());
  for (std::size_t k = 0; k < result.operands.size(); ++k) {
    const ImprintedOperand& operand = result.operands[k];
    faults.check(has_equal_sizes(operand), "arrays differ in size in operand", k);
    if (!faults.text().empty()) return faults.text();
    check_vertices(*operands[k], operand, result.whole.mesh, faults);
    check_triangles(*operands[k], operand, result.whole.mesh, faults);
    check_no_vertex_lost(static_cast<std::uint32_t>(k), *operands[k], result, faults);
    for (std::size_t t = 0; t < operand.facet_ids.size(); ++t) {
      const int sense = sense_of(result.whole.mesh.triangles[operand.facet_ids[t]], common_corners(operand, t));
      found[operand.facet_ids[t]].push_back({static_cast<int>(k), static_cast<int>(operand.source_face[t]), sense});
    }
  }
  for (std::size_t f = 0; f < found.size(); ++f) {
    std::sort(found[f].begin(), found[f].end());
    faults.check(found[f] == sources_of(result.whole.provenance, f), "other operands than its sources in facet", f);
  }
  return faults.text();
}

std::string faults_of_split(std::span<const SurfaceMesh* const> operands, const ImprintResult& result) {
  Faults faults;
  const std::vector<RationalPoint> positions = exact_positions(operands, result.whole);
  for (std::size_t k = 0; k < operands.size(); ++k) {
    check_areas(*operands[k], result.operands[k], positions, faults);
    check_categories(operands, k, result, positions, faults);
  }
  return faults.text() + faults_of_provenance(operands, result.whole, Repairs::None);
}

std::vector<std::array<std::uint32_t, 2>> shared_edges(const ImprintResult& result) {
  std::map<Edge, std::size_t> count;
  for (const ImprintedOperand& operand : result.operands) {
    for (const Edge& e : edges_of(operand.mesh, &operand.vertex_ids)) ++count[e];
  }
  std::vector<Edge> shared;
  for (const auto& [edge, operands] : count) {
    if (operands > 1) shared.push_back(edge);
  }
  return shared;
}

std::vector<SurfaceMesh> imprinted_meshes(const ImprintResult& result) {
  std::vector<SurfaceMesh> meshes;
  for (const ImprintedOperand& operand : result.operands) meshes.push_back(operand.mesh);
  return meshes;
}

std::vector<std::size_t> counts_of(const ImprintResult& result) {
  const auto add = [](const SurfaceMesh& mesh, std::vector<std::size_t>& counts) {
    counts.insert(counts.end(), {mesh.points.size(), edges_of(mesh, nullptr).size(), mesh.triangles.size()});
  };
  std::vector<std::size_t> counts;
  for (const ImprintedOperand& operand : result.operands) add(operand.mesh, counts);
  add(result.whole.mesh, counts);
  return counts;
}

}  // namespace mortise::test
