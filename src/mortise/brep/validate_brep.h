// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Whether a model and its mesh agree, asked of the mesh anew.
#pragma once

#include <string>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// What is wrong with a model, a sentence each; empty when it is sound.
///
/// Every entity of the mesh is classified once, and its boundary on the closure of what it lies on; the tables up and down are
/// each other's inverse; loops are closed; every shell has the characteristic of its triangles: its vertices - edges + the sum over
/// its faces of 2 - 2 genus - loops, which is Euler-Poincare.
/// O(n log n) and much memory: for tests and for models from elsewhere.
[[nodiscard]] std::vector<std::string> find_faults(const SurfaceMesh& mesh, const ClassifiedBrep& model);

}  // namespace mortise
