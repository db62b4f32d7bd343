// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/beyond_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "mortise/geom/length.h"
#include "mortise/remesh/closest_pieces.h"

namespace mortise {
namespace {

using Polygon = std::vector<Vec3d>;  // convex, in a plane

constexpr double undecided = 1.0 / 16;     // of the bound
constexpr double on_plane = 1e-12;         // of the reach of a polygon
constexpr std::size_t most_pieces = 1024;  // of one triangle

struct CutPlane {
  Vec3d normal;  // towards the inside
  Vec3d at;
};

struct Halves {
  Polygon inside, outside;
};

Halves cut(const Polygon& polygon, const CutPlane& plane) {
  std::vector<double> heights;
  double reach = 0;
  for (const Vec3d& p : polygon) {
    heights.push_back(dot(plane.normal, p - plane.at));
    reach = std::max(reach, std::fabs(heights.back()));
  }
  for (double& height : heights) height = std::fabs(height) <= on_plane * reach ? 0 : height;
  Halves halves;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (heights[i] >= 0) halves.inside.push_back(polygon[i]);
    if (heights[i] <= 0) halves.outside.push_back(polygon[i]);
    if ((heights[i] > 0) == (heights[j] > 0) || heights[i] == 0 || heights[j] == 0) continue;
    const Vec3d crossing = polygon[i] + heights[i] / (heights[i] - heights[j]) * (polygon[j] - polygon[i]);
    halves.inside.push_back(crossing);
    halves.outside.push_back(crossing);
  }
  const auto any = [&](bool is_inside) {
    return std::any_of(heights.begin(), heights.end(), [&](double height) { return is_inside ? height > 0 : height < 0; });
  };
  if (!any(true)) halves.inside.clear();
  if (!any(false)) halves.outside.clear();
  return halves;
}

// Through its edges, along its normal.
std::array<CutPlane, 3> sides_of(const PlacedTriangle& t) {
  const std::array<PlanePoint, 3> corners{{{0, 0}, {t.length, 0}, {t.apex_x, t.apex_y}}};
  std::array<CutPlane, 3> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlanePoint &from = corners[k], &to = corners[(k + 1) % 3];
    sides[k] = {(from.y - to.y) * t.axis_x + (to.x - from.x) * t.axis_y, in_space(t, from)};
  }
  return sides;
}

Vec3d middle_of(const Polygon& polygon) {
  Vec3d sum;
  for (const Vec3d& p : polygon) sum = sum + p;
  return 1.0 / static_cast<double>(polygon.size()) * sum;
}

// The two corners farthest apart.
std::pair<Vec3d, Vec3d> ends_of(const Polygon& polygon) {
  std::pair<Vec3d, Vec3d> ends{polygon[0], polygon[0]};
  double farthest = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = i + 1; j < polygon.size(); ++j) {
      const Vec3d way = polygon[j] - polygon[i];
      if (dot(way, way) <= farthest) continue;
      farthest = dot(way, way);
      ends = {polygon[i], polygon[j]};
    }
  }
  return ends;
}

class Prover {
 public:
  Prover(ClosestPieces& surface, double bound) : surface_(surface), bound_(bound) {}

  /// A place beyond the bound, if there may be one.
  [[nodiscard]] std::optional<PlaceBeyond> find(const std::array<Vec3d, 3>& corners) {
    waiting_.assign(1, Polygon(corners.begin(), corners.end()));
    found_.reset();
    for (std::size_t pieces = 0; !waiting_.empty() && !found_; ++pieces) {
      const Polygon piece = std::move(waiting_.back());
      waiting_.pop_back();
      look_at(piece, pieces >= most_pieces);
    }
    return found_;
  }

 private:
  void look_at(const Polygon& piece, bool is_last) {
    const Vec3d middle = middle_of(piece);
    const ClosestPiece closest = surface_.closest(middle);
    if (is_last || !(closest.distance <= bound_)) return note(middle, closest);
    if (is_within(piece, closest.piece)) return;
    const PlacedTriangle& triangle = surface_.placed(closest.piece);
    if (triangle.apex_y > 0 && cut_along(piece, triangle, closest.piece)) return;
    halve(piece, closest);
  }

