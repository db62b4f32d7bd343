// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every class of operands through every operation: what docs/inputs.md says happens.
#include <functional>
#include <limits>
#include <map>

#include "boolean/evaluation.h"
#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/resolve.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/io/formats.h"
#include "mortise/mesh/half_space.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/slice.h"
#include "mortise/mesh/topology.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/document.h"
#include "support/mesh_checks.h"
#include "support/self_crossing_oracle.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const SurfaceMesh unit = box({0, 0, 0}, {4, 4, 4});
const SurfaceMesh corner = box({2.5, 2.25, 2.75}, {5, 5, 5});

SurfaceMesh rectangle(double x0, double y0, double x1, double y1, double z) {
  return make_mesh({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}, {{0, 1, 2}, {0, 2, 3}});
}

SurfaceMesh with_faces(SurfaceMesh mesh, const std::vector<std::array<std::size_t, 3>>& faces) {
  for (const auto& f : faces) mesh.triangles.push_back({VertexId(f[0]), VertexId(f[1]), VertexId(f[2])});
  return mesh;
}

SurfaceMesh without_face(SurfaceMesh mesh, std::size_t face) {
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(face));
  return mesh;
}

// A strip of n quads round the z axis, half a turn over on the way.
SurfaceMesh one_sided() {
  const std::vector<std::array<double, 2>> round{{3, 0}, {1.5, 2.5}, {-1.5, 2.5}, {-3, 0}, {-1.5, -2.5}, {1.5, -2.5}};
  const std::vector<std::array<double, 2>> tilt{{0, 1}, {0.3, 0.9}, {0.5, 0.8}, {1, 0.1}, {0.8, -0.5}, {0.5, -0.8}};  // outwards, up
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i < 6; ++i) {
    for (const double side : {1.0, -1.0}) {
      const double out = 1 + side * tilt[i][0] / 4;
      points.push_back({2.5 + out * round[i][0], 2.5 + out * round[i][1], 3 + side * tilt[i][1]});
    }
  }
  std::vector<std::array<std::size_t, 3>> faces;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t a = 2 * i, b = a + 1, c = i == 5 ? 1 : a + 2, d = i == 5 ? 0 : a + 3;  // the last meets the first upside down
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  return make_mesh(points, faces);
}

/// The meshes the classes of the table stand for.
std::map<std::string, SurfaceMesh> classes() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SurfaceMesh no_number = unit, bad_index = unit, flipped = unit;
  no_number.points[3].y = nan;
  bad_index.triangles[2][1] = VertexId(99);
  std::swap(flipped.triangles[5][0], flipped.triangles[5][1]);
  SurfaceMesh split = without_face(unit, 0);  // the longest edge of its first face split on that side only
  const Triangle t = unit.triangles[0];
  split.points.push_back(0.5 * (unit.points[t[0].index()] + unit.points[t[1].index()]));
  split.triangles.push_back({t[0], VertexId(8), t[2]});
  split.triangles.push_back({VertexId(8), t[1], t[2]});
  SurfaceMesh unused = unit;
  unused.points.push_back({1e30, 0, 0});
  const SurfaceMesh through = rectangle(-1, -1, 6, 6, 3.5), upright = with_axes_turned(through);
  SurfaceMesh fin = with_faces(unit, {{6, 7, 8}});
  fin.points.push_back({3, 3.5, 6});
  return {
      {"solid", unit},
      {"solid with a cavity", joined({unit, inside_out(box({1, 1, 1}, {3, 3, 3}))})},
      {"several shells", joined({unit, box({4.5, 4.5, 4.5}, {6, 6, 6})})},
      {"bodies that touch in an edge", joined({unit, box({4, 4, 0}, {6, 6, 4})})},
      {"bodies that touch in a vertex", joined({unit, box({4, 4, 4}, {6, 6, 6})})},
      {"soup, vertices not shared", soup_of(unit)},
      {"edges split on one side only", split},
      {"faces twice", joined({unit, unit})},
      {"pair of opposite faces attached", with_faces(fin, {{8, 7, 6}})},
      {"faces without area", with_faces(unit, {{0, 0, 1}, {2, 3, 3}})},
      {"quads and polygons", read_mesh("OFF\n8 6 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n0 0 4\n4 0 4\n4 4 4\n0 4 4\n"
                                       "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n",
                                       "cube.off")},
      {"vertices no face uses", unused},
      {"parts that overlap", joined({unit, box({3, 3, 3}, {6, 6, 6})})},
      {"one part that crosses itself", moved(pentagram_prism(0, 3.5), {2, 2, 0})},
      {"solids nested the same way round", joined({unit, box({1, 1, 1}, {3, 3, 3})})},
      {"partition with its walls", evaluate(Operation::Partition, {unit, box({3, 3, 3}, {6, 6, 6})}).mesh},
      {"solid with sheets attached", evaluate(Operation::Union, {unit, through}).mesh},
      {"sheet through the box", through},
      {"sheet that ends in the box", rectangle(-1, -1, 3, 3, 3.5)},
      {"one triangle", make_mesh({{0, 0, 0}, {6, 3, 3}, {3, 6, 3.5}}, {{0, 1, 2}})},
      {"sheet with three faces at an edge",
       evaluate(Operation::Union, {rectangle(0, 0, 6, 6, 3.5), make_mesh({{0, 3, 3.5}, {6, 3, 3.5}, {6, 3, 9}}, {{0, 1, 2}})}).mesh},
      {"one-sided sheet", one_sided()},
      {"sheet that crosses itself", joined({through, upright})},
      {"closed but for a hole", without_face(unit, 5)},
      {"closed with a fin", fin},
      {"no triangles", SurfaceMesh{}},
      {"half-space", make_half_space({{1, 2, 3}, 20}, bounding_box(corner))},
      {"closed, a face the wrong way", flipped},
      {"closed, inside out", inside_out(unit)},
      {"a coordinate that is no number", no_number},
      {"an index out of range", bad_index},
  };
}

