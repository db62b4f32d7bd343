// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The model of a result with those of its operands.
#pragma once

#include <functional>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/brep/build_brep.h"
#include "mortise/brep/lineage.h"
#include "support/boolean_scenes.h"

namespace mortise::test {

/// Everything about the models of one operation. Stays where it is: views refer into it.
struct ResultModel {
  ResultModel(Operation operation, std::vector<SurfaceMesh> operand_meshes, const BrepRules& rules = {}, const BooleanOptions& options = {})
      : ResultModel([&](const OperandList& list) { return evaluate_boolean(operation, list, options); }, std::move(operand_meshes), rules) {
  }

  ResultModel(const std::function<BooleanResult(const OperandList&)>& evaluate, std::vector<SurfaceMesh> operand_meshes,
              const BrepRules& rules = {})
      : meshes(std::move(operand_meshes)) {
    for (const SurfaceMesh& mesh : meshes) operand_models.push_back(build_brep(mesh));
    for (std::size_t k = 0; k < meshes.size(); ++k) operands.push_back(view_of(meshes[k], operand_models[k]));
    boolean = evaluate(pointers_to(meshes));
    std::vector<FaceNormals> normals;
    for (const SurfaceMesh& mesh : meshes) normals.push_back(measure_normals(mesh, build_topology(mesh)));
    model = build_brep(boolean.mesh, rules, source_normals(boolean.provenance, normals));
    result.triangles_of_face = view_of(boolean.mesh, model).triangles_of_face;
    lineage = trace_lineage(result, boolean.provenance, operands);
  }
  ResultModel(const ResultModel&) = delete;
  ResultModel& operator=(const ResultModel&) = delete;

  std::vector<SurfaceMesh> meshes;
  std::vector<ClassifiedBrep> operand_models;
  std::vector<ModelView> operands;
  BooleanResult boolean;
  ClassifiedBrep model;
  ModelView result{boolean.mesh, model, {}};
  Lineage lineage;
};

}  // namespace mortise::test
