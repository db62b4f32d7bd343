// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Double-double where it is certain, else exact.
#include "mortise/mesh/volume_sign.h"

#include "mortise/exact/big_float.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/formulas.h"

namespace mortise {
namespace {

/// Six times the volume of the tetrahedra on all faces from one of the vertices.
template <class T>
T six_volumes(const SurfaceMesh& mesh) {
  const Vec3d& apex = mesh.points[mesh.triangles.front()[0].index()];
  T sum{};
  for (const Triangle& t : mesh.triangles) {
    sum = sum + orient3d_value<T>(mesh.points[t[0].index()], mesh.points[t[2].index()], mesh.points[t[1].index()], apex);
  }
  return sum;
}

}  // namespace

Sign enclosed_volume_sign(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) return Sign::Zero;
  if (const auto sign = certain_sign(six_volumes<DoubleDouble>(mesh))) return *sign;
  return six_volumes<BigFloat>(mesh).sign();
}

}  // namespace mortise
