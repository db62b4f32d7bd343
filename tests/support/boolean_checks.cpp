// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Checks on results: topology by sorting edges, provenance in rationals.
#include "support/boolean_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

#include "support/equal_bits.h"

namespace mortise::test {
namespace {

using oracle::Corners;
using oracle::RationalPoint;

/// Collects the first faults of each kind, so that a broken result does not print a book.
class Faults {
 public:
  void add(const std::string& kind, std::size_t place) {
    std::size_t& count = counts_[kind];
    if (++count <= 3) text_ += kind + " (at " + std::to_string(place) + ")\n";
  }
  [[nodiscard]] std::string text() const {
    std::string all = text_;
    for (const auto& [kind, count] : counts_) {
      if (count > 3) all += kind + ": " + std::to_string(count) + " in all\n";
    }
    return all;
  }

 private:
  std::map<std::string, std::size_t> counts_;
  std::string text_;
};

struct EdgeUse {
  std::uint32_t low, high;
  std::uint32_t face;
  int direction;  ///< +1: the face runs from low to high
};

std::vector<EdgeUse> sorted_edge_uses(const SurfaceMesh& mesh) {
  std::vector<EdgeUse> uses;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = mesh.triangles[f][i].value, to = mesh.triangles[f][(i + 1) % 3].value;
      uses.push_back({std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(f), from < to ? 1 : -1});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const EdgeUse& a, const EdgeUse& b) { return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face); });
  return uses;
}

/// Calls visit(first, last) for every group of faces on one edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, const Visit& visit) {
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last = std::find_if(first, uses.end(), [&](const EdgeUse& u) { return u.low != first->low || u.high != first->high; });
    visit(std::span<const EdgeUse>(&*first, static_cast<std::size_t>(last - first)));
    first = last;
  }
}

class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  std::size_t count() {
    std::size_t roots = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) roots += root(i) == i ? 1 : 0;
    return roots;
  }

 private:
  std::vector<std::size_t> parent_;
};

std::size_t corner_at(const SurfaceMesh& mesh, std::uint32_t face, std::uint32_t vertex) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (mesh.triangles[face][i].value == vertex) return 3 * std::size_t{face} + i;
  }
  throw std::logic_error("an edge of a face without its vertex");
}

double area_of(const SurfaceMesh& mesh) {
  long double sum = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Corners c = oracle::corners_of(mesh, f);
    const Vec3d n = cross(c[1] - c[0], c[2] - c[0]);
    sum += std::sqrt(static_cast<long double>(dot(n, n))) / 2;
  }
  return static_cast<double>(sum);
}

void check_sizes(const BooleanResult& result, Faults& faults) {
  const std::size_t facets = result.mesh.triangles.size(), vertices = result.mesh.points.size();
  const Provenance& p = result.provenance;
  if (p.source_operand.size() != facets || p.source_face.size() != facets || p.flipped.size() != facets)
    faults.add("facet arrays differ in size", facets);
  if (p.other_source_begin.size() != facets + 1 || p.other_source_begin.back() != p.other_source_operand.size() ||
      p.other_source_face.size() != p.other_source_operand.size() || p.other_source_flipped.size() != p.other_source_operand.size()) {
    faults.add("other sources differ in size", facets);
  }
  if (p.vertex_operand.size() != vertices || p.vertex_source.size() != vertices) faults.add("vertex arrays differ in size", vertices);
  if (!result.mesh.walls.empty() && result.mesh.walls.size() != facets) faults.add("walls differ in size", facets);
  if (!result.mesh.face_labels.empty() && result.mesh.face_labels.size() != facets) faults.add("face labels differ in size", facets);
}

void check_vertices(const SurfaceMesh& mesh, Faults& faults) {
  std::vector<char> used(mesh.points.size(), 0);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (const VertexId v : mesh.triangles[f]) {
      if (v.index() >= used.size()) return faults.add("face names a vertex that does not exist", f);
      used[v.index()] = 1;
    }
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) faults.add("vertex without a face", v);
    if (!std::isfinite(mesh.points[v].x) || !std::isfinite(mesh.points[v].y) || !std::isfinite(mesh.points[v].z))
      faults.add("vertex not finite", v);
  }
  const auto points = sorted_points(mesh);
  if (std::adjacent_find(points.begin(), points.end()) != points.end()) faults.add("two vertices at one place", points.size());
}

double largest_of(const Vec3d& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }

