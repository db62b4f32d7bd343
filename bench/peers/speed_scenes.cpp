// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Builds the operands.
#include "speed_scenes.h"

#include <array>
#include <cmath>
#include <map>

#include "mortise/mortise.h"
#include "support/data.h"

namespace mortise::peers {
namespace {

constexpr double degrees_per_radian = 57.29577951308232;

SurfaceMesh in_float32(SurfaceMesh mesh) {
  for (Vec3d& p : mesh.points) {
    for (std::size_t i = 0; i < 3; ++i) p[i] = static_cast<float>(p[i]);
  }
  return mesh;
}

/// An icosahedron, every triangle cut in `frequency` times as many rows, on the sphere of radius 1.
class Geodesic {
 public:
  explicit Geodesic(std::uint32_t frequency) : frequency_(frequency), corners_(make_icosphere(1, 0)) {
    for (const Triangle& face : corners_.triangles) add_face(face);
  }
  [[nodiscard]] SurfaceMesh take() { return std::move(mesh_); }

 private:
  // Row i, place j in the row: i steps from the first corner to the second, j to the third.
  void add_face(const Triangle& face) {
    for (std::uint32_t i = 0; i < frequency_; ++i) {
      for (std::uint32_t j = 0; i + j < frequency_; ++j) {
        const VertexId right = vertex(face, i + 1, j), up = vertex(face, i, j + 1);
        mesh_.triangles.push_back({vertex(face, i, j), right, up});
        if (i + j + 1 < frequency_) mesh_.triangles.push_back({right, vertex(face, i + 1, j + 1), up});
      }
    }
  }

  // Faces share the vertices of their edges: a vertex is known by its steps from the corners, in the order of these.
  VertexId vertex(const Triangle& face, std::uint32_t i, std::uint32_t j) {
    std::map<VertexId, std::uint32_t> steps;
    if (frequency_ - i - j != 0) steps[face[0]] = frequency_ - i - j;
    if (i != 0) steps[face[1]] = i;
    if (j != 0) steps[face[2]] = j;
    const auto [entry, is_new] = vertices_.try_emplace(steps, VertexId(mesh_.points.size()));
    if (is_new) {
      Vec3d sum;
      for (const auto& [corner, count] : steps) sum = sum + static_cast<double>(count) * corners_.points[corner.index()];
      mesh_.points.push_back((1 / std::sqrt(dot(sum, sum))) * sum);
    }
    return entry->second;
  }

  std::uint32_t frequency_;
  SurfaceMesh corners_;
  SurfaceMesh mesh_;
  std::map<std::map<VertexId, std::uint32_t>, VertexId> vertices_;
};

SpeedScene spheres() {
  const SurfaceMesh sphere = in_float32(Geodesic(71).take());
  const AffineMap pose = compose(rotation(Axis::X, 0.3 * degrees_per_radian), translation({0.5, 0, 0}));
  return {"spheres", {sphere, in_float32(transform(sphere, pose))}, {2}};
}

SpeedScene armadillo() {
  const SurfaceMesh scan = in_float32(test::read_data("scans/armadillo100k.ply"));
  return {"armadillo", {scan, in_float32(transform(scan, rotation(Axis::Y, 90)))}, {2}};
}

SpeedScene tori() {
  SpeedScene scene{"tori", {}, {2, 2, 2}};  // CGAL 5.5 crashes when they are folded one after the other
  const SurfaceMesh torus = make_torus(1, 0.25, 96, 48);
  const AffineMap upright = compose(rotation(Axis::X, 90), translation({1.2, 0, 0}));
  for (int k = 0; k < 8; ++k) scene.operands.push_back(in_float32(transform(torus, compose(upright, rotation(Axis::Z, 45 * k)))));
  return scene;
}

SpeedScene cubes() {
  SpeedScene scene{"cubes", {}, {10, 10, 10}};
  for (int i = 0; i < 1000; ++i) {
    const Vec3d lo{static_cast<double>(i / 100), static_cast<double>(i / 10 % 10), static_cast<double>(i % 10)};
    scene.operands.push_back(make_box(lo, lo + Vec3d{1, 1, 1}));
  }
  return scene;
}

}  // namespace

std::vector<SpeedScene> make_speed_scenes() {
  std::vector<SpeedScene> scenes{spheres(), tori(), cubes()};
  if (test::data_folder()) scenes.insert(scenes.begin() + 1, armadillo());
  return scenes;
}

}  // namespace mortise::peers
