// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Runs the stages; judges facets in rationals, by the definition.
#include "support/arrangement.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "support/exact_points.h"
#include "support/test_scale.h"

namespace mortise::test {
namespace {

using oracle::Rational;
using oracle::RationalPoint;

constexpr std::uint64_t plenty = std::uint64_t{1} << 31;

// A facet in rationals, and its box in doubles.
struct ExactFacet {
  std::array<PointId, 3> corners;
  std::array<RationalPoint, 3> position;
  RationalPoint normal;
  Box3 box;
};

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot_product(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
RationalPoint cross_product(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
RationalPoint normal_of(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return cross_product(minus(b, a), minus(c, a));
}

class FacetJudge {
 public:
  explicit FacetJudge(const Arrangement& arrangement) : arrangement_(arrangement), points_(exact_points(arrangement)) {
    const Facets& facets = arrangement.facets;
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const PlanePoints& c = facets.corners[FacetId(i)];
      ExactFacet facet{c, {at(c[0]), at(c[1]), at(c[2])}, {}, {}};
      facet.normal = normal_of(facet.position[0], facet.position[1], facet.position[2]);
      for (const PointId p : c) facet.box.extend(arrangement.faces.points.nearest(p));
      facets_.push_back(facet);
    }
  }

  std::string run() {
    for (std::size_t f = 0; f < arrangement_.faces.corners.size(); ++f) {
      if (arrangement_.faces.shape[SourceId(f)] == FaceShape::Proper) check_tiling(SourceId(f));
    }
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      for (std::size_t j = 0; j < facets_.size(); ++j) {
        if (i != j && boxes_meet(facets_[i].box, facets_[j].box)) check_pair(i, j);
      }
    }
    return faults_;
  }

 private:
  [[nodiscard]] const RationalPoint& at(PointId p) const { return points_[p.index()]; }

  void fault(const std::string& what, std::size_t place) {
    if (++count_ <= 8) faults_ += what + " " + std::to_string(place) + "\n";
  }

  // Every facet of the face lies in its plane and runs as said; areas add up; none sticks out.
  void check_tiling(SourceId f) {
    const PlanePoints& c = arrangement_.faces.corners[f];
    const RationalPoint normal = normal_of(at(c[0]), at(c[1]), at(c[2]));
    Rational sum = 0;
    for (const FacetId facet : arrangement_.facets_of(f)) {
      const ExactFacet& exact = facets_[facet.index()];
      for (const RationalPoint& p : exact.position) {
        if (!dot_product(normal, minus(p, at(c[0]))).is_zero()) fault("facet outside the plane of face", f.index());
        for (std::size_t i = 0; i < 3; ++i) {
          if (dot_product(normal, normal_of(at(c[i]), at(c[(i + 1) % 3]), p)) < 0) fault("facet sticks out of face", f.index());
        }
      }
      const Rational size = dot_product(normal, exact.normal);
      if ((size < 0) != is_opposite(facet, f)) fault("facet runs the wrong way in face", f.index());
      if (size.is_zero()) fault("facet without area in face", f.index());
      sum += abs(size);
    }
    if (sum != dot_product(normal, normal)) fault("facets do not cover face", f.index());
  }

  [[nodiscard]] bool is_opposite(FacetId facet, SourceId f) const {
    for (const FacetSource& s : arrangement_.facets.sources_of(facet)) {
      if (s.face == f) return s.is_opposite;
    }
    throw std::logic_error("a facet without this source");
  }

  static bool is_corner(const ExactFacet& facet, PointId p) {
    return std::find(facet.corners.begin(), facet.corners.end(), p) != facet.corners.end();
  }

  // No corner of i lies in j but as a corner of j; no edge of i passes through j; in one plane nothing of i covers j.
  void check_pair(std::size_t i, std::size_t j) {
    const ExactFacet& a = facets_[i];
    const ExactFacet& b = facets_[j];
    std::array<Rational, 3> height;
    for (std::size_t k = 0; k < 3; ++k) height[k] = dot_product(b.normal, minus(a.position[k], b.position[0]));
    for (std::size_t k = 0; k < 3; ++k) {
      if (height[k].is_zero() && !is_corner(b, a.corners[k]) && contains(b, a.position[k])) fault("corner inside facet", j);
      const std::size_t n = (k + 1) % 3;
      if (height[k].sign() * height[n].sign() < 0) {
        const Rational t = height[k] / (height[k] - height[n]);
        RationalPoint p;
        for (std::size_t x = 0; x < 3; ++x) p[x] = a.position[k][x] + t * (a.position[n][x] - a.position[k][x]);
        if (contains(b, p)) fault("edge through facet", j);
      }
    }
    if (height[0].is_zero() && height[1].is_zero() && height[2].is_zero() && i < j && share_area(a, b)) fault("facet covers facet", j);
  }

  static bool contains(const ExactFacet& facet, const RationalPoint& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (dot_product(facet.normal, normal_of(facet.position[k], facet.position[(k + 1) % 3], p)) < 0) return false;
    }
    return true;
  }

