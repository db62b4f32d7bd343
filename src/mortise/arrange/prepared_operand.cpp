// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Welds once, finds the rest from the welded corners.
#include "mortise/arrange/prepared_operand.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <utility>

#include "mortise/exact/point_set.h"
#include "mortise/exact/predicates.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/validate.h"

namespace mortise {

struct PreparedOperand::Knowledge {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> position_of_vertex, first_vertex, lowest;
  Connectivity connectivity;
  BoxTree tree;
  std::vector<std::uint8_t> has_area;
  double least_height = std::numeric_limits<double>::infinity();
  mutable std::once_flag self_pairs_flag;
  mutable SelfPairs self_pairs;

  explicit Knowledge(SurfaceMesh given) : mesh(std::move(given)) {
    validate(mesh);
    weld();
    connectivity = find_connectivity(mesh, lowest);
    tree = BoxTree(boxes_of_faces(mesh, 0));
    measure_faces();
  }

 private:
  void weld() {
    PointSet points;
    points.reserve(mesh.points.size());
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
      const std::uint32_t position = points.add_input(mesh.points[v]).value;
      if (position == first_vertex.size()) first_vertex.push_back(v);
      position_of_vertex.push_back(position);
      lowest.push_back(first_vertex[position]);
    }
  }

  void measure_faces() {
    has_area.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
      const Vec3d &a = mesh.points[t[0].index()], &b = mesh.points[t[1].index()], &c = mesh.points[t[2].index()];
      has_area.push_back(are_collinear(a, b, c) ? 0 : 1);
      if (has_area.back() != 0) least_height = std::min(least_height, height_of(a, b, c));
    }
  }

  // Half the smallest height: more than rounding takes from it, unless that leaves nothing to compare.
  static double height_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double longest = std::max({length(b - a), length(c - b), length(a - c)});
    const double height = length(cross(b - a, c - a)) / longest;
    return height > 0x1p-40 * longest ? height / 2 : 0;
  }
};

PreparedOperand::PreparedOperand(SurfaceMesh mesh) : knowledge_(std::make_unique<const Knowledge>(std::move(mesh))) {}
PreparedOperand::~PreparedOperand() = default;
PreparedOperand::PreparedOperand(PreparedOperand&&) noexcept = default;
PreparedOperand& PreparedOperand::operator=(PreparedOperand&&) noexcept = default;

const SurfaceMesh& PreparedOperand::mesh() const { return knowledge_->mesh; }
const std::vector<std::uint32_t>& PreparedOperand::position_of_vertex() const { return knowledge_->position_of_vertex; }
const std::vector<std::uint32_t>& PreparedOperand::first_vertex() const { return knowledge_->first_vertex; }
const Connectivity& PreparedOperand::connectivity() const { return knowledge_->connectivity; }
const BoxTree& PreparedOperand::tree() const { return knowledge_->tree; }

bool PreparedOperand::has_area(FaceId f) const { return knowledge_->has_area[f.index()] != 0; }
double PreparedOperand::least_height() const { return knowledge_->least_height; }

const SelfPairs& PreparedOperand::self_pairs() const {
  const Knowledge& k = *knowledge_;
  std::call_once(k.self_pairs_flag, [&k] { k.self_pairs = find_self_pairs(k.mesh, k.lowest); });
  return k.self_pairs;
}

}  // namespace mortise