bool has_area(const Corners& c) {
  const Vec3d u = c[1] - c[0], v = c[2] - c[0], normal = cross(u, v);
  // Far beyond what rounding does to a cross product: no need to look closer.
  if (dot(normal, normal) > 1e-12 * dot(u, u) * dot(v, v) && dot(normal, normal) > 1e-100 && dot(u, u) < 1e100 && dot(v, v) < 1e100 &&
      std::max({largest_of(c[0]), largest_of(c[1]), largest_of(c[2])}) < 1e6 * std::sqrt(std::min(dot(u, u), dot(v, v)))) {
    return true;
  }
  const std::array<RationalPoint, 3> p{oracle::exact(c[0]), oracle::exact(c[1]), oracle::exact(c[2])};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if ((p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) != (p[1][j] - p[0][j]) * (p[2][i] - p[0][i])) return true;
  }
  return false;
}

void check_triangles(const SurfaceMesh& mesh, Faults& faults) {
  std::set<std::array<std::uint32_t, 3>> seen;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    std::array<std::uint32_t, 3> key{t[0].value, t[1].value, t[2].value};
    std::sort(key.begin(), key.end());
    if (!seen.insert(key).second) faults.add("face given twice", f);
    if (!has_area(oracle::corners_of(mesh, f))) faults.add("face without area", f);
  }
}

void check_balance(const SurfaceMesh& mesh, Faults& faults) {
  for_each_edge(sorted_edge_uses(mesh), [&](std::span<const EdgeUse> uses) {
    int sum = 0;
    for (const EdgeUse& use : uses) sum += use.direction;
    if (sum != 0) faults.add("edge not balanced", uses[0].low);
  });
}

void check_graph(const IntersectionGraph& graph, Faults& faults) {
  if (graph.closed_loops + graph.open_chains != graph.chains.size()) faults.add("chains do not add up", graph.chains.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (graph.edges[e][0] >= graph.edges[e][1] || graph.edges[e][1] >= graph.points.size()) faults.add("graph edge not in order", e);
    if (e > 0 && !(graph.edges[e - 1] < graph.edges[e])) faults.add("graph edges not sorted", e);
  }
  std::size_t links = 0;
  for (std::size_t c = 0; c < graph.chains.size(); ++c) {
    const auto& chain = graph.chains[c];
    const bool closed = chain.size() > 2 && chain.front() == chain.back();
    if (closed != (c < graph.closed_loops)) faults.add("closed loops do not come first", c);
    if (!chain.empty()) links += chain.size() - 1;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const std::array<std::uint32_t, 2> edge{std::min(chain[i - 1], chain[i]), std::max(chain[i - 1], chain[i])};
      if (!std::binary_search(graph.edges.begin(), graph.edges.end(), edge)) faults.add("chain leaves the graph", c);
    }
  }
  if (links != graph.edges.size()) faults.add("chains do not cover the graph once", links);
}

// ---- provenance ----

struct SourceFace {
  std::uint32_t operand, face;
  int sense;  ///< of the facet in it
  auto operator<=>(const SourceFace&) const = default;
};

std::vector<SourceFace> sources_of(const Provenance& p, std::size_t facet) {
  std::vector<SourceFace> sources{{p.source_operand[facet], p.source_face[facet], p.flipped[facet] != 0 ? -1 : 1}};
  for (std::size_t i = p.other_source_begin[facet]; i < p.other_source_begin[facet + 1]; ++i) {
    sources.push_back({p.other_source_operand[i], p.other_source_face[i], p.other_source_flipped[i] != 0 ? -1 : 1});
  }
  return sources;
}

/// Per vertex, all source faces of the facets round it; only for vertices without a source vertex.
std::vector<std::vector<SourceFace>> sources_round_made_vertices(const BooleanResult& result) {
  std::vector<std::vector<SourceFace>> round(result.mesh.points.size());
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    const std::vector<SourceFace> sources = sources_of(result.provenance, f);
    for (const VertexId v : result.mesh.triangles[f]) {
      if (result.provenance.vertex_source[v.index()] != Provenance::none) continue;
      round[v.index()].insert(round[v.index()].end(), sources.begin(), sources.end());
    }
  }
  for (auto& sources : round) {
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  }
  return round;
}

std::vector<Corners> corners_of_sources(std::span<const SurfaceMesh* const> operands, const std::vector<SourceFace>& sources) {
  std::vector<Corners> corners;
  for (const SourceFace& s : sources) corners.push_back(oracle::corners_of(*operands[s.operand], s.face));
  return corners;
}