  // Two convex figures of one plane share area unless an edge of one of them has the other on its outer side.
  static bool share_area(const ExactFacet& a, const ExactFacet& b) {
    const auto parts = [](const ExactFacet& host, const ExactFacet& other) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto is_outer = [&](const RationalPoint& p) {
          return dot_product(host.normal, normal_of(host.position[k], host.position[(k + 1) % 3], p)) <= 0;
        };
        if (std::all_of(other.position.begin(), other.position.end(), is_outer)) return true;
      }
      return false;
    };
    return !parts(a, b) && !parts(b, a);
  }

  const Arrangement& arrangement_;
  std::vector<RationalPoint> points_;
  std::vector<ExactFacet> facets_;
  std::size_t count_ = 0;
  std::string faults_;
};

}  // namespace

std::vector<Scene> scenes_for_rationals() {
  std::vector<Scene> scenes;
  const std::vector<Scene> all = small_scenes();
  for (std::size_t i = 0; i < all.size(); i += is_reduced_run() ? 4 : 1) scenes.push_back(all[i]);
  return scenes;
}

OperandFaces gather(const std::vector<SurfaceMesh>& operands, const std::vector<std::size_t>& self) {
  const auto pointers = pointers_to(operands);
  OperandFaces faces = gather_operands(pointers);
  for (const std::size_t k : self) faces.self_contacts[OperandId(k)] = SelfContacts::All;
  return faces;
}

Arrangement::Arrangement(std::vector<SurfaceMesh> meshes, const std::vector<std::size_t>& self)
    : operands(std::move(meshes)),
      faces(gather(operands, self)),
      contacts(find_contacts(faces, plenty, {})),
      overlays(overlay_coplanar(faces, contacts)),
      map(build_face_intersection_map(faces, contacts, overlays)),
      lines(split_segments(faces, overlays, map, {})),
      facets(triangulate_faces(faces, overlays, map, lines, {})) {}

PointId Arrangement::point_at(const Vec3d& position) const {
  for (std::size_t i = 0; i < faces.points.size(); ++i) {
    if (faces.points.nearest(PointId(i)) == position) return PointId(i);
  }
  return PointId();
}

std::vector<FacetId> Arrangement::facets_of(SourceId f) const {
  std::vector<FacetId> found;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (const FacetSource& s : facets.sources_of(FacetId(i))) {
      if (s.face == f) found.push_back(FacetId(i));
    }
  }
  return found;
}

std::vector<RationalPoint> exact_points(const Arrangement& arrangement) {
  const PointSet& points = arrangement.faces.points;
  std::map<std::array<double, 3>, std::vector<RationalPoint>> made;
  if (points.size() > points.input_count()) {
    const auto& self = arrangement.faces.self_contacts;
    const bool has_self = std::any_of(self.begin(), self.end(), [](SelfContacts s) { return s == SelfContacts::All; });
    for (const oracle::MadePoint& p : oracle::made_points(pointers_to(arrangement.operands), has_self)) {
      made[{p.rounded.x, p.rounded.y, p.rounded.z}].push_back(p.position);
    }
  }
  std::vector<RationalPoint> exact;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3d& nearest = points.nearest(PointId(i));
    if (points.is_input(PointId(i))) {
      exact.push_back(oracle::exact(nearest));
      continue;
    }
    const auto& candidates = made[{nearest.x, nearest.y, nearest.z}];
    if (candidates.size() != 1) throw std::logic_error("point " + std::to_string(i) + " is not one of the oracle's");
    exact.push_back(candidates.front());
  }
  return exact;
}

std::string faults_of_facets(const Arrangement& arrangement) { return FacetJudge(arrangement).run(); }

}  // namespace mortise::test
