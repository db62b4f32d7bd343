// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertices in the plane count as in front of it: then every face is cut in one segment or not at all, and segments chain up
// over the edges they cross. Only afterwards do the points of edges that end in the plane move into their vertices.
#include "mortise/mesh/slice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "mortise/base/error.h"
#include "mortise/exact/double_double.h"
#include "mortise/exact/plane_predicates.h"
#include "mortise/mesh/repeats_vertex.h"
#include "mortise/mesh/require_closed.h"
#include "mortise/mesh/require_plane.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/validate.h"
#include "mortise/mesh/wedge_partners.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

constexpr const char* stage = "slice";

using Polygon = std::vector<Vec3d>;

void drop_repeating_faces(SurfaceMesh& mesh) {
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), repeats_vertex), mesh.triangles.end());
}

/// Follows the plane from face to face.
class Cut {
 public:
  Cut(const SurfaceMesh& mesh, const MeshTopology& topology, const Plane& plane)
      : mesh_(mesh), plane_(plane), partner_(find_wedge_partners(mesh, topology)), is_done_(mesh.triangles.size(), false) {
    side_.reserve(mesh.points.size());
    for (const Vec3d& p : mesh.points) side_.push_back(side_of(plane, p));
  }

  /// One polygon for each chain of cut faces, in the order of their lowest faces.
  std::vector<Polygon> trace_all() {
    std::vector<Polygon> polygons;
    for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (!is_done_[f] && rising_side(FaceId(f))) polygons.push_back(trace_from(FaceId(f)));
    }
    return polygons;
  }

 private:
  [[nodiscard]] bool is_behind(HalfEdge h) const { return side_[origin_of(mesh_, h).index()] == Sign::Negative; }

  /// The half-edge of a face that comes from behind the plane, if the plane cuts it. The inside lies left of the way from the
  /// side that goes back to this one.
  [[nodiscard]] std::optional<HalfEdge> rising_side(FaceId f) const {
    const auto first = static_cast<HalfEdge>(3 * f.index());
    for (HalfEdge h = first; h < first + 3; ++h) {
      if (is_behind(h) && !is_behind(next_in_face(h))) return h;
    }
    return std::nullopt;
  }

  Polygon trace_from(FaceId first) {
    Polygon polygon;
    FaceId f = first;
    do {
      is_done_[f.index()] = true;
      const HalfEdge h = *rising_side(f);
      polygon.push_back(crossing(origin_of(mesh_, h), origin_of(mesh_, next_in_face(h))));
      f = face_of(partner_[h]);
    } while (f != first);
    return polygon;
  }

  [[nodiscard]] Vec3d crossing(VertexId behind, VertexId front) const {
    const Vec3d &a = mesh_.points[behind.index()], &b = mesh_.points[front.index()];
    return side_[front.index()] == Sign::Zero ? b : nearest_crossing(plane_, a, b);
  }

  const SurfaceMesh& mesh_;
  const Plane& plane_;
  std::vector<HalfEdge> partner_;
  std::vector<Sign> side_;
  std::vector<bool> is_done_;
};

/// The polygon without points that repeat and without ways that turn back on themselves; nothing when nothing is left.
Polygon without_spikes(const Polygon& polygon) {
  Polygon kept;
  for (const Vec3d& p : polygon) {
    if (!kept.empty() && kept.back() == p) continue;
    if (kept.size() >= 2 && kept[kept.size() - 2] == p) {
      kept.pop_back();
    } else {
      kept.push_back(p);
    }
  }
  std::size_t begin = 0, end = kept.size();
  while (end - begin >= 2) {
    if (kept[begin] == kept[end - 1] || kept[begin] == kept[end - 2]) {
      --end;
    } else if (kept[begin + 1] == kept[end - 1]) {
      ++begin;
    } else {
      break;
    }
  }
  if (end - begin < 3) return {};
  return {kept.begin() + static_cast<std::ptrdiff_t>(begin), kept.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// Areas seen from the front of a plane, by the projection along the largest component of its normal.
class AreaInPlane {
 public:
  explicit AreaInPlane(const Vec3d& normal) {
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
      if (std::fabs(normal[i]) > std::fabs(normal[axis_])) axis_ = i;
    }
    double square = 1;
    for (const std::size_t i : {(axis_ + 1) % 3, (axis_ + 2) % 3}) square += normal[i] / normal[axis_] * (normal[i] / normal[axis_]);
    factor_ = (normal[axis_] < 0 ? -0.5 : 0.5) * std::sqrt(square);
  }

  [[nodiscard]] double of(const Polygon& polygon) const {
    const std::size_t u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    double size = 0;
    for (const Vec3d& p : polygon) size = std::max({size, std::fabs(p[u]), std::fabs(p[v])});
    int exponent = 0;
    std::frexp(size, &exponent);
    const auto from_first = [&](std::size_t i, std::size_t k) {
      return DoubleDouble::difference(std::ldexp(polygon[i][k], -exponent), std::ldexp(polygon[0][k], -exponent));
    };
    DoubleDouble sum;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      sum = sum + (from_first(i, u) * from_first(i + 1, v) - from_first(i, v) * from_first(i + 1, u));
    }
    return std::ldexp(factor_ * sum.hi, 2 * exponent);
  }

 private:
  std::size_t axis_ = 0;
  double factor_ = 0;
};

}  // namespace

Section slice(const SurfaceMesh& mesh, const Plane& plane) {
  validate(mesh);
  require_plane(plane, stage);
  WeldedMesh welded = weld(mesh);
  drop_repeating_faces(welded.mesh);
  const MeshTopology topology = build_topology(welded.mesh);
  require_closed(welded, topology, stage);
  Section section;
  const AreaInPlane area(plane.normal);
  for (const Polygon& traced : Cut(welded.mesh, topology, plane).trace_all()) {
    Polygon polygon = without_spikes(traced);
    if (polygon.empty()) continue;
    section.areas.push_back(area.of(polygon));
    section.area += section.areas.back();
    section.polygons.push_back(std::move(polygon));
  }
  return section;
}

}  // namespace mortise
