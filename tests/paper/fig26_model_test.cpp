// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Fig. 26: the model of a sphere, a torus and a corner sheet, kept together. Faces, edges and vertices are counted on the facets, regions
// by flooding a grid of points.
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "mortise/base/union_find.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/topology.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/models.h"
#include "support/remesh_scenes.h"

using namespace mortise;
using namespace mortise::test;

namespace {

// ---- Regions, by points of a grid

/// Points with the same neighbours inside and outside are one region; the sheet parts neighbours on its two sides.
class Grid {
 public:
  /// Pieces of space in the sphere or the torus; points by themselves, in sharp edges, are none.
  [[nodiscard]] std::size_t count_regions() const {
    UnionFind sets(cells * cells * cells);
    for (std::size_t i = 0; i < cells; ++i) {
      for (std::size_t j = 0; j < cells; ++j) {
        for (std::size_t k = 0; k < cells; ++k) {
          if (i + 1 < cells) join({i, j, k}, {i + 1, j, k}, sets);
          if (j + 1 < cells) join({i, j, k}, {i, j + 1, k}, sets);
          if (k + 1 < cells) join({i, j, k}, {i, j, k + 1}, sets);
        }
      }
    }
    std::map<std::uint32_t, std::size_t> sizes;
    for (std::uint32_t n = 0; n < sets.size(); ++n) {
      if (solids_at(point({n / (cells * cells), n / cells % cells, n % cells})) != 0) ++sizes[sets.find(n)];
    }
    std::size_t count = 0;
    for (const auto& [first, size] : sizes) {
      CHECK((size < 5 || size > 100));
      count += size > 100 ? 1 : 0;
    }
    return count;
  }

 private:
  using Place = std::array<std::size_t, 3>;
  static constexpr std::size_t cells = 72;

  static Vec3d point(const Place& p) {
    const auto at = [](std::size_t i) { return -1.52 + 0.0507 * static_cast<double>(i); };
    return {at(p[0]), at(p[1]), at(p[2])};
  }
  static unsigned solids_at(const Vec3d& p) {
    const Vec3d q = p - ring_centre;
    const double to_ring = std::sqrt(q.x * q.x + q.y * q.y) - 1;
    return (dot(p, p) < 1 ? 1U : 0U) + (to_ring * to_ring + q.z * q.z < 0.16 ? 2U : 0U);
  }
  static bool parts(const Vec3d& p, const Vec3d& q) {
    const bool floor = p.y > corner_of_sheet && q.y > corner_of_sheet && (p.z < corner_of_sheet) != (q.z < corner_of_sheet);
    const bool wall = p.z < corner_of_sheet && q.z < corner_of_sheet && (p.y < corner_of_sheet) != (q.y < corner_of_sheet);
    return (floor || wall) && p.x < 1.6 && q.x < 1.6;  // the torus reaches round its right edge, and nothing round the others
  }
  static void join(const Place& a, const Place& b, UnionFind& sets) {
    const auto number = [](const Place& p) { return static_cast<std::uint32_t>((p[0] * cells + p[1]) * cells + p[2]); };
    const Vec3d p = point(a), q = point(b);
    if (solids_at(p) == solids_at(q) && !parts(p, q)) sets.join(number(a), number(b));
  }
};

// ---- Faces, edges and vertices, by facets

struct Counts {
  std::size_t vertices = 0, edges = 0, faces = 0;

