// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models, attributes and lineage across the border.
#include "models.h"

#include <algorithm>
#include <array>
#include <string>

#include "arrays.h"
#include "border.h"
#include "model_tables.h"
#include "mortise/base/error.h"
#include "mortise/base/sort_unique.h"
#include "mortise/mesh/half_space.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/weld.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

[[noreturn]] void refuse_provenance() {
  throw Error(ErrorCode::InvalidArgument, "", "the provenance is not that of this mesh made from these operands");
}

Attribute attribute_in(const val& object) {
  const auto codes = numbers_in<std::uint32_t>(object["codes"]), targets = numbers_in<std::uint32_t>(object["targets"]);
  Attribute a{object["name"].as<std::string>(), static_cast<AttributeKind>(codes[0]), object["value"].as<std::string>(), {}, {}};
  a.policy = {static_cast<OnSplit>(codes[1]), static_cast<OnMerge>(codes[2]), static_cast<OnDelete>(codes[3]),
              object["pieceName"].as<std::string>()};
  for (std::size_t i = 0; i + 1 < targets.size(); i += 2) a.targets.push_back({static_cast<EntityDimension>(targets[i]), targets[i + 1]});
  sort_unique(a.targets);
  return a;
}

val attribute_out(const Attribute& a) {
  const std::array<std::uint32_t, 4> codes{static_cast<std::uint32_t>(a.kind), static_cast<std::uint32_t>(a.policy.on_split),
                                           static_cast<std::uint32_t>(a.policy.on_merge), static_cast<std::uint32_t>(a.policy.on_delete)};
  std::vector<std::uint32_t> targets;
  for (const ModelEntity& e : a.targets) targets.insert(targets.end(), {static_cast<std::uint32_t>(e.dimension), e.id});
  val object = val::object();
  object.set("name", a.name);
  object.set("value", a.value);
  object.set("pieceName", a.policy.piece_name);
  object.set("codes", copy_out(std::span<const std::uint32_t>(codes)));
  object.set("targets", copy_out(targets));
  return object;
}

std::vector<std::uint32_t> numbers_if_any(const val& array) {
  return array.isUndefined() ? std::vector<std::uint32_t>() : numbers_in<std::uint32_t>(array);
}

}  // namespace

BrepRules rules_in(const val& settings) {
  BrepRules rules;
  rules.features.face_angle_deg = settings["faceAngle"].as<double>();
  if (!settings["weakAngle"].isUndefined()) rules.features.weak_angle_deg = settings["weakAngle"].as<double>();
  rules.features.least_dangling = settings["leastDangling"].as<std::uint32_t>();
  rules.features.splits_at_labels = settings["splitAtLabels"].as<bool>();
  rules.features.groups = numbers_if_any(settings["groups"]);
  const auto ends = numbers_in<std::uint32_t>(settings["userEdges"]);
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) rules.features.user_edges.push_back({VertexId(ends[i]), VertexId(ends[i + 1])});
  rules.edge_angle_deg = settings["edgeAngle"].as<double>();
  const auto seams = settings["seams"].as<std::string>();
  rules.seams = seams == "none" ? Seams::None : seams == "disc" ? Seams::Disc : Seams::Annulus;
  return rules;
}

val recipe_out(const BrepRules& rules, const FaceNormals& normals) {
  std::vector<std::uint32_t> ends;
  for (const auto& [a, b] : rules.features.user_edges) ends.insert(ends.end(), {a.value, b.value});
  val object = val::object();
  object.set("userEdges", copy_out(ends));
  if (!rules.features.groups.empty()) object.set("groups", copy_out(rules.features.groups));
  if (normals.planes.empty()) return object;
  object.set("normals", points_out(normals.normals));
  object.set("planes", copy_out(normals.planes));
  return object;
}

BuiltModel model_in(const val& object) {
  const val settings = object["settings"], tables = settings["tables"];
  BuiltModel built{mesh_in(object["mesh"]), {}, {}};
  if (settings["normals"].isUndefined()) {
    built.normals = measure_normals(built.mesh, build_topology(built.mesh));
  } else {
    built.normals = {points_in(settings["normals"]), numbers_in<std::uint32_t>(settings["planes"])};
  }
  built.model = tables.isUndefined() ? build_brep(built.mesh, rules_in(settings), built.normals) : tables_in(tables, built.mesh);
  return built;
}

