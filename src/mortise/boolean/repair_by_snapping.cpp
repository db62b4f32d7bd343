// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Rounds over grids, and the result of the last one seen from the operands as given.
#include "mortise/boolean/repair_by_snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "mortise/boolean/imprinted_operand.h"
#include "mortise/geom/length.h"

namespace mortise {
namespace {

constexpr std::array grids{46, 40, 34, 28, 23};  // 2^-bits of the largest coordinate
constexpr int most_rounds = 8;                   // on one grid; after two only while each mends half of what failed

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

// Vertices at their nearest doubles, until they are put on grids.
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

std::vector<const SurfaceMesh*> meshes_of(const std::vector<ImprintedOperand>& operands) {
  std::vector<const SurfaceMesh*> meshes;
  for (const ImprintedOperand& o : operands) meshes.push_back(&o.mesh);
  return meshes;
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

// Sources of a result of the cut operands in terms of the operands as given. Returns those of their vertices that moved.
std::vector<OperandVertex> name_sources(std::span<const SurfaceMesh* const> operands, const std::vector<ImprintedOperand>& cut,
                                        EvaluatedSelection& again) {
  Provenance& p = again.result.provenance;
  const auto name_face = [&](std::uint32_t operand, std::uint32_t& face) { face = cut[operand].source_face[face]; };
  for (std::size_t t = 0; t < p.source_face.size(); ++t) name_face(p.source_operand[t], p.source_face[t]);
  for (std::size_t i = 0; i < p.other_source_face.size(); ++i) name_face(p.other_source_operand[i], p.other_source_face[i]);
  const std::size_t vertex_count = again.point_of_vertex.size();
  std::vector<std::uint32_t> vertex_at(again.faces.points.size(), Provenance::none);
  for (std::uint32_t v = 0; v < vertex_count; ++v) vertex_at[again.point_of_vertex[v].index()] = v;
  p.vertex_operand.assign(vertex_count, Provenance::none);
  p.vertex_source.assign(vertex_count, Provenance::none);
  std::vector<OperandVertex> moved;
  for (std::uint32_t k = 0; k < cut.size(); ++k) {
    const std::vector<PointId>& points = again.faces.point_of_vertex[OperandId(k)];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t v = vertex_at[points[i].index()], source = cut[k].source_vertex[i];
      if (v == Provenance::none || source == Provenance::none) continue;
      if (!(again.result.mesh.points[v] == operands[k]->points[source])) {
        moved.push_back({k, source});
      } else if (p.vertex_operand[v] == Provenance::none) {
        p.vertex_operand[v] = k;
        p.vertex_source[v] = source;
      }
    }
  }
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  return moved;
}

// The result as one whose points are exactly its doubles.
void take_over(const OperandList& operands, BooleanResult&& last, EvaluatedSelection& folded) {
  BooleanResult& result = folded.result;
  result.mesh = std::move(last.mesh);
  result.provenance = std::move(last.provenance);
  result.graph = std::move(last.graph);
  result.report.certificate = std::move(last.report.certificate);
  folded.faces = gather_operands(operands);
  folded.point_of_vertex.clear();
  for (const Vec3d& p : result.mesh.points) folded.point_of_vertex.push_back(folded.faces.points.add_input(p));
  folded.failed_faces.clear();
}

}  // namespace

void repair_by_snapping(const OperandList& operands, const EvaluateAgain& evaluate_again, EvaluatedSelection& folded) {
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
  for (const int bits : grids) {
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
  certificate.moved_input_vertices = name_sources(operands.meshes(), cut, again);
  take_over(operands, std::move(again.result), folded);
}

}  // namespace mortise