  [[nodiscard]] bool is_within(const Polygon& piece, std::uint32_t triangle) const {
    return std::all_of(piece.begin(), piece.end(), [&](const Vec3d& p) { return surface_.distance_to(triangle, p) <= bound_; });
  }

  // The part over the triangle, and what is beside it. Not when all of it is over it, or nothing.
  bool cut_along(const Polygon& piece, const PlacedTriangle& triangle, std::uint32_t number) {
    const std::size_t others = waiting_.size();
    Polygon over = piece;
    for (const CutPlane& side : sides_of(triangle)) {
      Halves halves = cut(over, side);
      if (halves.inside.empty()) {
        waiting_.resize(others);
        return false;
      }
      over = std::move(halves.inside);
      if (!halves.outside.empty()) waiting_.push_back(std::move(halves.outside));
    }
    if (waiting_.size() == others) return false;
    if (!is_within(over, number)) waiting_.push_back(std::move(over));
    return true;
  }

  void halve(const Polygon& piece, const ClosestPiece& to_middle) {
    for (const Vec3d& p : piece) {
      const ClosestPiece to_corner = surface_.closest(p);
      if (!(to_corner.distance <= bound_)) return note(p, to_corner);
    }
    const auto [a, b] = ends_of(piece);
    if (length(b - a) <= undecided * bound_) return note(middle_of(piece), to_middle);
    Halves halves = cut(piece, {b - a, 0.5 * (a + b)});
    for (Polygon* half : {&halves.inside, &halves.outside}) {
      if (!half->empty()) waiting_.push_back(std::move(*half));
    }
  }

  void note(const Vec3d& at, const ClosestPiece& closest) { found_ = PlaceBeyond{{}, at, FaceId(closest.piece), closest.distance}; }

  ClosestPieces& surface_;
  double bound_;
  std::vector<Polygon> waiting_;
  std::optional<PlaceBeyond> found_;
};

std::array<Vec3d, 3> corners_of(const SurfaceMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.points[a.index()], mesh.points[b.index()], mesh.points[c.index()]};
}

/// The triangles of one model face.
struct FaceSurface {
  ClosestPieces pieces;
  std::vector<FaceId> triangles;  ///< by piece
};

IdVector<ModelFaceId, FaceSurface> surfaces_of(const FacedMesh& of, std::size_t count) {
  IdVector<ModelFaceId, FaceSurface> surfaces(count);
  for (std::size_t t = 0; t < of.mesh.triangles.size(); ++t) {
    FaceSurface& surface = surfaces[of.face_of_triangle[t]];
    surface.pieces.add(corners_of(of.mesh, t), 3);
    surface.triangles.emplace_back(t);
  }
  for (std::size_t f = 0; f < count; ++f) surfaces[ModelFaceId(f)].pieces.close();
  return surfaces;
}

}  // namespace

std::vector<PlaceBeyond> find_beyond(const FacedMesh& mesh, const FacedMesh& other, double bound) {
  std::size_t count = 0;
  for (const FacedMesh* of : {&mesh, &other}) {
    for (const ModelFaceId face : of->face_of_triangle) count = std::max(count, face.index() + 1);
  }
  IdVector<ModelFaceId, FaceSurface> surfaces = surfaces_of(other, count);
  std::vector<PlaceBeyond> beyond;
  for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    FaceSurface& surface = surfaces[mesh.face_of_triangle[t]];
    std::optional<PlaceBeyond> found = Prover(surface.pieces, bound).find(corners_of(mesh.mesh, t));
    if (!found) continue;
    found->triangle = FaceId(t);
    found->closest = surface.triangles.empty() ? FaceId() : surface.triangles[found->closest.index()];
    beyond.push_back(*found);
  }
  return beyond;
}

}  // namespace mortise
