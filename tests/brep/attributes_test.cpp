// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Attributes through operations and policies (Fig. 18), measured before and after.
#include "mortise/brep/attributes.h"

#include <algorithm>
#include <numeric>

#include "mortise/mesh/measures.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/transform.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/models.h"
#include "support/random_source.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr EntityDimension edge = EntityDimension::Edge, face = EntityDimension::Face, region = EntityDimension::Region;

SurfaceMesh frustum() {
  const std::vector<Vec2d> profile{{0, -1}, {2, -1}, {1, 1}, {0, 1}};
  return revolve(profile, 48);
}
SurfaceMesh sphere() { return moved(make_icosphere(1.4, 3), {1, 0.25, 0.5}); }

Attribute on(const std::string& name, std::vector<ModelEntity> targets, AttributePolicy policy = {}, const std::string& value = "1") {
  return {name, AttributeKind::User, value, std::move(targets), policy};
}

/// The face of a model whose triangle lies highest or lowest along z with a normal that way, or else the one between.
std::uint32_t face_at(const ModelView& view, double z) {
  for (std::uint32_t f = 0; f < view.model.brep.faces.size(); ++f) {
    const Box3 box = bounding_box(view, {face, f});
    if (box.lo.z == z && box.hi.z == z) return f;
  }
  throw std::logic_error("no face there");
}

std::uint32_t side_of(const ModelView& view) {
  for (std::uint32_t f = 0; f < view.model.brep.faces.size(); ++f) {
    const Box3 box = bounding_box(view, {face, f});
    if (box.lo.z != box.hi.z) return f;
  }
  throw std::logic_error("no side");
}

/// Steel and paint on the side of the frustum, a load on its top, pressure on the sphere, a material in both.
struct Fig18 {
  explicit Fig18(const ResultModel& m, AttributePolicy policy = {})
      : of_frustum{on("steel", {{face, side_of(m.operands[0])}}, policy), on("load", {{face, face_at(m.operands[0], 1)}}, policy),
                   on("matter", {{region, 1}}, policy)},
        of_sphere{on("pressure", {{face, 0}}, policy), on("matter", {{region, 1}}, policy)} {}

  std::vector<Attribute> of_frustum, of_sphere;
};

std::vector<AttributeMeasure> transferred_measures(const ResultModel& m, const Fig18& given) {
  const std::vector<OperandAttributes> operands{{given.of_frustum, &m.operand_models[0].brep},
                                                {given.of_sphere, &m.operand_models[1].brep}};
  return measure_attributes(m.result, transfer_attributes(m.lineage, operands));
}

double area_of(const std::vector<AttributeMeasure>& measures, const std::string& name) {
  double area = 0;
  for (const AttributeMeasure& m : measures) area += m.name == name ? m.area : 0;
  return area;
}

double volume_of(const std::vector<AttributeMeasure>& measures, const std::string& name) {
  double volume = 0;
  for (const AttributeMeasure& m : measures) volume += m.name == name ? m.volume : 0;
  return volume;
}

/// The same mesh, its vertices and triangles in another order.
SurfaceMesh renumbered(const SurfaceMesh& mesh, RandomSource& random) {
  const auto shuffled = [&](std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
  };
  const std::vector<std::size_t> vertex_place = shuffled(mesh.points.size()), triangle_place = shuffled(mesh.triangles.size());
  SurfaceMesh result = mesh;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) result.points[vertex_place[v]] = mesh.points[v];
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) result.triangles[triangle_place[t]][k] = VertexId(vertex_place[mesh.triangles[t][k].index()]);
  }
  return result;
}

}  // namespace

