// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The exact sense of a shell from its extreme point, against the volume of its doubles.
#include "mortise/boolean/moved_shells.h"

#include <algorithm>
#include <span>

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

double volume_of(const SurfaceMesh& mesh, std::span<const FaceId> shell) {
  SurfaceMesh part;
  part.points = mesh.points;
  for (const FaceId t : shell) part.triangles.push_back(mesh.triangles[t.index()]);
  return enclosed_volume(part);
}

// Is the region outside an exact shell in front of its triangles? Read off at its lexicographically smallest point, as seeds are.
class ExactShell {
 public:
  ExactShell(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged, std::span<const FaceId> shell)
      : faces_(faces), facets_(facets), merged_(merged), shell_(shell) {}

  [[nodiscard]] bool is_outward() const {
    const PointId v = smallest_point();
    const PointId p = lowest_neighbour(v);
    std::vector<FacetAtEdge> around;
    for (const FaceId t : shell_) {
      if (has(corners(t), v) && has(corners(t), p)) around.push_back(facet_at_edge(faces_, facets_, kept(t).facet, v, p));
    }
    const FacetAtEdge first = first_after_minus_y(faces_, around);
    const auto at = std::find_if(shell_.begin(), shell_.end(), [&](FaceId t) { return kept(t).facet == first.facet; });
    return first.is_front_after() == kept(*at).is_flipped;
  }

 private:
  [[nodiscard]] const KeptFacet& kept(FaceId t) const { return merged_.facet_of_triangle[t.index()]; }
  [[nodiscard]] const PlanePoints& corners(FaceId t) const { return facets_.corners[kept(t).facet]; }
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
    for (const FaceId t : shell_) {
      for (const PointId p : corners(t)) {
        if (p != smallest && is_smaller(p, smallest)) smallest = p;
      }
    }
    return smallest;
  }

  [[nodiscard]] PointId lowest_neighbour(PointId v) const {
    const PointSet& points = faces_.points;
    PointId lowest;
    for (const FaceId t : shell_) {
      if (!has(corners(t), v)) continue;
      for (const PointId w : corners(t)) {
        if (w == v || (points.compare(w, v, 0) == Sign::Zero && points.compare(w, v, 1) == Sign::Zero)) continue;
        if (!lowest.is_valid() || points.orient2d(v, lowest, w, Axis::Z) == Sign::Negative) lowest = w;
      }
    }
    return lowest;
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  const MergedMesh& merged_;
  std::span<const FaceId> shell_;
};

}  // namespace

std::vector<FaceId> find_turned_shells(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged,
                                       const std::vector<std::uint8_t>& is_moved) {
  std::vector<FaceId> turned;
  for (const std::vector<FaceId>& shell : moved_shells(merged.mesh, is_moved)) {
    const double volume = volume_of(merged.mesh, shell);
    const bool is_outward = ExactShell(faces, facets, merged, shell).is_outward();
    if (!(is_outward ? volume > 0 : volume < 0)) turned.push_back(shell.front());
  }
  return turned;
}

}  // namespace mortise
