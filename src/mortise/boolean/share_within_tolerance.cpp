// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertices, then edges, then faces; each step only looks at what those before it left apart.
#include "mortise/boolean/share_within_tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "mortise/base/sort_unique.h"
#include "mortise/boolean/folded_faces.h"
#include "mortise/boolean/shared_edges.h"
#include "mortise/boolean/triangulate_shared_faces.h"
#include "mortise/geom/box_tree.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/face_marks.h"

namespace mortise {
namespace {

constexpr std::size_t faces_per_report = 1024;

using Corners = std::array<std::uint32_t, 3>;

// Per operand and vertex: the shared vertex it becomes.
using SharedVertexOf = std::vector<std::vector<std::uint32_t>>;

struct SharedFace {
  std::uint32_t operand, face;
  Corners corners;
};

double largest_coordinate(std::span<const SurfaceMesh* const> operands) {
  double largest = 0;
  for (const SurfaceMesh* operand : operands) {
    for (const Vec3d& p : operand->points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return largest;
}

// In the order of their coordinates, whichever operand has them.
SharedVertexOf join_vertices(std::span<const SurfaceMesh* const> operands, SharedVertices& vertices, ToleranceReport& report) {
  struct Given {
    std::array<double, 3> place;
    std::uint32_t operand, vertex;

    bool operator<(const Given& o) const { return std::tie(place, operand, vertex) < std::tie(o.place, o.operand, o.vertex); }
  };
  SharedVertexOf shared;
  std::vector<Given> given;
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    const std::vector<Vec3d>& points = operands[k]->points;
    shared.emplace_back(points.size(), SharedVertices::none);
    for (std::uint32_t v = 0; v < points.size(); ++v) given.push_back({{points[v].x, points[v].y, points[v].z}, k, v});
  }
  std::sort(given.begin(), given.end());
  for (const Given& g : given) {
    const Vec3d& p = operands[g.operand]->points[g.vertex];
    const std::uint32_t v = vertices.find_or_add(p);
    shared[g.operand][g.vertex] = v;
    const double moved = length(vertices[v] - p);
    report.moved_vertices += moved > 0 ? 1 : 0;
    report.largest_move = std::max(report.largest_move, moved);
  }
  return shared;
}

// Those that are still triangles.
std::vector<SharedFace> read_faces(std::span<const SurfaceMesh* const> operands, const SharedVertexOf& shared, ToleranceReport& report) {
  std::vector<SharedFace> faces;
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    for (std::uint32_t f = 0; f < operands[k]->triangles.size(); ++f) {
      const Triangle& t = operands[k]->triangles[f];
      Corners c{};
      for (std::size_t i = 0; i < 3; ++i) c[i] = shared[k][t[i].index()];
      const bool was_triangle = t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
      if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) {
        faces.push_back({k, f, c});
      } else if (was_triangle) {
        report.collapsed.push_back({k, f});
      }
    }
  }
  return faces;
}

std::vector<SharedEdge> edges_of(const std::vector<SharedFace>& faces) {
  std::vector<SharedEdge> edges;
  for (const SharedFace& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(edge_between(face.corners[i], face.corners[(i + 1) % 3]));
  }
  return edges;
}

// Finds the vertices that are put into a face: near its plane, and seen along its normal inside of it.
class VerticesInFaces {
 public:
  VerticesInFaces(const SharedVertices& vertices, const SharedEdges& edges, double tolerance)
      : vertices_(vertices), edges_(edges), tolerance_(tolerance) {
    std::vector<Box3> boxes;
    for (std::uint32_t v = 0; v < vertices.size(); ++v) boxes.push_back(box_round({vertices[v]}, 0));
    tree_ = BoxTree(boxes);
  }

  // Ascending; none of those along its edges.
  [[nodiscard]] std::vector<std::uint32_t> find(const Corners& corners) const {
    const Vec3d &a = vertices_[corners[0]], &b = vertices_[corners[1]], &c = vertices_[corners[2]];
    std::vector<std::uint32_t> inside;
    tree_.for_each_meeting(box_round({a, b, c}, tolerance_), [&](std::uint32_t v) {
      if (is_over(a, b, c, vertices_[v])) inside.push_back(v);
    });
    if (inside.empty()) return inside;
    std::vector<std::uint32_t> on_edges;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::vector<std::uint32_t> along = edges_.vertices_along(corners[i], corners[(i + 1) % 3]);
      on_edges.insert(on_edges.end(), along.begin(), along.end());
    }
    std::sort(on_edges.begin(), on_edges.end());
    std::erase_if(inside, [&](std::uint32_t v) { return std::binary_search(on_edges.begin(), on_edges.end(), v); });
    std::sort(inside.begin(), inside.end());
    return inside;
  }

