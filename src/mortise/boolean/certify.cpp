// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Tests the triangles that rounding moved.
#include "mortise/boolean/certify.h"

#include <algorithm>

#include "mortise/boolean/moved_shells.h"
#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/order_round_edge.h"

namespace mortise {
namespace {

struct ResultEdge {
  std::uint64_t key;
  HalfEdge half_edge;

  bool operator<(const ResultEdge& other) const { return key != other.key ? key < other.key : half_edge < other.half_edge; }
};

// The same for both orders of two numbers.
std::uint64_t unordered_key(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b); }

class Certifier {
 public:
  Certifier(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged)
      : faces_(faces), facets_(facets), merged_(merged), mesh_(merged.mesh) {}

  [[nodiscard]] CertifiedMesh run(const ProgressCallback& progress) {
    find_moved();
    if (result_.certificate.triangles_tested == 0) return result_;
    test_pairs(progress);
    test_order_round_edges();
    const double displacement = result_.certificate.largest_displacement;
    for (const FaceId t : find_turned_shells(faces_, facets_, merged_, is_moved_vertex_, displacement)) fail(t, t);
    auto& failed = result_.certificate.failed_faces;
    std::sort(failed.begin(), failed.end());
    failed.erase(std::unique(failed.begin(), failed.end()), failed.end());
    if (!failed.empty()) result_.certificate.status = CertificateStatus::Uncertified;
    return std::move(result_);
  }

 private:
  [[nodiscard]] const Triangle& triangle(FaceId t) const { return mesh_.triangles[t.index()]; }
  [[nodiscard]] const Vec3d& position(VertexId v) const { return mesh_.points[v.index()]; }
  [[nodiscard]] PointId point_of(VertexId v) const { return merged_.point_of_vertex[v.index()]; }
  [[nodiscard]] const PlanePoints& exact_corners(FaceId t) const { return facets_.corners[merged_.facet_of_triangle[t.index()].facet]; }

  // From the exact point to its nearest doubles, and from these to the vertex.
  void note_rounding(const Vec3d& nearest, const Vec3d& vertex) {
    constexpr double half_ulp = 0x1p-53;
    const Vec3d bound{half_ulp * nearest.x, half_ulp * nearest.y, half_ulp * nearest.z};
    largest_rounding_ = std::max(largest_rounding_, length(bound) + length(vertex - nearest));
  }