Provenance provenance_in(const val& object) {
  Provenance p;
  p.source_operand = numbers_in<std::uint32_t>(object["sourceOperand"]);
  p.source_face = numbers_in<std::uint32_t>(object["sourceFace"]);
  p.flipped = numbers_in<std::uint8_t>(object["flipped"]);
  p.other_source_begin = numbers_if_any(object["otherSourceBegin"]);
  p.other_source_operand = numbers_if_any(object["otherSourceOperand"]);
  p.other_source_face = numbers_if_any(object["otherSourceFace"]);
  if (!object["otherSourceFlipped"].isUndefined()) p.other_source_flipped = numbers_in<std::uint8_t>(object["otherSourceFlipped"]);
  p.covering = numbers_if_any(object["covering"]);
  p.covering_front = numbers_if_any(object["coveringFront"]);
  const val sets = object["coveringSets"];
  const std::size_t count = sets.isUndefined() ? 0 : sets["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) p.covering_sets.push_back(numbers_in<std::uint32_t>(sets[i]));
  return p;
}

FaceNormals source_normals_in(const val& sources) {
  const val operands = sources["operands"];
  std::vector<FaceNormals> normals(operands["length"].as<std::size_t>());
  const auto measure = [&](std::size_t k, const SurfaceMesh& mesh) { normals[k] = measure_normals(mesh, build_topology(mesh)); };
  Box3 box;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    if (!operands[k]["plane"].isUndefined()) continue;
    const SurfaceMesh mesh = mesh_in(operands[k]);
    box.extend(bounding_box(mesh));
    measure(k, mesh);
  }
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const val plane = operands[k]["plane"];
    if (!plane.isUndefined()) in_operand(k, [&] { measure(k, make_half_space(plane_in(plane), box)); });
  }
  return source_normals(provenance_in(sources["provenance"]), normals);
}

SurfaceMesh welded_mesh_in(const val& object) {
  SurfaceMesh mesh = mesh_in(object);
  mesh.vertex_data.clear();
  mesh.corner_data.clear();
  return weld(mesh).mesh;
}

BuiltModel given_model_in(const val& given) {
  if (given["isModel"].as<bool>()) return model_in(given);
  const val settings = given["settings"], sources = settings["sources"];
  BuiltModel built{welded_mesh_in(given["mesh"]), {}, {}};
  built.normals = sources.isUndefined() ? measure_normals(built.mesh, build_topology(built.mesh)) : source_normals_in(sources);
  built.model = build_brep(built.mesh, rules_in(settings), built.normals);
  return built;
}

void check_provenance(const Provenance& p, std::size_t triangles, std::span<const ModelView> operands) {
  const auto is_per_triangle = [&](const auto& array) { return array.size() == triangles; };
  if (!is_per_triangle(p.source_operand) || !is_per_triangle(p.source_face) || !is_per_triangle(p.flipped)) refuse_provenance();
  const std::size_t others = p.other_source_operand.size();
  if (p.other_source_face.size() != others || p.other_source_flipped.size() != others) refuse_provenance();
  const std::vector<std::uint32_t>& begin = p.other_source_begin;
  if (begin.empty() ? others != 0 : begin.size() != triangles + 1 || begin.back() != others || !std::is_sorted(begin.begin(), begin.end()))
    refuse_provenance();
  for (std::size_t t = 0; t < triangles; ++t) {
    for_each_source(p, FaceId(t), [&](const FacetOrigin& s) {
      if (s.operand >= operands.size() || s.face >= operands[s.operand].mesh.triangles.size()) refuse_provenance();
    });
  }
  for (const std::vector<std::uint32_t>* covering : {&p.covering, &p.covering_front}) {
    const auto is_set = [&](std::uint32_t set) { return set < p.covering_sets.size(); };
    if (!(covering->empty() || is_per_triangle(*covering)) || !std::all_of(covering->begin(), covering->end(), is_set)) refuse_provenance();
  }
  for (const std::vector<std::uint32_t>& set : p.covering_sets) {
    if (std::any_of(set.begin(), set.end(), [&](std::uint32_t k) { return k >= operands.size(); })) refuse_provenance();
  }
}

std::vector<Attribute> attributes_in(const val& array) {
  std::vector<Attribute> attributes;
  const auto count = array["length"].as<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) attributes.push_back(attribute_in(array[i]));
  return attributes;
}

val attributes_out(std::span<const Attribute> attributes) {
  val array = val::array();
  for (const Attribute& a : attributes) array.call<void>("push", attribute_out(a));
  return array;
}

val lineage_out(const Lineage& lineage) {
  const std::vector<LineageLink>& links = lineage.by_result;
  std::vector<double> measures;
  for (const LineageLink& l : links) measures.push_back(l.measure);
  val object = val::object();
  object.set("dimension", numbers_out(links, [](const LineageLink& l) { return l.result.dimension; }));
  object.set("result", numbers_out(links, [](const LineageLink& l) { return l.result.id; }));
  object.set("operand", numbers_out(links, [](const LineageLink& l) { return l.source.operand; }));
  object.set("source", numbers_out(links, [](const LineageLink& l) { return l.source.entity.id; }));
  object.set("measure", copy_out(measures));
  return object;
}

}  // namespace mortise::wasm
