// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A thick shell keeps its sense. Of a thin one, the exact sense from its extreme point, against the volume of its coordinates.
#include "mortise/boolean/moved_shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "mortise/base/union_find.h"
#include "mortise/boolean/radial_order.h"
#include "mortise/geom/length.h"
#include "mortise/geom/lexicographic.h"
#include "mortise/mesh/volume_sign.h"

namespace mortise {
namespace {

// What a space on a shell encloses, roughly.
struct SpaceSums {
  std::uint32_t space = 0;
  double six_volumes = 0, absolute = 0, two_areas = 0;
};

// One entry, or with walls one for each space behind or in front of triangles of the shell.
using ShellSums = std::vector<SpaceSums>;

void add_to(std::vector<SpaceSums>& spaces, std::uint32_t space, double six_volume, double two_area) {
  auto at = std::find_if(spaces.begin(), spaces.end(), [&](const SpaceSums& s) { return s.space == space; });
  if (at == spaces.end()) at = spaces.insert(at, {space});
  at->six_volumes += six_volume;
  at->absolute += std::fabs(six_volume);
  at->two_areas += two_area;
}

// Can motion of a surface so far have changed the sign of its volume? The volume changed by no more than area times distance.
bool may_be_turned(const SpaceSums& sums, double displacement) {
  constexpr double rounding_of_sums = 0x1p-30;
  return std::fabs(sums.six_volumes) <= 12 * sums.two_areas * displacement + rounding_of_sums * sums.absolute;
}

// The shell of each vertex, or none where no vertex of the shell moved; and how many there are.
struct ShellNumbers {
  std::vector<std::uint32_t> of_vertex;
  std::uint32_t count = 0;

  static constexpr std::uint32_t none = 0xffffffffU;
};

ShellNumbers number_shells(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& is_moved) {
  UnionFind joined(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    joined.join(t[0].value, t[1].value);
    joined.join(t[1].value, t[2].value);
  }
  ShellNumbers shells{std::vector<std::uint32_t>(mesh.points.size(), ShellNumbers::none)};
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    std::uint32_t& number = shells.of_vertex[joined.find(v)];
    if (is_moved[v] != 0 && number == ShellNumbers::none) number = shells.count++;
  }
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) shells.of_vertex[v] = shells.of_vertex[joined.find(v)];
  return shells;
}

std::vector<ShellSums> sum_shells(const MergedMesh& merged, const ShellNumbers& shells) {
  const SurfaceMesh& mesh = merged.mesh;
  const Provenance& p = merged.provenance;
  const bool has_walls = !p.covering_front.empty();
  std::vector<ShellSums> sums(shells.count);
  std::vector<Vec3d> origins(shells.count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    const std::uint32_t shell = shells.of_vertex[corners[0].index()];
    if (shell == ShellNumbers::none) continue;
    if (sums[shell].empty()) origins[shell] = mesh.points[corners[0].index()];
    const Vec3d a = mesh.points[corners[0].index()] - origins[shell], b = mesh.points[corners[1].index()] - origins[shell],
                c = mesh.points[corners[2].index()] - origins[shell];
    const double six_volume = dot(a, cross(b, c)), two_area = length(cross(b - a, c - a));
    const std::uint32_t behind = has_walls ? p.space_of(p.covering[t]) : 0, in_front = has_walls ? p.space_of(p.covering_front[t]) : 1;
    if (behind == in_front) continue;
    add_to(sums[shell], behind, six_volume, two_area);
    if (has_walls) add_to(sums[shell], in_front, -six_volume, two_area);
  }
  return sums;
}

// Triangles of each shell that motion so far can have turned, ascending.
std::vector<std::vector<FaceId>> thin_shells(const MergedMesh& merged, const std::vector<std::uint8_t>& is_moved, double displacement) {
  const ShellNumbers shells = number_shells(merged.mesh, is_moved);
  const std::vector<ShellSums> sums = sum_shells(merged, shells);
  std::vector<std::uint32_t> place(shells.count, ShellNumbers::none);
  std::uint32_t thin_count = 0;
  for (std::uint32_t i = 0; i < shells.count; ++i) {
    const auto may_be = [&](const SpaceSums& space) { return may_be_turned(space, displacement); };
    if (std::any_of(sums[i].begin(), sums[i].end(), may_be)) place[i] = thin_count++;
  }
  std::vector<std::vector<FaceId>> thin(thin_count);
  if (thin_count == 0) return thin;
  for (std::size_t t = 0; t < merged.mesh.triangles.size(); ++t) {
    const std::uint32_t shell = shells.of_vertex[merged.mesh.triangles[t][0].index()];
    if (shell != ShellNumbers::none && place[shell] != ShellNumbers::none) thin[place[shell]].push_back(FaceId(t));
  }
  return thin;
}

