// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Solids over heightfields, below and above them, and sheets that are none.
#include "mortise/mesh/extrude_to.h"

#include <algorithm>
#include <limits>

#include "mortise/mesh/inspect.h"
#include "mortise/mesh/shapes.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/mesh_checks.h"

namespace mortise {
namespace {

/// A grid from (0, 0) to (width, depth) with heights from a formula of whole numbers.
SurfaceMesh hills(std::uint32_t width, std::uint32_t depth) {
  SurfaceMesh sheet = make_grid_sheet(width, depth, width, depth);
  for (Vec3d& p : sheet.points) p.z = static_cast<double>((3 * static_cast<int>(p.x) + 5 * static_cast<int>(p.y)) % 7);
  return sheet;
}

void check_is_solid(const SurfaceMesh& mesh) {
  const MeshReport report = inspect(mesh);
  CHECK(report.closed);
  CHECK(report.oriented);
  CHECK(report.self_intersections == 0);
  CHECK(report.degenerate_faces == 0);
}

Error refusal(const SurfaceMesh& sheet, double z) {
  const auto error = test::error_of([&] { (void)extrude_to(sheet, z); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InvalidArgument);
  return *error;
}

}  // namespace

TEST_CASE("A flat sheet becomes a box, below and above", "[mesh][extrude_to]") {
  for (const double z : {-2.0, 2.0}) {
    const SurfaceMesh solid = extrude_to(make_grid_sheet(3, 2, 3, 2), z);
    check_is_solid(solid);
    CHECK(test::exactly_summed_volume(solid) == 12);
    CHECK(solid.points.size() == 24);
    CHECK(solid.triangles.size() == 12 + 12 + 20);
  }
}

TEST_CASE("Sheet and its turned copy give the same solid, sheet faces first", "[mesh][extrude_to]") {
  const SurfaceMesh sheet = hills(6, 5);
  const SurfaceMesh solid = extrude_to(sheet, -1);
  check_is_solid(solid);
  CHECK(std::equal(sheet.triangles.begin(), sheet.triangles.end(), solid.triangles.begin()));
  CHECK(test::exactly_summed_volume(solid) == test::exactly_summed_volume(extrude_to(test::inside_out(sheet), -1)));
  const SurfaceMesh above = extrude_to(sheet, 9);
  check_is_solid(above);
  CHECK(test::exactly_summed_volume(above) + test::exactly_summed_volume(solid) == 6 * 5 * 10);
}

TEST_CASE("Sheets of several parts, with holes and with parts that touch in a vertex", "[mesh][extrude_to]") {
  SurfaceMesh sheet = hills(5, 5);
  sheet.triangles.erase(sheet.triangles.begin() + 24, sheet.triangles.begin() + 26);  // the middle cell
  sheet.triangles.erase(sheet.triangles.begin(), sheet.triangles.begin() + 2);        // a corner cell
  sheet.triangles.erase(sheet.triangles.begin() + 8, sheet.triangles.begin() + 10);   // one diagonal to it
  const SurfaceMesh solid = extrude_to(test::joined({sheet, test::moved(hills(2, 2), {10, 0, 0})}), -3);
  check_is_solid(solid);
  CHECK(inspect(solid).components == 2);
}

TEST_CASE("Labels stay on the sheet; base and sides have their own", "[mesh][extrude_to]") {
  SurfaceMesh sheet = make_grid_sheet(1, 1, 1, 1);
  sheet.label_names = {"grass", "road"};
  sheet.face_labels = {0, 1};
  const SurfaceMesh solid = extrude_to(sheet, -1);
  CHECK(solid.label_names == std::vector<std::string>{"grass", "road", "base", "side"});
  CHECK(solid.face_labels == std::vector<std::uint32_t>{0, 1, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3});
}

TEST_CASE("Nothing becomes nothing", "[mesh][extrude_to]") { CHECK(extrude_to({}, 0).triangles.empty()); }

TEST_CASE("A plane through the sheet or touching it is refused with the vertices", "[mesh][extrude_to]") {
  SurfaceMesh sheet = make_grid_sheet(2, 1, 2, 1);
  sheet.points[4].z = -1;
  CHECK(refusal(sheet, -0.5).ids == std::vector<std::uint32_t>{4});
  CHECK(refusal(sheet, -1).ids == std::vector<std::uint32_t>{4});
  CHECK(refusal(sheet, 0).id_kind == IdKind::Vertices);
  CHECK(refusal(sheet, std::numeric_limits<double>::quiet_NaN()).ids.empty());
}

TEST_CASE("What is no heightfield is refused with the faces", "[mesh][extrude_to]") {
  SurfaceMesh folded = make_grid_sheet(3, 1, 3, 1);
  folded.points[7].x = 0.5;  // a vertex of the far side drawn back over its neighbour
  folded.points[6].x = 1.5;
  const Error fold = refusal(folded, -1);
  CHECK(fold.id_kind == IdKind::Faces);
  CHECK_FALSE(fold.ids.empty());

  const SurfaceMesh upright = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK(refusal(upright, -1).ids == std::vector<std::uint32_t>{1});
  CHECK_FALSE(refusal(test::box({0, 0, 0}, {1, 1, 1}), -1).ids.empty());

  const SurfaceMesh over = test::joined({make_grid_sheet(2, 2, 1, 1), test::moved(make_grid_sheet(1, 1, 1, 1), {0.25, 0.25, 1})});
  CHECK(refusal(over, -1).ids == std::vector<std::uint32_t>{0, 1, 2, 3});
}

TEST_CASE("The terrain of a turbine site becomes a solid of the volume known", "[mesh][extrude_to]") {
  if (test::is_data_missing()) return;
  const SurfaceMesh solid = extrude_to(test::read_data("terrain/turbine_site_terrain.off"), 900);
  check_is_solid(solid);
  CHECK(test::exactly_summed_volume(solid) == Approx(65646133.3333).epsilon(1e-12));
  CHECK(solid.triangles.size() == 2 * 21186 + 2 * 412);
}

}  // namespace mortise