TEST_CASE("frustum and sphere: every attribute covers what is left of its parent, whatever the numbering (Fig. 18)",
          "[brep][attributes][paper]") {
  RandomSource random(18);
  for (int round = 0; round < 4; ++round) {
    const std::vector<SurfaceMesh> solids{round == 0 ? frustum() : renumbered(frustum(), random),
                                          round == 0 ? sphere() : renumbered(sphere(), random)};
    const ResultModel common(Operation::Intersect, solids), either(Operation::Union, solids), less(Operation::Subtract, solids),
        parts(Operation::Partition, solids);
    const Fig18 given(common);
    const auto inside = transferred_measures(common, given), outside = transferred_measures(either, given),
               cut = transferred_measures(less, given), all = transferred_measures(parts, given);
    const ModelView& a = common.operands[0];
    const ModelView& b = common.operands[1];
    const double side = measure(a, {face, side_of(a)}), top = measure(a, {face, face_at(a, 1)}), ball = measure(b, {face, 0});
    CHECK(area_of(inside, "steel") > 0);
    CHECK(area_of(inside, "load") > 0);
    CHECK(area_of(inside, "steel") + area_of(outside, "steel") == Approx(side).epsilon(1e-12));
    CHECK(area_of(inside, "load") + area_of(outside, "load") == Approx(top).epsilon(1e-12));
    CHECK(area_of(inside, "pressure") + area_of(outside, "pressure") == Approx(ball).epsilon(1e-12));
    CHECK(area_of(cut, "steel") == Approx(area_of(outside, "steel")).epsilon(1e-12));
    CHECK(area_of(cut, "pressure") == Approx(area_of(inside, "pressure")).epsilon(1e-12));
    CHECK(area_of(all, "steel") == Approx(side).epsilon(1e-12));
    CHECK(area_of(all, "pressure") == Approx(ball).epsilon(1e-12));
    CHECK(volume_of(inside, "matter") == Approx(enclosed_volume(common.boolean.mesh)).epsilon(1e-12));
    CHECK(volume_of(all, "matter") == Approx(enclosed_volume(either.boolean.mesh)).epsilon(1e-12));
    for (const auto* measures : {&inside, &outside, &cut, &all}) CHECK(measures->size() == 4);
  }
}

TEST_CASE("a split attribute is copied, kept by the largest piece, dropped, or named by its pieces", "[brep][attributes]") {
  // A wall through a plate leaves two pieces of its top, one twice as large.
  const std::vector<SurfaceMesh> solids{box({0, 0, 0}, {10, 1, 1}), box({3, -1, -1}, {4, 2, 2})};
  const ResultModel m(Operation::Subtract, solids);
  const std::uint32_t top = face_at(m.operands[0], 1);
  const auto areas = [&](OnSplit on_split, const std::string& piece_name) {
    AttributePolicy policy;
    policy.on_split = on_split;
    policy.piece_name = piece_name;
    const std::vector<Attribute> given{on("top", {{face, top}}, policy)};
    const std::vector<OperandAttributes> operands{{given, &m.operand_models[0].brep}, {{}, &m.operand_models[1].brep}};
    std::vector<std::pair<std::string, double>> found;
    for (const AttributeMeasure& a : measure_attributes(m.result, transfer_attributes(m.lineage, operands)))
      found.emplace_back(a.name, a.area);
    return found;
  };
  using Areas = std::vector<std::pair<std::string, double>>;
  CHECK(areas(OnSplit::Copy, "") == Areas{{"top", 9}});
  CHECK(areas(OnSplit::Largest, "") == Areas{{"top", 6}});
  CHECK(areas(OnSplit::Drop, "") == Areas{});
  Areas pieces = areas(OnSplit::Copy, "{name} {piece}");
  std::sort(pieces.begin(), pieces.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].second == 3);
  CHECK(pieces[1].second == 6);
  CHECK(pieces[0].first != pieces[1].first);
  CHECK(pieces[0].first.substr(0, 4) == "top ");
}

TEST_CASE("values that meet are kept together, one of them, none, or refused", "[brep][attributes]") {
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  const auto values = [&](OnMerge on_merge) {
    AttributePolicy policy;
    policy.on_merge = on_merge;
    const std::vector<Attribute> of_a{on("material", {{region, 1}}, policy, "\"steel\"")},
        of_b{on("material", {{region, 1}}, policy, "\"oil\"")};
    const std::vector<OperandAttributes> operands{{of_a, &m.operand_models[0].brep}, {of_b, &m.operand_models[1].brep}};
    std::vector<std::pair<std::string, double>> found;
    for (const Attribute& a : transfer_attributes(m.lineage, operands)) {
      double volume = 0;
      for (const ModelEntity& e : a.targets) volume += measure(m.result, e);
      found.emplace_back(a.value, volume);
    }
    return found;
  };
  using Volumes = std::vector<std::pair<std::string, double>>;
  CHECK(values(OnMerge::Union) == Volumes{{"\"oil\"", 8}, {"\"steel\"", 8}});
  CHECK(values(OnMerge::First) == Volumes{{"\"oil\"", 7}, {"\"steel\"", 8}});
  CHECK(values(OnMerge::Second) == Volumes{{"\"oil\"", 8}, {"\"steel\"", 7}});
  CHECK(values(OnMerge::Drop) == Volumes{{"\"oil\"", 7}, {"\"steel\"", 7}});
  CHECK(error_of([&] { (void)values(OnMerge::Error); })->code == ErrorCode::InvalidArgument);
}