Sign sign_of_volume(const SurfaceMesh& mesh, std::span<const Triangle> triangles) {
  SurfaceMesh part;
  for (const Triangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(part.points.size());
    for (const VertexId v : t) part.points.push_back(mesh.points[v.index()]);
    part.triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  }
  return enclosed_volume_sign(part);
}

// The facets of the exact surface behind a shell. A repair may have taken the last triangle of a facet, so they are looked up
// by their points among all there were.
class ExactSurface {
 public:
  ExactSurface(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged)
      : facets_(facets), merged_(merged), joined_(merged.facets_before_repair.empty() ? 0 : faces.points.size()) {
    for (const KeptFacet& k : merged.facets_before_repair) {
      const PlanePoints& c = facets.corners[k.facet];
      joined_.join(c[0].value, c[1].value);
      joined_.join(c[1].value, c[2].value);
    }
    for (std::uint32_t i = 0; i < merged.facets_before_repair.size(); ++i) {
      by_piece_.emplace_back(piece_of(merged.facets_before_repair[i]), i);
    }
    std::sort(by_piece_.begin(), by_piece_.end());
  }

  [[nodiscard]] std::vector<KeptFacet> facets_of(std::span<const FaceId> shell) {
    std::vector<KeptFacet> found;
    for (const FaceId t : shell) found.push_back(merged_.facet_of_triangle[t.index()]);
    if (by_piece_.empty()) return found;
    std::vector<std::uint32_t> pieces;
    for (const KeptFacet& k : found) pieces.push_back(piece_of(k));
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    found.clear();
    for (const std::uint32_t piece : pieces) {
      auto at = std::lower_bound(by_piece_.begin(), by_piece_.end(), std::pair{piece, 0U});
      for (; at != by_piece_.end() && at->first == piece; ++at) found.push_back(merged_.facets_before_repair[at->second]);
    }
    return found;
  }

 private:
  [[nodiscard]] std::uint32_t piece_of(const KeptFacet& k) { return joined_.find(facets_.corners[k.facet][0].value); }

  const Facets& facets_;
  const MergedMesh& merged_;
  UnionFind joined_;                                               // points, by facets
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_piece_;  // smallest point, place in facets_before_repair
};

// Is the region outside an exact shell in front of its triangles? Read off at its lexicographically smallest point, as seeds are.
class ExactShell {
 public:
  ExactShell(const OperandFaces& faces, const Facets& facets, std::span<const KeptFacet> shell)
      : faces_(faces), facets_(facets), shell_(shell) {}

  [[nodiscard]] bool is_outward() const {
    const auto [facet, is_front_outside] = look();
    return is_front_outside != facet.is_flipped;
  }

  /// The region outside the shell.
  [[nodiscard]] RegionId surrounding() const {
    const auto [facet, is_front_outside] = look();
    return is_front_outside == facet.is_flipped ? facet.inside : facet.outside;
  }

 private:
  struct Sight {
    KeptFacet facet;
    bool is_front_outside;
  };

  // The first facet met from outside.
  [[nodiscard]] Sight look() const {
    const PointId v = smallest_point();
    const PointId p = lowest_neighbour(v);
    std::vector<FacetAtEdge> around;
    for (const KeptFacet& k : shell_) {
      if (has(corners(k), v) && has(corners(k), p)) around.push_back(facet_at_edge(faces_, facets_, k.facet, v, p));
    }
    const FacetAtEdge first = first_after_minus_y(faces_, around);
    const auto at = std::find_if(shell_.begin(), shell_.end(), [&](const KeptFacet& k) { return k.facet == first.facet; });
    return {*at, !first.is_front_after()};
  }