/// Faces of all operands whose boxes hold the point, or miss it by no more than rounding could move it.
std::vector<Corners> faces_near(std::span<const SurfaceMesh* const> operands, const Vec3d& p) {
  const auto holds = [&](const Corners& c) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double slack = std::ldexp(std::fabs(p[i]), -50);
      if (p[i] < std::min({c[0][i], c[1][i], c[2][i]}) - slack || p[i] > std::max({c[0][i], c[1][i], c[2][i]}) + slack) return false;
    }
    return true;
  };
  std::vector<Corners> near;
  for (const SurfaceMesh* operand : operands) {
    for (std::size_t f = 0; f < operand->triangles.size(); ++f) {
      const Corners corners = oracle::corners_of(*operand, f);
      if (holds(corners)) near.push_back(corners);
    }
  }
  return near;
}

/// The exact point a made vertex stands for: the one its faces allow that rounds to its doubles. Where a contact without
/// volume made it, the other face of the contact is not in the result and is looked for among all faces.
std::vector<RationalPoint> exact_points_at(const Vec3d& doubles, const std::vector<Corners>& faces,
                                           std::span<const SurfaceMesh* const> operands, Repairs repairs) {
  const auto differs = [&](const RationalPoint& p) { return oracle::nearest_double(p) != doubles; };
  std::vector<RationalPoint> points = oracle::points_determined_by(doubles, faces);
  std::erase_if(points, differs);
  if (points.empty() && repairs == Repairs::Allowed) points = oracle::points_determined_by_some(doubles, faces);
  if (!points.empty()) return points;
  const std::vector<Corners> near = faces_near(operands, doubles);
  points = oracle::points_determined_by(doubles, faces, near);
  std::erase_if(points, differs);
  // The faces that made a vertex others were merged into may have lost all their facets there.
  if (points.empty() && repairs == Repairs::Allowed) points = oracle::points_determined_by_some(doubles, near);
  return points;
}

RationalPoint normal_of(const std::array<RationalPoint, 3>& t) {
  RationalPoint n;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = (t[1][j] - t[0][j]) * (t[2][k] - t[0][k]) - (t[1][k] - t[0][k]) * (t[2][j] - t[0][j]);
  }
  return n;
}

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

oracle::Rational product(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Is a point of the plane in the closed triangle?
bool is_in_triangle(const std::array<RationalPoint, 3>& t, const RationalPoint& normal, const RationalPoint& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (product(normal_of({t[i], t[(i + 1) % 3], p}), normal) < 0) return false;
  }
  return true;
}

/// How a facet lies in a source face: +1 the same way, -1 against it, 0 not inside it.
int sense_in(const std::array<RationalPoint, 3>& facet, const Corners& source) {
  const std::array<RationalPoint, 3> face{oracle::exact(source[0]), oracle::exact(source[1]), oracle::exact(source[2])};
  const RationalPoint normal = normal_of(face);
  for (const RationalPoint& p : facet) {
    if (oracle::orient3d(face[0], face[1], face[2], p) != 0 || !is_in_triangle(face, normal, p)) return 0;
  }
  return product(normal, normal_of(facet)).sign();
}

/// Is the facet a face of its source just as it was?
bool is_untouched(const Provenance& p, const BooleanResult& result, std::span<const SurfaceMesh* const> operands, std::size_t facet) {
  const std::uint32_t operand = p.source_operand[facet];
  Corners source = oracle::corners_of(*operands[operand], p.source_face[facet]);
  if (p.flipped[facet] != 0) std::swap(source[1], source[2]);
  const Corners corners = oracle::corners_of(result.mesh, facet);
  for (std::size_t turn = 0; turn < 3; ++turn) {
    if (corners[0] == source[turn] && corners[1] == source[(turn + 1) % 3] && corners[2] == source[(turn + 2) % 3]) return true;
  }
  return false;
}

bool are_sources_in_range(std::span<const SurfaceMesh* const> operands, const BooleanResult& result, Faults& faults) {
  const auto exists = [&](std::uint32_t operand, std::uint32_t face) {
    return operand < operands.size() && face < operands[operand]->triangles.size();
  };
  bool fine = true;
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
    for (const SourceFace& s : sources_of(result.provenance, f)) {
      if (!exists(s.operand, s.face)) faults.add("facet with a source that does not exist", f), fine = false;
    }
  }
  for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
    const std::uint32_t operand = result.provenance.vertex_operand[v], source = result.provenance.vertex_source[v];
    if (operand == Provenance::none && source == Provenance::none) continue;
    if (operand >= operands.size() || source >= operands[operand]->points.size())
      faults.add("vertex with a source that does not exist", v), fine = false;
  }
  return fine;
}

