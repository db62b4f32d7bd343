// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Pairs of real meshes in random poses, the same for the same seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise::peers {

/// How two meshes are put together.
enum class Pose : std::uint8_t {
  Free,     ///< each turned, sized and moved at random
  Aligned,  ///< not turned, sized by powers of two, sides of the boxes on each other: coplanar faces
  Turned,   ///< a mesh and its quarter turn: shared vertices, coplanar and mirrored faces
  Same,     ///< a mesh turned at random, twice
};

[[nodiscard]] const char* pose_name(Pose pose);

struct Pair {
  Pose pose;
  std::string file_a, file_b;  ///< of the data
  std::uint64_t seed;          ///< of the pose
};

struct PosedPair {
  SurfaceMesh a, b;
};

/// Names of the closed meshes of the data that do not cross themselves, by number of triangles.
struct Files {
  std::vector<std::string> moderate;  ///< up to 20,000
  std::vector<std::string> large;     ///< up to 120,000
  std::vector<std::string> needles;   ///< up to 20,000; results in long triangles take seconds
};
[[nodiscard]] const Files& files();

[[nodiscard]] std::vector<Pair> make_pairs(std::uint64_t seed);

/// The mesh of a file of the data, equal vertices merged.
[[nodiscard]] SurfaceMesh load(const std::string& file);

/// Both meshes moved: sizes of 0.6 to 1.6 about the origin.
[[nodiscard]] PosedPair place(const Pair& pair, const SurfaceMesh& a, const SurfaceMesh& b);

}  // namespace mortise::peers