  bool operator==(const Counts&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Counts& c) {
  return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces";
}

/// A number for the surface a facet is of; floor and wall are two, the floor lies across an axis.
std::size_t surface_of(const BooleanResult& result, std::size_t t, std::size_t floor_axis) {
  const std::uint32_t operand = result.provenance.source_operand[t];
  const Triangle& c = result.mesh.triangles[t];
  const auto is_on_floor = [&](VertexId v) { return result.mesh.points[v.index()][floor_axis] == corner_of_sheet; };
  return operand + (operand == 2 && is_on_floor(c[0]) && is_on_floor(c[1]) && is_on_floor(c[2]) ? 1 : 0);
}

/// Faces end where other than two facets meet and at the corner of the sheet; edges end where other than two of these do. A closed edge has
/// one vertex.
Counts count_on_facets(const BooleanResult& result, std::size_t floor_axis) {
  const MeshTopology topology = build_topology(result.mesh);
  UnionFind faces(result.mesh.triangles.size()), edges(topology.edges.size());
  std::map<VertexId, std::vector<std::uint32_t>> edges_at;
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(MeshEdgeId(e));
    if (uses.size() == 2 && surface_of(result, uses[0] / 3, floor_axis) == surface_of(result, uses[1] / 3, floor_axis)) {
      faces.join(uses[0] / 3, uses[1] / 3);
    } else {
      for (const VertexId v : topology.edges[e]) edges_at[v].push_back(e);
    }
  }
  Counts counts;
  std::map<std::uint32_t, bool> is_closed;  // chains, by their lowest edge
  for (const auto& [v, ends] : edges_at) {
    if (ends.size() == 2) edges.join(ends[0], ends[1]);
  }
  for (const auto& [v, ends] : edges_at) {
    for (const std::uint32_t e : ends) is_closed.try_emplace(edges.find(e), true).first->second &= ends.size() == 2;
    counts.vertices += ends.size() == 2 ? 0 : 1;
  }
  for (const auto& [chain, has_no_end] : is_closed) counts.vertices += has_no_end ? 1 : 0;
  counts.edges = is_closed.size();
  std::set<std::uint32_t> roots;
  for (std::uint32_t t = 0; t < faces.size(); ++t) roots.insert(faces.find(t));
  counts.faces = roots.size();
  return counts;
}

BrepRules plain_rules() {
  BrepRules rules;
  rules.edge_angle_deg = 180;
  rules.seams = Seams::None;
  return rules;
}

double border_of(const ResultModel& m) {
  double sum = 0;
  for (std::uint32_t e = 0; e < m.model.brep.edges.size(); ++e) {
    const bool is_border = m.model.brep.faces_of_edge.of(ModelEdgeId(e)).size() == 1;
    if (is_border) sum += measure(m.result, {EntityDimension::Edge, e});
  }
  return sum;
}

}  // namespace

TEST_CASE("Fig. 26: sphere, torus and corner sheet have the model their facets have", "[paper][brep]") {
  const ResultModel m(Operation::Partition, ball_ring_and_corner_sheet(), plain_rules());
  const Brep& brep = m.model.brep;
  CHECK(find_faults(m.boolean.mesh, m.model) == std::vector<std::string>());
  CHECK(Counts{brep.vertex_count, brep.edges.size(), brep.faces.size()} == count_on_facets(m.boolean, 2));
  CHECK(brep.region_count - 1 == Grid().count_regions());
  CHECK(border_of(m) == Approx(2 * (3.2 + 2.0 + 1.65)).epsilon(1e-12));
  double area = 0;
  for (std::uint32_t f = 0; f < brep.faces.size(); ++f) area += measure(m.result, {EntityDimension::Face, f});
  double expected = 0;
  for (const SurfaceMesh& operand : m.meshes) expected += surface_area(operand);
  CHECK(area == Approx(expected).epsilon(1e-12));
  std::set<std::size_t> fans;
  for (std::size_t e = 0; e < brep.edges.size(); ++e) fans.insert(brep.faces_of_edge.of(ModelEdgeId(e)).size());
  CHECK(fans == std::set<std::size_t>{1, 2, 4});  // no border of the sheet ends on a solid
}

TEST_CASE("Fig. 26: the model is sound with corners and seams too, in any order of the operands", "[paper][brep]") {
  std::vector<SurfaceMesh> scene = ball_ring_and_corner_sheet();
  const Counts counts = count_on_facets(ResultModel(Operation::Partition, scene).boolean, 2);
  for (const Seams seams : {Seams::Annulus, Seams::Disc}) {
    BrepRules rules;
    rules.seams = seams;
    const ResultModel m(Operation::Partition, scene, rules);
    CHECK(find_faults(m.boolean.mesh, m.model) == std::vector<std::string>());
    CHECK(m.model.brep.faces.size() == counts.faces);
    CHECK(m.model.brep.vertex_count >= counts.vertices + 4);  // the corners of the sheet
  }
  std::swap(scene[0], scene[1]);
  const ResultModel swapped(Operation::Partition, scene, plain_rules());
  const Brep& brep = swapped.model.brep;
  CHECK(Counts{brep.vertex_count, brep.edges.size(), brep.faces.size()} == counts);
}

TEST_CASE("Fig. 26: the scene of the data folder has the model its facets have", "[paper][brep][scenario]") {
  if (is_data_missing()) return;
  const ResultModel m(
      Operation::Partition,
      {read_data("primitives/fig26_sphere.off"), read_data("primitives/fig26_torus.off"), read_data("primitives/fig26_corner_sheet.off")},
      plain_rules());
  const Brep& brep = m.model.brep;
  CHECK(find_faults(m.boolean.mesh, m.model) == std::vector<std::string>());
  CHECK(brep.region_count - 1 == 6);
  CHECK(Counts{brep.vertex_count, brep.edges.size(), brep.faces.size()} == count_on_facets(m.boolean, 1));
}