bool is_snapped(const BooleanResult& result) { return result.report.certificate.snap_rounds > 0; }

std::vector<RationalPoint> find_positions(std::span<const SurfaceMesh* const> operands, const BooleanResult& result, Repairs repairs,
                                          Faults& faults) {
  const auto round = sources_round_made_vertices(result);
  std::vector<RationalPoint> positions;
  for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
    const Vec3d& doubles = result.mesh.points[v];
    positions.push_back(oracle::exact(doubles));
    if (round[v].empty()) {
      const Vec3d& source = operands[result.provenance.vertex_operand[v]]->points[result.provenance.vertex_source[v]];
      if (!have_equal_bits(doubles, source)) faults.add("vertex differs from its source vertex", v);
      continue;
    }
    if (is_snapped(result)) continue;
    const std::vector<RationalPoint> points = exact_points_at(doubles, corners_of_sources(operands, round[v]), operands, repairs);
    if (points.size() == 1) positions.back() = points[0];
    if (points.empty()) faults.add("made vertex is not the nearest double of a point its faces determine", v);
  }
  return positions;
}

oracle::Rational squared(const oracle::Rational& x) { return x * x; }

/// Is the facet in the source face but for `slack`?
bool is_almost_in(const std::array<RationalPoint, 3>& facet, const Corners& source, double slack) {
  const std::array<RationalPoint, 3> face{oracle::exact(source[0]), oracle::exact(source[1]), oracle::exact(source[2])};
  const RationalPoint normal = normal_of(face);
  const oracle::Rational allowed = squared(oracle::exact(slack)) * product(normal, normal);
  for (const RationalPoint& p : facet) {
    if (squared(product(normal, minus(p, face[0]))) > allowed) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalPoint along = minus(face[(i + 1) % 3], face[i]);
      const oracle::Rational inwards = product(normal_of({face[i], face[(i + 1) % 3], p}), normal);
      if (inwards < 0 && squared(inwards) > allowed * product(along, along)) return false;
    }
  }
  return true;
}

/// Is a height of the facet no more than `slack`? Then rounding may have turned it over.
bool is_thin(const std::array<RationalPoint, 3>& facet, double slack) {
  const RationalPoint normal = normal_of(facet);
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint side = minus(facet[(i + 1) % 3], facet[i]);
    if (product(normal, normal) <= squared(oracle::exact(slack)) * product(side, side)) return true;
  }
  return false;
}

/// What the positions of the vertices are checked with.
struct Reference {
  std::span<const SurfaceMesh* const> operands;
  std::vector<RationalPoint> positions;
  double slack = 0;
};

double size_of_scene(std::span<const SurfaceMesh* const> operands) {
  double size = 0;
  for (const SurfaceMesh* operand : operands) size = std::max(size, largest_coordinate(*operand));
  return 2 * size;
}

void check_facet(const Reference& reference, const BooleanResult& result, std::size_t f, Faults& faults) {
  const auto& [operands, positions, slack] = reference;
  const Provenance& p = result.provenance;
  const std::vector<SourceFace> sources = sources_of(p, f);
  if (sources.size() == 1 && is_untouched(p, result, operands, f)) return;
  const Triangle& t = result.mesh.triangles[f];
  const std::array<RationalPoint, 3> facet{positions[t[0].index()], positions[t[1].index()], positions[t[2].index()]};
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const Corners source = oracle::corners_of(*operands[sources[s].operand], sources[s].face);
    const int sense = sense_in(facet, source);
    if (sense == 0 && slack > 0 && is_almost_in(facet, source, slack)) continue;
    if (sense == 0) faults.add(s == 0 ? "facet not inside its source face" : "facet not inside its other source", f);
    const bool runs_wrongly = sense != 0 && sense != sources[s].sense;
    if (runs_wrongly && !(slack > 0 && is_thin(facet, slack))) faults.add("facet flipped wrongly", f);
    if (s > 0 && sources[s].operand < sources[0].operand) faults.add("first source is not of the lowest operand", f);
  }
}

}  // namespace

double exact_volume(const SurfaceMesh& mesh) { return oracle::nearest_double(oracle::volume(mesh)); }

