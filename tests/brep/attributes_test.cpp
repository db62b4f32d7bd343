// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Attributes through operations by policy, measured before and after.
#include "mortise/brep/attributes.h"

#include <algorithm>

#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/models.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr EntityDimension edge = EntityDimension::Edge, face = EntityDimension::Face, region = EntityDimension::Region;

Attribute on(const std::string& name, std::vector<ModelEntity> targets, AttributePolicy policy = {}, const std::string& value = "1") {
  return {name, AttributeKind::User, value, std::move(targets), policy};
}

/// The face of a model in a plane across z.
std::uint32_t face_at(const ModelView& view, double z) {
  for (std::uint32_t f = 0; f < view.model.brep.faces.size(); ++f) {
    const Box3 box = bounding_box(view, {face, f});
    if (box.lo.z == z && box.hi.z == z) return f;
  }
  throw std::logic_error("no face there");
}

}  // namespace

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

TEST_CASE("values that meet where faces coincide are merged there only", "[brep][attributes]") {
  // The knob's face of area 1/4 lies in the block's of area 4.
  const ResultModel m(Operation::Partition, {box({0, 0, 0}, {2, 2, 2}), box({2, 0.5, 0.5}, {3, 1, 1})});
  const auto face_across_x = [&](std::size_t k) {
    for (std::uint32_t f = 0; f < 6; ++f) {
      const Box3 found = bounding_box(m.operands[k], {face, f});
      if (found.lo.x == 2 && found.hi.x == 2) return f;
    }
    throw std::logic_error("no face there");
  };
  const auto areas = [&](OnMerge on_merge) {
    AttributePolicy policy;
    policy.on_merge = on_merge;
    const std::vector<Attribute> of_a{on("finish", {{face, face_across_x(0)}}, policy, "\"rough\"")},
        of_b{on("finish", {{face, face_across_x(1)}}, policy, "\"smooth\"")};
    const std::vector<OperandAttributes> operands{{of_a, &m.operand_models[0].brep}, {of_b, &m.operand_models[1].brep}};
    std::vector<std::pair<std::string, double>> found;
    for (const Attribute& a : transfer_attributes(m.lineage, operands)) {
      found.emplace_back(a.value, 0);
      for (const ModelEntity& e : a.targets) found.back().second += measure(m.result, e);
    }
    return found;
  };
  using Areas = std::vector<std::pair<std::string, double>>;
  CHECK(areas(OnMerge::Union) == Areas{{"\"rough\"", 4}, {"\"smooth\"", 0.25}});
  CHECK(areas(OnMerge::First) == Areas{{"\"rough\"", 4}});
  CHECK(areas(OnMerge::Second) == Areas{{"\"rough\"", 3.75}, {"\"smooth\"", 0.25}});
  CHECK(areas(OnMerge::Drop) == Areas{{"\"rough\"", 3.75}});
  CHECK(error_of([&] { (void)areas(OnMerge::Error); })->code == ErrorCode::InvalidArgument);
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

TEST_CASE("attributes of corners stay with those that are left", "[brep][attributes]") {
  const std::vector<SurfaceMesh> boxes{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const auto corners = [&](Operation operation) {
    const ResultModel m(operation, boxes);
    std::vector<ModelEntity> all;
    for (std::uint32_t v = 0; v < 8; ++v) all.push_back({EntityDimension::Vertex, v});
    const std::vector<Attribute> of_a{on("a", all)}, of_b{on("b", all)};
    const std::vector<OperandAttributes> operands{{of_a, &m.operand_models[0].brep}, {of_b, &m.operand_models[1].brep}};
    std::vector<std::size_t> counts;
    for (const AttributeMeasure& found : measure_attributes(m.result, transfer_attributes(m.lineage, operands)))
      counts.push_back(found.vertices);
    return counts;
  };
  CHECK(corners(Operation::Union) == std::vector<std::size_t>{7, 7});
  CHECK(corners(Operation::Intersect) == std::vector<std::size_t>{1, 1});
  CHECK(corners(Operation::Subtract) == std::vector<std::size_t>{7, 1});
  CHECK(corners(Operation::Partition) == std::vector<std::size_t>{8, 8});
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