TEST_CASE("what is cut away goes with its attribute, or gives it to its neighbours", "[brep][attributes]") {
  const ResultModel m(Operation::Subtract, {box({0, 0, 0}, {2, 2, 2}), box({-1, -1, 1}, {3, 3, 3})});
  const std::uint32_t top = face_at(m.operands[0], 2);
  for (const OnDelete on_delete : {OnDelete::Drop, OnDelete::ToNeighbours}) {
    AttributePolicy policy;
    policy.on_delete = on_delete;
    const std::vector<Attribute> given{on("top", {{face, top}}, policy)};
    const std::vector<OperandAttributes> operands{{given, &m.operand_models[0].brep}, {{}, &m.operand_models[1].brep}};
    const std::vector<AttributeMeasure> left = measure_attributes(m.result, transfer_attributes(m.lineage, operands));
    CHECK(left.size() == (on_delete == OnDelete::Drop ? 0U : 1U));
    if (!left.empty()) CHECK(left[0].area == 8);  // four sides, half of each is left
  }
}

TEST_CASE("faces that would join keep apart what has other attributes", "[brep][attributes]") {
  const std::vector<SurfaceMesh> boxes{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {3, 1, 1})};
  const ResultModel joined_faces(Operation::Union, boxes);
  CHECK(joined_faces.model.brep.faces.size() == 6);
  const std::vector<Attribute> given{on("top", {{face, face_at(joined_faces.operands[0], 1)}})};
  const std::vector<OperandAttributes> operands{{given, &joined_faces.operand_models[0].brep}, {{}, &joined_faces.operand_models[1].brep}};
  const std::vector<const Classification*> models{&joined_faces.operand_models[0].classification,
                                                  &joined_faces.operand_models[1].classification};
  BrepRules rules;
  rules.features.groups = group_by_attributes(joined_faces.boolean.provenance, models, operands);
  const ResultModel apart(Operation::Union, boxes, rules);
  CHECK(apart.model.brep.faces.size() == 7);
  const std::vector<AttributeMeasure> measures = measure_attributes(apart.result, transfer_attributes(apart.lineage, operands));
  REQUIRE(measures.size() == 1);
  CHECK(measures[0].area == 1);
}

TEST_CASE("interfaces are named by both sides", "[brep][attributes]") {
  const auto name_of = [](const OperandEntity& e) { return e.operand == 0 ? std::string("hull") : std::string("gun"); };
  const ResultModel touching(Operation::Partition, {box({0, 0, 0}, {2, 2, 2}), box({2, 0.5, 0.5}, {3, 1, 1})});
  const std::vector<Attribute> shared = interface_attributes(touching.result, touching.lineage, name_of);
  REQUIRE(shared.size() == 1);
  CHECK(shared[0].name == "interface(hull, gun)");
  const std::vector<AttributeMeasure> measures = measure_attributes(touching.result, shared);
  CHECK(measures[0].area == 0.25);
  CHECK(measures[0].length == 2);
  const ResultModel crossing(Operation::Union, {box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})});
  const std::vector<Attribute> loop = interface_attributes(crossing.result, crossing.lineage, name_of);
  REQUIRE(loop.size() == 1);
  CHECK(loop[0].targets.size() == 6);
  for (const ModelEntity& e : loop[0].targets) CHECK(e.dimension == edge);
}

TEST_CASE("an attribute on an entity that is not there is refused by name", "[brep][attributes]") {
  const ResultModel m(Operation::Union, {box({0, 0, 0}, {1, 1, 1}), box({5, 0, 0}, {6, 1, 1})});
  const std::vector<Attribute> given{on("lost", {{face, 6}})};
  const std::vector<OperandAttributes> operands{{{}, &m.operand_models[0].brep}, {given, &m.operand_models[1].brep}};
  const auto error = error_of([&] { (void)transfer_attributes(m.lineage, operands); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InvalidArgument);
  CHECK(error->operand == 1);
  CHECK(error->message == "attribute 'lost' is on face 6, which is not there");
}