Shape shape_of(const SurfaceMesh& mesh) {
  Shape shape{exact_volume(mesh), area_of(mesh), mesh.triangles.size()};
  Groups shells(mesh.triangles.size());
  Groups corners(3 * mesh.triangles.size());  // corners joined across edges are one vertex
  std::size_t edges = 0;
  for_each_edge(sorted_edge_uses(mesh), [&](std::span<const EdgeUse> uses) {
    ++edges;
    if (uses.size() > 2) ++shape.pinched_edges;
    for (std::size_t i = 1; i < uses.size(); ++i) {
      shells.join(uses[0].face, uses[i].face);
      for (const std::uint32_t v : {uses[0].low, uses[0].high})
        corners.join(corner_at(mesh, uses[0].face, v), corner_at(mesh, uses[i].face, v));
    }
  });
  shape.shells = shells.count();
  const long euler = static_cast<long>(corners.count()) - static_cast<long>(edges) + static_cast<long>(mesh.triangles.size());
  shape.genus = static_cast<long>(shape.shells) - euler / 2;
  return shape;
}

std::string faults_of_mesh(const BooleanResult& result) {
  Faults faults;
  check_sizes(result, faults);
  check_vertices(result.mesh, faults);
  if (!faults.text().empty()) return faults.text();
  check_triangles(result.mesh, faults);
  check_balance(result.mesh, faults);
  check_graph(result.graph, faults);
  const Certificate& certificate = result.report.certificate;
  if (certificate.status != CertificateStatus::Certified || !certificate.failed_faces.empty())
    faults.add("not certified", certificate.failed_faces.size());
  return faults.text();
}

/// They exist, once each, and none of them is a vertex of the result where it was.
void check_moved_vertices(std::span<const SurfaceMesh* const> operands, const std::vector<OperandVertex>& moved, const SurfaceMesh& result,
                          Faults& faults) {
  const auto found = sorted_points(result);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Vec3d& p = operands[moved[i].operand]->points.at(moved[i].vertex);
    if (i > 0 && !(moved[i - 1] < moved[i])) faults.add("moved vertices are not ascending", i);
    if (std::binary_search(found.begin(), found.end(), std::array<double, 3>{p.x, p.y, p.z}))
      faults.add("a vertex said to be moved is there", i);
  }
}

std::string faults_of_provenance(std::span<const SurfaceMesh* const> operands, const BooleanResult& result, Repairs repairs) {
  Faults faults;
  if (!are_sources_in_range(operands, result, faults)) return faults.text();
  Reference reference{operands, find_positions(operands, result, repairs, faults)};
  const double size = size_of_scene(operands);
  if (repairs == Repairs::Allowed) reference.slack = std::ldexp(size, -44);
  if (repairs == Repairs::Allowed && is_snapped(result)) {
    reference.slack = result.report.certificate.largest_displacement;
    if (!(reference.slack <= std::ldexp(size, -22))) faults.add("snapped farther than the coarsest grid does", 0);
    check_moved_vertices(operands, result.report.certificate.moved_input_vertices, result.mesh, faults);
  }
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) check_facet(reference, result, f, faults);
  return faults.text();
}

std::vector<RationalPoint> exact_positions(std::span<const SurfaceMesh* const> operands, const BooleanResult& result) {
  Faults faults;
  return find_positions(operands, result, Repairs::None, faults);
}

std::string faults_of(std::span<const SurfaceMesh* const> operands, const BooleanResult& result, Repairs repairs) {
  const std::string faults = faults_of_mesh(result);
  return faults.empty() ? faults_of_provenance(operands, result, repairs) : faults;
}

std::vector<std::array<double, 3>> sorted_points(const SurfaceMesh& mesh) {
  std::vector<std::array<double, 3>> points;
  for (const Vec3d& p : mesh.points) points.push_back({p.x, p.y, p.z});
  std::sort(points.begin(), points.end());
  return points;
}

double largest_coordinate(const SurfaceMesh& mesh) {
  double largest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) {
      largest = std::max(largest, largest_of(mesh.points[v.index()]));
    }
  }
  return largest;
}

double identity_tolerance(double volumes, double area, const BooleanReport& report, double coordinate) {
  const double displacement = std::max(report.certificate.largest_displacement, std::ldexp(coordinate, -53));
  return 1e-12 * volumes + 4 * displacement * area;
}

}  // namespace mortise::test
