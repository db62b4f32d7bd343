// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What is remeshed, by us and by peers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mortise/mortise.h"

namespace mortise::peers {

struct RemeshScene {
  SurfaceMesh mesh;
  FaceNormals normals;
  ClassifiedBrep model;  ///< without seams
  SizingProxy sizes;
  bool is_uniform = true;          ///< one size everywhere, which every peer knows
  std::vector<std::uint8_t> zone;  ///< as in RemeshRules
};

struct NamedScene {
  std::string name;
  std::string what;
  std::function<RemeshScene()> make;
};

/// Generated ones first; those of real meshes where MORTISE_DATA is.
[[nodiscard]] std::vector<NamedScene> remesh_scenes();

}  // namespace mortise::peers
