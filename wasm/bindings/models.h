// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Models, attributes and lineage as JavaScript hands them in and gets them back.
#pragma once

#include <emscripten/val.h>

#include <span>
#include <vector>

#include "mortise/brep/attributes.h"
#include "mortise/brep/build_brep.h"
#include "mortise/mesh/provenance.h"

namespace mortise::wasm {

/// @param settings  {faceAngle, weakAngle?, edgeAngle, leastDangling, splitAtLabels, userEdges, seams, groups?}
[[nodiscard]] BrepRules rules_in(const emscripten::val& settings);

/// The settings to build a model again with: {groups?, userEdges?, normals?, planes?}, those that are given.
[[nodiscard]] emscripten::val recipe_out(const BrepRules& rules, const FaceNormals& normals);

/// A model with what it was built from. JavaScript keeps that, and it is built again for every call, the same way.
struct BuiltModel {
  SurfaceMesh mesh;
  FaceNormals normals;
  ClassifiedBrep model;
};

/// @param object  {mesh, settings}; settings are those of rules_in, with normals and planes of facets of a result, or the tables that no
/// building anew would give: those of a remeshed model
[[nodiscard]] BuiltModel model_in(const emscripten::val& object);

/// That model, or one of a mesh; vertices at one place are one then, and it is without data.
/// @param given  {mesh, settings, isModel}: for model_in, or settings are those of rules_in, with sources?
[[nodiscard]] BuiltModel given_model_in(const emscripten::val& given);

/// @param object  the arrays of the Provenance of a result; other sources and covering sets may be missing
[[nodiscard]] Provenance provenance_in(const emscripten::val& object);

/// @param sources  {provenance, operands} of the result of an operation: the meshes it was made from, or {plane} for a half-space
[[nodiscard]] FaceNormals source_normals_in(const emscripten::val& sources);

/// Vertices at one place are one; without data.
[[nodiscard]] SurfaceMesh welded_mesh_in(const emscripten::val& object);

/// @throws Error{InvalidArgument} when it is not that of a result of so many triangles made from these operands
void check_provenance(const Provenance& provenance, std::size_t triangles, std::span<const ModelView> operands);

/// @param array  of {name, value, pieceName, codes, targets}: codes are the numbers of kind and policies on split, merge and deletion,
///               targets dimension and number of one entity after the other
[[nodiscard]] std::vector<Attribute> attributes_in(const emscripten::val& array);
[[nodiscard]] emscripten::val attributes_out(std::span<const Attribute> attributes);

/// The links by result: arrays dimension, result, operand, source, measure.
[[nodiscard]] emscripten::val lineage_out(const Lineage& lineage);

}  // namespace mortise::wasm