  [[nodiscard]] const PlanePoints& corners(const KeptFacet& k) const { return facets_.corners[k.facet]; }
  static bool has(const PlanePoints& c, PointId p) { return std::find(c.begin(), c.end(), p) != c.end(); }

  [[nodiscard]] bool is_smaller(PointId a, PointId b) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign s = faces_.points.compare(a, b, i);
      if (s != Sign::Zero) return s == Sign::Negative;
    }
    return false;
  }

  [[nodiscard]] PointId smallest_point() const {
    PointId smallest = corners(shell_.front())[0];
    for (const KeptFacet& k : shell_) {
      for (const PointId p : corners(k)) {
        if (p != smallest && is_smaller(p, smallest)) smallest = p;
      }
    }
    return smallest;
  }

  [[nodiscard]] PointId lowest_neighbour(PointId v) const {
    const PointSet& points = faces_.points;
    PointId lowest;
    for (const KeptFacet& k : shell_) {
      if (!has(corners(k), v)) continue;
      for (const PointId w : corners(k)) {
        if (w == v || (points.compare(w, v, 0) == Sign::Zero && points.compare(w, v, 1) == Sign::Zero)) continue;
        if (!lowest.is_valid() || points.orient2d(v, lowest, w, Axis::Z) == Sign::Negative) lowest = w;
      }
    }
    return lowest;
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  std::span<const KeptFacet> shell_;
};

// The triangle at the lowest place: its number may come from the order of operands.
FaceId lowest_triangle(const SurfaceMesh& mesh, std::span<const FaceId> shell) {
  const auto corners_of = [&](FaceId f) {
    std::array<Vec3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.points[mesh.triangles[f.index()][i].index()];
    std::sort(corners.begin(), corners.end(), is_lexicographically_less);
    return corners;
  };
  return *std::min_element(shell.begin(), shell.end(), [&](FaceId f, FaceId g) {
    const std::array<Vec3d, 3> a = corners_of(f), b = corners_of(g);
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_lexicographically_less);
  });
}

// Does the one volume a shell encloses have its exact sign?
bool keeps_sense(const MergedMesh& merged, std::span<const FaceId> shell, const ExactShell& exact) {
  std::vector<Triangle> triangles;
  for (const FaceId f : shell) triangles.push_back(merged.mesh.triangles[f.index()]);
  return sign_of_volume(merged.mesh, triangles) == (exact.is_outward() ? Sign::Positive : Sign::Negative);
}

// With walls: do spaces of each kind have volume, and the surrounding one, turned outside in, less than none?
bool keeps_senses(const MergedMesh& merged, std::span<const FaceId> shell, const ExactShell& exact) {
  const Provenance& p = merged.provenance;
  std::map<std::uint32_t, std::vector<Triangle>> boundary;  // by space, which lies behind its triangles
  for (const FaceId f : shell) {
    const Triangle& t = merged.mesh.triangles[f.index()];
    const std::uint32_t behind = p.space_of(p.covering[f.index()]), in_front = p.space_of(p.covering_front[f.index()]);
    if (behind == in_front) continue;
    boundary[behind].push_back(t);
    boundary[in_front].push_back({t[0], t[2], t[1]});
  }
  const std::uint32_t surrounding = p.space_of(merged.covering_of_region[exact.surrounding()]);
  return std::all_of(boundary.begin(), boundary.end(), [&](const auto& space) {
    return sign_of_volume(merged.mesh, space.second) == (space.first == surrounding ? Sign::Negative : Sign::Positive);
  });
}

}  // namespace

std::vector<FaceId> find_turned_shells(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged,
                                       const std::vector<std::uint8_t>& is_moved, double displacement) {
  const bool has_walls = !merged.provenance.covering_front.empty();
  std::vector<FaceId> turned;
  std::optional<ExactSurface> surface;
  for (const std::vector<FaceId>& shell : thin_shells(merged, is_moved, displacement)) {
    if (!surface) surface.emplace(faces, facets, merged);
    const std::vector<KeptFacet> kept = surface->facets_of(shell);
    const ExactShell exact(faces, facets, kept);
    const bool keeps = has_walls ? keeps_senses(merged, shell, exact) : keeps_sense(merged, shell, exact);
    if (!keeps) turned.push_back(lowest_triangle(merged.mesh, shell));
  }
  return turned;
}

}  // namespace mortise