KeepMask mask_of(std::initializer_list<KeepTag> tags) {
  KeepMask mask = 0;
  for (const KeepTag tag : tags) mask = static_cast<KeepMask>(mask | static_cast<KeepMask>(tag));
  return mask;
}

BooleanResult evaluate_column(const std::string& column, const SurfaceMesh& first, bool is_half_space) {
  static const std::map<std::string, Operation> operations{{"union", Operation::Union},
                                                           {"intersect", Operation::Intersect},
                                                           {"subtract", Operation::Subtract},
                                                           {"taken from box", Operation::Subtract},
                                                           {"xor", Operation::SymmetricDifference},
                                                           {"partition", Operation::Partition}};
  const bool is_last = column == "taken from box";
  BooleanOptions options;
  if (is_half_space) options.half_spaces = {is_last ? std::size_t{1} : std::size_t{0}};
  const std::vector<const SurfaceMesh*> operands = is_last ? std::vector{&corner, &first} : std::vector{&first, &corner};
  if (column == "imprint") return imprint(operands, options).whole;
  if (column == "keep outside") return keep_faces(mask_of({KeepTag::FirstOutside, KeepTag::OtherOutside}), operands, options);
  if (column == "keep inside") return keep_faces(mask_of({KeepTag::FirstInside, KeepTag::OtherInside}), operands, options);
  if (column == "expression") return evaluate_expression("(a | b) & !(a & b)", operands, options);
  if (column == "implant") return implant(operands, ImplantContact::Keep, options);
  return evaluate_boolean(operations.at(column), operands, options);
}

std::string kind_of(const BooleanResult& result) {
  const SurfaceMesh& mesh = result.mesh;
  if (mesh.triangles.empty()) return "empty";
  const ResultRegions regions = find_result_regions(result);
  const std::size_t walls = static_cast<std::size_t>(std::count(mesh.walls.begin(), mesh.walls.end(), 1));
  if (walls == mesh.triangles.size()) return regions.regions.empty() ? "sheet" : "a sheet with regions";
  if (!regions.is_closed) return "regions that are not closed";
  if (walls > 0) return "both";
  return find_unbalanced_edges(mesh, build_topology(mesh)).empty() ? "solid" : "open";
}

std::string outcome(const std::string& column, const std::string& name, const SurfaceMesh& first) {
  try {
    if (column == "slice") return slice(first, {{0, 0, 1}, 3.25}).polygons.empty() ? "empty" : "polygons";
    const BooleanResult result = column == "resolve" ? resolve(first) : evaluate_column(column, first, name == "half-space");
    CHECK(result.report.certificate.status == CertificateStatus::Certified);
    CHECK(oracle::self_crossings(result.mesh).empty());
    const std::string kind = kind_of(result);
    const bool keeps_regions = column == "partition" || column == "imprint" || column == "implant";
    if (column.rfind("keep", 0) == 0 && kind == "regions that are not closed") return "faces";
    return keeps_regions && (kind == "both" || kind == "solid") ? "regions" : kind;
  } catch (const Error& error) {
    if (error.code != ErrorCode::InvalidArgument) CHECK(!error.ids.empty());
    return std::string(error_code_name(error.code));
  }
}

}  // namespace

TEST_CASE("every class of operands gives what the documentation says", "[inputs]") {
  const auto rows = read_table("docs/inputs.md");
  const std::map<std::string, SurfaceMesh> meshes = classes();
  REQUIRE(rows.size() == meshes.size() + 1);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    REQUIRE(meshes.count(rows[r][0]) == 1);
    for (std::size_t c = 1; c < rows[r].size(); ++c) {
      INFO(rows[r][0] << ", " << rows[0][c]);
      CHECK(outcome(rows[0][c], rows[r][0], meshes.at(rows[r][0])) == rows[r][c]);
    }
  }
}