 private:
  [[nodiscard]] bool is_over(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p) const {
    const Vec3d normal = cross(b - a, c - a);
    const double size = length(normal);
    if (!(size > 0) || std::fabs(dot(p - a, normal)) > tolerance_ * size) return false;
    return dot(cross(b - a, p - a), normal) > 0 && dot(cross(c - b, p - b), normal) > 0 && dot(cross(a - c, p - c), normal) > 0;
  }

  const SharedVertices& vertices_;
  const SharedEdges& edges_;
  double tolerance_;
  BoxTree tree_;
};

// Puts triangles together to the mesh of one operand.
class OperandWriter {
 public:
  OperandWriter(const SurfaceMesh& given, const SharedVertices& vertices) : given_(given), vertices_(vertices), number_(vertices.size()) {
    operand_.mesh.label_names = given.label_names;
  }

  void add(std::uint32_t face, const std::vector<Corners>& triangles) {
    for (const Corners& corners : triangles) {
      Triangle t;
      for (std::size_t i = 0; i < 3; ++i) t[i] = number_of(corners[i]);
      operand_.mesh.triangles.push_back(t);
      operand_.source_face.push_back(face);
      append_face_marks(given_, FaceId(face), operand_.mesh);
      if (triangles.size() > 1 && !operand_.mesh.diagonals.empty()) operand_.mesh.diagonals.back() = 0;
    }
  }

  // The source of a vertex is the lowest one that went there.
  [[nodiscard]] ImprintedOperand finish(const std::vector<std::uint32_t>& shared) && {
    std::vector<std::uint32_t> source(vertices_.size(), Provenance::none);
    for (std::size_t v = shared.size(); v-- > 0;) source[shared[v]] = static_cast<std::uint32_t>(v);
    for (const std::uint32_t id : operand_.vertex_ids) operand_.source_vertex.push_back(std::uint32_t{source[id]});
    return std::move(operand_);
  }

 private:
  VertexId number_of(std::uint32_t v) {
    if (!number_[v].is_valid()) {
      number_[v] = VertexId(operand_.mesh.points.size());
      operand_.mesh.points.push_back(vertices_[v]);
      operand_.vertex_ids.push_back(v);
    }
    return number_[v];
  }

  const SurfaceMesh& given_;
  const SharedVertices& vertices_;
  std::vector<VertexId> number_;  // per shared vertex
  ImprintedOperand operand_;
};

void list_folded(std::span<const SurfaceMesh* const> operands, SharedOperands& shared) {
  std::vector<OperandFace>& unresolved = shared.report.unresolved;
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    const std::vector<std::uint32_t> faces = find_folded_faces(*operands[k], shared.operands[k]);
    if (!faces.empty()) shared.folded.push_back(k);
    for (const std::uint32_t f : faces) unresolved.push_back({k, f});
  }
  sort_unique(unresolved);
}

}  // namespace

SharedOperands share_within_tolerance(std::span<const SurfaceMesh* const> operands, double tolerance, const ProgressCallback& progress) {
  SharedOperands result;
  SharedVertices vertices(tolerance, largest_coordinate(operands));
  const SharedVertexOf shared = join_vertices(operands, vertices, result.report);
  const std::vector<SharedFace> faces = read_faces(operands, shared, result.report);
  const std::uint32_t given_count = vertices.size();
  SharedEdges edges(vertices, tolerance, edges_of(faces));
  edges.put_in_vertices(progress);
  edges.join_crossings(progress);
  result.report.made_vertices = vertices.size() - given_count;

  const VerticesInFaces inside(vertices, edges, tolerance);
  SharedFaceTriangulator triangulator(vertices, edges);
  std::vector<OperandWriter> writers;
  for (const SurfaceMesh* operand : operands) writers.emplace_back(*operand, vertices);
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i % faces_per_report == 0) report_progress(progress, "share_within_tolerance", 0);
    const auto& [operand, face, corners] = faces[i];
    if (!triangulator.triangulate(corners, inside.find(corners), triangles)) result.report.unresolved.push_back({operand, face});
    writers[operand].add(face, triangles);
  }
  for (std::size_t k = 0; k < operands.size(); ++k) result.operands.push_back(std::move(writers[k]).finish(shared[k]));
  list_folded(operands, result);
  return result;
}

}  // namespace mortise
