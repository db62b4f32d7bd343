// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Refuses meshes no operation can work on.
#pragma once

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Checks that every coordinate is finite, every index in range, labels one per face and named, data channels sound.
/// @throws Error{NotFinite} naming vertices, Error{BadIndex} naming faces, Error{InvalidArgument} when there are labels but
/// not one per face, or naming the faces whose label has no name; also naming a channel that has no name, another one's name,
/// not as many values as components and places ask for, or an infinite value
void validate(const SurfaceMesh& mesh);

}  // namespace mortise
