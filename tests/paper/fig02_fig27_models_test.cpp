// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Figs. 2 and 27: models of what operations leave of two boxes, and of boxes of any mesh with three holes.
#include <algorithm>

#include "mortise/boolean/imprint.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"
#include "support/imprint_checks.h"
#include "support/models.h"

using namespace mortise;
using namespace mortise::test;

namespace {

struct Counts {
  std::size_t vertices, edges, faces, regions;  // bounded ones

  bool operator==(const Counts&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Counts& c) {
  return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces, " << c.regions << " regions";
}

Counts counts_of(const SurfaceMesh& mesh, const ClassifiedBrep& model) {
  CHECK(find_faults(mesh, model) == std::vector<std::string>());
  return {model.brep.vertex_count, model.brep.edges.size(), model.brep.faces.size(), model.brep.region_count - 1};
}

Counts counts_of(Operation operation, const std::vector<SurfaceMesh>& solids) {
  const ResultModel m(operation, solids);
  return counts_of(m.boolean.mesh, m.model);
}

std::vector<SurfaceMesh> two_boxes() { return {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})}; }

}  // namespace

TEST_CASE("Fig. 2: either difference of two boxes, and both at once", "[paper][brep]") {
  CHECK(counts_of(Operation::Subtract, two_boxes()) == Counts{14, 21, 9, 1});
  CHECK(counts_of(Operation::Subtract, {two_boxes()[1], two_boxes()[0]}) == Counts{14, 21, 9, 1});
  // All faces of the partition; the space they have in common is hollow.
  const ResultModel both(Operation::SymmetricDifference, two_boxes());
  CHECK(counts_of(both.boolean.mesh, both.model) == Counts{22, 36, 18, 3});
  const std::vector<std::uint8_t> voids = find_voids(both.boolean.mesh, both.model);
  CHECK(std::count(voids.begin(), voids.end(), 1) == 1);
}

TEST_CASE("Fig. 2: an imprint leaves a box all it has, and the loop", "[paper][brep]") {
  const std::vector<SurfaceMesh> solids = two_boxes();
  const ImprintResult imprinted = imprint(pointers_to(solids));
  for (const ImprintedOperand& operand : imprinted.operands) {
    const auto vertex_of = [&](std::uint32_t id) {
      return VertexId(static_cast<std::size_t>(std::lower_bound(operand.vertex_ids.begin(), operand.vertex_ids.end(), id) -
                                               operand.vertex_ids.begin()));
    };
    BrepRules rules;
    for (const auto& [a, b] : shared_edges(imprinted)) rules.features.user_edges.push_back({vertex_of(a), vertex_of(b)});
    CHECK(counts_of(operand.mesh, build_brep(operand.mesh, rules)) == Counts{14, 21, 9, 1});
    CHECK(surface_area(operand.mesh) == 24);
  }
}

TEST_CASE("Fig. 27: the boxes of the data folder with three holes have one model", "[paper][brep][scenario]") {
  if (is_data_missing()) return;
  for (const char* name : {"coarse", "quads", "fine"}) {
    INFO(name);
    std::vector<SurfaceMesh> solids{read_data(std::string("primitives/fig27_box_") + name + ".off")};
    for (const char* number : {"1", "2", "3"}) solids.push_back(read_data(std::string("primitives/fig27_cylinder_") + number + ".off"));
    BrepRules rules;
    rules.seams = Seams::None;
    const ResultModel drilled(Operation::Subtract, solids, rules), joined(Operation::Union, solids, rules);
    CHECK(counts_of(drilled.boolean.mesh, drilled.model) == Counts{14, 18, 9, 1});
    // Two discs and two sides of each cylinder stand out of the box.
    CHECK(counts_of(joined.boolean.mesh, joined.model) == Counts{20, 24, 18, 1});
    for (const ResultModel* m : {&drilled, &joined}) {
      std::size_t with_four_loops = 0;
      for (std::uint32_t f = 0; f < m->model.brep.faces.size(); ++f) {
        with_four_loops += m->model.brep.loops_of_face.of(ModelFaceId(f)).size() == 4 ? 1 : 0;
      }
      CHECK(with_four_loops == 2);
    }
  }
}
