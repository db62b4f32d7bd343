// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The exact sense of a shell from its extreme point, against the volume of its doubles.
#include "mortise/boolean/moved_shells.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "mortise/base/union_find.h"
#include "mortise/boolean/radial_order.h"
#include "mortise/mesh/measures.h"

namespace mortise {
namespace {

// Triangles of each shell of moved vertices, ascending.
std::vector<std::vector<FaceId>> moved_shells(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& is_moved) {
  UnionFind shells(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    shells.join(t[0].value, t[1].value);
    shells.join(t[1].value, t[2].value);
  }
  std::vector<std::uint8_t> all_moved(mesh.points.size(), 1);
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (is_moved[v] == 0) all_moved[shells.find(v)] = 0;
  }
  std::vector<std::uint32_t> number(mesh.points.size(), 0xffffffffU);
  std::vector<std::vector<FaceId>> result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = shells.find(mesh.triangles[t][0].value);
    if (all_moved[root] == 0) continue;
    if (number[root] == 0xffffffffU) {
      number[root] = static_cast<std::uint32_t>(result.size());
      result.emplace_back();
    }
    result[number[root]].push_back(FaceId(t));
  }
  return result;
}

double volume_of(const SurfaceMesh& mesh, std::span<const Triangle> triangles) {
  SurfaceMesh part;
  for (const Triangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(part.points.size());
    for (const VertexId v : t) part.points.push_back(mesh.points[v.index()]);
    part.triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  }
  return enclosed_volume(part);
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

// Does the one volume a shell encloses have its exact sign?
bool keeps_sense(const MergedMesh& merged, std::span<const FaceId> shell, const ExactShell& exact) {
  std::vector<Triangle> triangles;
  for (const FaceId f : shell) triangles.push_back(merged.mesh.triangles[f.index()]);
  const double volume = volume_of(merged.mesh, triangles);
  return exact.is_outward() ? volume > 0 : volume < 0;
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
    const double volume = volume_of(merged.mesh, space.second);
    return space.first == surrounding ? volume < 0 : volume > 0;
  });
}

}  // namespace

std::vector<FaceId> find_turned_shells(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged,
                                       const std::vector<std::uint8_t>& is_moved) {
  const bool has_walls = !merged.provenance.covering_front.empty();
  std::vector<FaceId> turned;
  ExactSurface surface(faces, facets, merged);
  for (const std::vector<FaceId>& shell : moved_shells(merged.mesh, is_moved)) {
    const std::vector<KeptFacet> kept = surface.facets_of(shell);
    const ExactShell exact(faces, facets, kept);
    if (!(has_walls ? keeps_senses(merged, shell, exact) : keeps_sense(merged, shell, exact))) turned.push_back(shell.front());
  }
  return turned;
}

}  // namespace mortise
