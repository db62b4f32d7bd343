// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a remesher answers, and what it costs.
#pragma once

#include <string>

#include "mortise/brep/brep.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise::peers {

struct RemesherAnswer {
  std::string refusal;  ///< why there is no mesh; empty: there is one
  SurfaceMesh mesh;
  ClassifiedBrep model;
  double seconds = 0;
  double megabytes = 0;
};

}  // namespace mortise::peers
