// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Rounds over grids, and the result of the last one seen from the operands as given.
#include "mortise/boolean/repair_by_snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "mortise/boolean/given_operands.h"
#include "mortise/geom/length.h"

namespace mortise {
namespace {

// 2^-bits of the largest coordinate.
constexpr std::array grids{46, 40, 34, 28, 23};
constexpr std::array float32_grids{22, 20, 18, 16, 14};

constexpr int most_rounds = 8;  // on one grid; after two only while each mends half of what failed

// A cube of side 2^exponent round a point of a grid: its number along each axis.
struct Voxel {
  int exponent;
  std::array<double, 3> place;

  bool operator<(const Voxel& other) const { return std::tie(exponent, place) < std::tie(other.exponent, other.place); }
};

Voxel voxel_of(const Vec3d& p, int bits) {
  int exponent = 0;
  std::frexp(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), &exponent);
  Voxel voxel{exponent - bits, {}};
  for (std::size_t i = 0; i < 3; ++i) voxel.place[i] = std::floor(std::ldexp(p[i], -voxel.exponent) + 0.5);
  return voxel;
}

Vec3d centre_of(const Voxel& voxel) {
  Vec3d centre;
  for (std::size_t i = 0; i < 3; ++i) centre[i] = std::ldexp(voxel.place[i], voxel.exponent);
  return centre;
}

// Vertices at their nearest coordinates, until they are put on grids.
class SnappedPoints {
 public:
  explicit SnappedPoints(const std::vector<Vec3d>& nearest) : nearest_(nearest), bits_(nearest.size(), 0) {}

  // Puts vertices on a grid, and all in their voxels with them; they move by half a voxel at most.
  void snap(const std::vector<std::uint32_t>& vertices, int bits) {
    std::vector<Voxel> voxels;
    for (const std::uint32_t v : vertices) voxels.push_back(voxel_of(nearest_[v], bits));
    std::sort(voxels.begin(), voxels.end());
    for (std::size_t v = 0; v < nearest_.size(); ++v) {
      if (std::binary_search(voxels.begin(), voxels.end(), voxel_of(nearest_[v], bits))) bits_[v] = bits;
    }
  }

  [[nodiscard]] std::vector<Vec3d> positions() const {
    std::vector<Vec3d> positions = nearest_;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (bits_[v] == 0) continue;
      const Vec3d centre = centre_of(voxel_of(nearest_[v], bits_[v]));
      if (!(centre == nearest_[v])) positions[v] = centre;  // else it keeps its bits: -0 equals 0
    }
    return positions;
  }

 private:
  std::vector<Vec3d> nearest_;
  std::vector<int> bits_;  // 0: not on a grid
};

double largest_distance(const std::vector<Vec3d>& from, const std::vector<Vec3d>& to) {
  double largest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) largest = std::max(largest, length(to[i] - from[i]));
  return largest;
}

void move_to(const std::vector<Vec3d>& positions, std::vector<ImprintedOperand>& operands) {
  for (ImprintedOperand& operand : operands) {
    for (std::size_t v = 0; v < operand.vertex_ids.size(); ++v) operand.mesh.points[v] = positions[operand.vertex_ids[v]];
  }
}

// Corners of what failed, as vertices of the mesh of all facets.
std::vector<std::uint32_t> failed_vertices(const EvaluatedSelection& again, const std::vector<ImprintedOperand>& cut) {
  std::vector<std::uint32_t> vertices;
  for (const SourceId f : again.failed_faces) {
    const ImprintedOperand& operand = cut[again.faces.operand[f].index()];
    for (const VertexId v : operand.mesh.triangles[again.faces.face_in_operand(f)]) vertices.push_back(operand.vertex_ids[v.index()]);
  }
  return vertices;
}

}  // namespace

void repair_by_snapping(const OperandList& operands, Coordinates coordinates, const EvaluateAgain& evaluate_again,
                        EvaluatedSelection& folded) {
  const SurfaceMesh& all_facets = folded.all_facets.mesh;
  std::vector<ImprintedOperand> cut = read_operands(operands.meshes(), all_facets, folded.all_facets.provenance);
  SnappedPoints points(all_facets.points);
  EvaluatedSelection again;
  std::uint32_t rounds = 0;
  const auto arrange_again = [&] {
    move_to(points.positions(), cut);
    again = evaluate_again(meshes_of(cut));
    ++rounds;
  };
  arrange_again();
  for (const int bits : coordinates == Coordinates::Float32 ? float32_grids : grids) {
    for (int round = 0; round < most_rounds && !again.failed_faces.empty(); ++round) {
      const std::size_t failed = again.failed_faces.size();
      points.snap(failed_vertices(again, cut), bits);
      arrange_again();
      if (round > 0 && 2 * again.failed_faces.size() > failed) break;
    }
  }
  if (!again.failed_faces.empty()) return;
  Certificate& certificate = again.result.report.certificate;
  certificate.repair_displacement = largest_distance(all_facets.points, points.positions()) + certificate.largest_displacement;
  certificate.largest_displacement = folded.result.report.certificate.largest_displacement + certificate.repair_displacement;
  certificate.snap_rounds = rounds;
  certificate.moved_input_vertices = name_given_sources(operands.meshes(), cut, coordinates, again);
  BooleanReport& report = folded.result.report;
  report.certificate = std::move(certificate);
  again.result.report = std::move(report);
  folded = at_its_doubles(operands, std::move(again.result));
}

}  // namespace mortise