  void find_moved() {
    is_moved_ = merged_.is_repaired;
    is_moved_vertex_.assign(mesh_.points.size(), 0);
    touches_moved_.assign(mesh_.points.size(), 0);
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      const PointId exact = point_of(VertexId(v));
      const Vec3d& nearest = faces_.points.nearest(exact);
      if (faces_.points.is_representable(exact) && mesh_.points[v] == nearest) continue;
      is_moved_vertex_[v] = 1;
      note_rounding(nearest, mesh_.points[v]);
    }
    result_.certificate.largest_displacement = std::max(largest_rounding_, merged_.rounding_displacement) + merged_.repair_displacement;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (const VertexId v : mesh_.triangles[t]) is_moved_[t] |= is_moved_vertex_[v.index()];
      if (is_moved_[t] == 0) continue;
      ++result_.certificate.triangles_tested;
      for (const VertexId v : mesh_.triangles[t]) touches_moved_[v.index()] = 1;
    }
  }

  [[nodiscard]] Box3 box_of(const Triangle& t) const {
    Box3 box;
    for (const VertexId v : t) box.extend(position(v));
    return box;
  }

  void fail(FaceId a, FaceId b) {
    result_.failed.push_back({a, b});
    result_.certificate.failed_faces.push_back(a.value);
    result_.certificate.failed_faces.push_back(b.value);
  }

  [[nodiscard]] std::span<const FacetSource> sources(FaceId t) const {
    return facets_.sources_of(merged_.facet_of_triangle[t.index()].facet);
  }

  // Did faces these triangles come from cross in their operand already?
  [[nodiscard]] bool is_inherited(FaceId a, FaceId b) const {
    const auto crossed_before = [&](SourceId f, SourceId g) {
      const OperandId k = faces_.operand[f];
      return f != g && k == faces_.operand[g] && faces_.self_contacts[k] != SelfContacts::All && meet_beyond_shared(faces_, f, g);
    };
    for (const FacetSource& f : sources(a)) {
      for (const FacetSource& g : sources(b)) {
        if (crossed_before(f.face, g.face)) return true;
      }
    }
    return false;
  }

  // A tree of the few moved triangles, asked by all.
  void test_pairs(const ProgressCallback& progress) {
    std::vector<FaceId> moved;
    std::vector<Box3> boxes;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (is_moved_[t] == 0) continue;
      moved.push_back(FaceId(t));
      boxes.push_back(box_of(mesh_.triangles[t]));
      if (is_degenerate(mesh_, FaceId(t))) fail(FaceId(t), FaceId(t));
    }
    const BoxTree tree(boxes);
    constexpr std::size_t triangles_per_report = 4096;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (i % triangles_per_report == 0) {
        report_progress(progress, "certify", 0.85 + 0.1 * static_cast<double>(i) / static_cast<double>(mesh_.triangles.size()));
      }
      const FaceId t(i);
      tree.for_each_meeting(box_of(triangle(t)), [&](std::uint32_t item) {
        const FaceId other = moved[item];
        if (other == t || (is_moved_[i] != 0 && other < t)) return;
        ++result_.certificate.pairs_tested;
        if (!triangles_meet_beyond_shared(mesh_, t, other)) return;
        meeting_.push_back(unordered_key(t.value, other.value));
        if (is_inherited(t, other)) {
          ++result_.certificate.inherited_pairs;
        } else {
          fail(t, other);
        }
      });
    }
  }

  // Edges of the result with more than two triangles, one of which moved.
  void test_order_round_edges() {
    std::sort(meeting_.begin(), meeting_.end());
    std::vector<ResultEdge> edges;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId u = mesh_.triangles[t][i];
        const VertexId v = mesh_.triangles[t][(i + 1) % 3];
        if (touches_moved_[u.index()] == 0 || touches_moved_[v.index()] == 0) continue;
        edges.push_back({unordered_key(u.value, v.value), HalfEdge(3 * t + i)});
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();) {
      std::size_t end = i;
      while (end < edges.size() && edges[end].key == edges[i].key) ++end;
      if (end - i > 2) test_order(std::span(edges).subspan(i, end - i));
      i = end;
    }
  }

  void test_order(std::span<const ResultEdge> group) {
    const VertexId u(static_cast<std::uint32_t>(group[0].key >> 32U));
    const VertexId v(static_cast<std::uint32_t>(group[0].key));
    std::vector<HalfEdge> around;
    for (const ResultEdge& e : group) around.push_back(e.half_edge);
    if (any_meet(around)) return;  // there may be no order
    sort_round_edge(mesh_, {u, v}, around);
    if (have_exact_order(u, v, around) ? is_exact_order(u, v, around) : spaces_follow(u, around)) return;
    // Which of them are to blame is not known; naming some by their numbers would make repair depend on these.
    for_each_pair(around, [&](FaceId s, FaceId t) { fail(s, t); });
  }

  template <class Visit>
  static void for_each_pair(std::span<const HalfEdge> around, Visit visit) {
    for (std::size_t i = 0; i < around.size(); ++i) {
      for (std::size_t j = i + 1; j < around.size(); ++j) visit(face_of(around[i]), face_of(around[j]));
    }
  }

  // Do two of them meet in more than the edge?
  [[nodiscard]] bool any_meet(std::span<const HalfEdge> around) const {
    bool any = false;
    for_each_pair(around, [&](FaceId s, FaceId t) {
      any = any || std::binary_search(meeting_.begin(), meeting_.end(), unordered_key(s.value, t.value));
    });
    return any;
  }

  [[nodiscard]] bool has_exact_edge(FaceId t, VertexId u, VertexId v) const {
    const PlanePoints& c = exact_corners(t);
    return std::find(c.begin(), c.end(), point_of(u)) != c.end() && std::find(c.begin(), c.end(), point_of(v)) != c.end();
  }

  // Not where a repair made two of one facet.
  [[nodiscard]] bool have_exact_order(VertexId u, VertexId v, std::span<const HalfEdge> around) const {
    std::vector<FacetId> of;
    for (const HalfEdge h : around) {
      if (!has_exact_edge(face_of(h), u, v)) return false;
      of.push_back(merged_.facet_of_triangle[face_of(h).index()].facet);
    }
    std::sort(of.begin(), of.end());
    return std::adjacent_find(of.begin(), of.end()) == of.end();
  }

  [[nodiscard]] bool is_exact_order(VertexId u, VertexId v, std::span<const HalfEdge> around) const {
    std::vector<FacetAtEdge> exact;
    for (const HalfEdge h : around) {
      exact.push_back(facet_at_edge(faces_, facets_, merged_.facet_of_triangle[face_of(h).index()].facet, point_of(u), point_of(v)));
    }
    const std::vector<FacetAtEdge> rounded = exact;
    sort_round_edge(faces_, exact);
    return std::equal(exact.begin(), exact.end(), rounded.begin(),
                      [](const FacetAtEdge& a, const FacetAtEdge& b) { return a.facet == b.facet; });
  }

  // Going round, one comes out of a triangle into the space before the next. Where there may be walls, this space is the same
  // seen from both; else one enters and leaves the result in turn.
  [[nodiscard]] bool spaces_follow(VertexId u, std::span<const HalfEdge> around) const {
    const Provenance& p = merged_.provenance;
    const bool has_walls = !p.covering_front.empty();
    const auto is_forward = [&](HalfEdge h) { return origin_of(mesh_, h) == u; };
    const auto agree = [&](HalfEdge one, HalfEdge next) {
      if (!has_walls) return is_forward(one) != is_forward(next);
      const auto& after = is_forward(one) ? p.covering_front : p.covering;
      const auto& before = is_forward(next) ? p.covering : p.covering_front;
      return p.space_of(after[face_of(one).index()]) == p.space_of(before[face_of(next).index()]);
    };
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (!agree(around[i], around[(i + 1) % around.size()])) return false;
    }
    return true;
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  const MergedMesh& merged_;
  const SurfaceMesh& mesh_;
  std::vector<std::uint8_t> is_moved_;
  std::vector<std::uint8_t> is_moved_vertex_;
  std::vector<std::uint8_t> touches_moved_;
  std::vector<std::uint64_t> meeting_;  // tested pairs that meet beyond what they share
  double largest_rounding_ = 0;
  CertifiedMesh result_;
};

}  // namespace

CertifiedMesh certify(const OperandFaces& faces, const Facets& facets, const MergedMesh& merged, const ProgressCallback& progress) {
  return Certifier(faces, facets, merged).run(progress);
}

}  // namespace mortise
