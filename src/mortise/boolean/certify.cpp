// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Tests the triangles that rounding moved.
#include "mortise/boolean/certify.h"

#include <algorithm>
#include <cmath>

#include "mortise/exact/predicates.h"
#include "mortise/mesh/find_self_crossings.h"

namespace mortise {
namespace {

struct ResultEdge {
  std::uint64_t key;
  FaceId triangle;

  bool operator<(const ResultEdge& other) const { return key != other.key ? key < other.key : triangle < other.triangle; }
};

class Certifier {
 public:
  Certifier(const OperandFaces& faces, const Facets& facets, std::span<const KeptFacet> kept, const MergedMesh& merged)
      : faces_(faces), facets_(facets), kept_(kept), merged_(merged), mesh_(merged.mesh) {}

  [[nodiscard]] Certificate run(const ProgressCallback& progress) {
    find_moved();
    if (moved_count_ == 0) return certificate_;
    test_pairs(progress);
    test_order_round_edges();
    auto& failed = certificate_.failed_faces;
    std::sort(failed.begin(), failed.end());
    failed.erase(std::unique(failed.begin(), failed.end()), failed.end());
    if (!failed.empty()) certificate_.status = CertificateStatus::Uncertified;
    return certificate_;
  }

 private:
  void find_moved() {
    std::vector<std::uint8_t> is_moved_vertex(mesh_.points.size(), 0);
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      if (faces_.points.is_representable(merged_.point_of_vertex[v])) continue;
      is_moved_vertex[v] = 1;
      const Vec3d& p = mesh_.points[v];
      constexpr double half_ulp = 0x1p-53;
      const Vec3d bound{half_ulp * p.x, half_ulp * p.y, half_ulp * p.z};
      certificate_.largest_displacement = std::fmax(certificate_.largest_displacement, std::sqrt(dot(bound, bound)));
    }
    is_moved_.assign(mesh_.triangles.size(), 0);
    touches_moved_.assign(mesh_.points.size(), 0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (const VertexId v : mesh_.triangles[t]) is_moved_[t] |= is_moved_vertex[v.index()];
      if (is_moved_[t] == 0) continue;
      ++moved_count_;
      for (const VertexId v : mesh_.triangles[t]) touches_moved_[v.index()] = 1;
    }
    certificate_.triangles_tested = moved_count_;
  }

  [[nodiscard]] Box3 box_of(std::size_t t) const {
    Box3 box;
    for (const VertexId v : mesh_.triangles[t]) box.extend(mesh_.points[v.index()]);
    return box;
  }

  void fail(std::size_t a, std::size_t b) {
    certificate_.failed_faces.push_back(static_cast<std::uint32_t>(a));
    certificate_.failed_faces.push_back(static_cast<std::uint32_t>(b));
  }

  void test_pairs(const ProgressCallback& progress) {
    std::vector<Box3> boxes;
    boxes.reserve(mesh_.triangles.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) boxes.push_back(box_of(t));
    const BoxTree tree(boxes);
    constexpr std::size_t triangles_per_report = 4096;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (t % triangles_per_report == 0) {
        report_progress(progress, "certify", 0.85 + 0.15 * static_cast<double>(t) / static_cast<double>(mesh_.triangles.size()));
      }
      if (is_moved_[t] == 0) continue;
      if (is_degenerate(mesh_, FaceId(t))) fail(t, t);
      tree.for_each_meeting(boxes[t], [&](std::uint32_t other) {
        if (other == t || (is_moved_[other] != 0 && other < t)) return;
        ++certificate_.pairs_tested;
        if (triangles_meet_beyond_shared(mesh_, FaceId(t), FaceId(other))) fail(t, other);
      });
    }
  }

  // Edges of the result with more than two triangles, one of which moved.
  void test_order_round_edges() {
    std::vector<ResultEdge> edges;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId u = mesh_.triangles[t][i];
        const VertexId v = mesh_.triangles[t][(i + 1) % 3];
        if (touches_moved_[u.index()] == 0 || touches_moved_[v.index()] == 0) continue;
        edges.push_back({(std::uint64_t{std::min(u, v).value} << 32U) | std::max(u, v).value, FaceId(t)});
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
    std::vector<FacetAtEdge> exact;
    for (const ResultEdge& e : group) {
      exact.push_back(facet_at_edge(faces_, facets_, kept_[e.triangle.index()].facet, merged_.point_of_vertex[u.index()],
                                    merged_.point_of_vertex[v.index()]));
    }
    sort_round_edge(faces_, exact);
    if (!is_rounded_order(u, v, exact)) fail(group[0].triangle.index(), group[1].triangle.index());
  }

  // The third corner of a kept facet at an edge.
  [[nodiscard]] const Vec3d& apex(VertexId u, VertexId v, FacetId facet) const {
    const auto at = std::lower_bound(kept_.begin(), kept_.end(), facet, [](const KeptFacet& k, FacetId f) { return k.facet < f; });
    const Triangle& t = mesh_.triangles[static_cast<std::size_t>(at - kept_.begin())];
    const VertexId w = t[0] != u && t[0] != v ? t[0] : t[1] != u && t[1] != v ? t[1] : t[2];
    return mesh_.points[w.index()];
  }

  // Are the doubles of facets round an edge in the order given?
  [[nodiscard]] bool is_rounded_order(VertexId u, VertexId v, std::span<const FacetAtEdge> order) const {
    const Vec3d& p = mesh_.points[u.index()];
    const Vec3d& q = mesh_.points[v.index()];
    const Vec3d& reference = apex(u, v, order[0].facet);
    for (std::size_t i = 1; i + 1 < order.size(); ++i) {
      const Vec3d& a = apex(u, v, order[i].facet);
      const Vec3d& b = apex(u, v, order[i + 1].facet);
      const Sign to_a = orient3d(p, q, reference, a);
      const Sign to_b = orient3d(p, q, reference, b);
      if (to_a < to_b) return false;
      if (to_a == to_b && orient3d(p, q, a, b) != Sign::Positive) return false;
    }
    return true;
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  std::span<const KeptFacet> kept_;
  const MergedMesh& merged_;
  const SurfaceMesh& mesh_;
  std::vector<std::uint8_t> is_moved_;
  std::vector<std::uint8_t> touches_moved_;
  std::uint64_t moved_count_ = 0;
  Certificate certificate_;
};

}  // namespace

Certificate certify(const OperandFaces& faces, const Facets& facets, std::span<const KeptFacet> kept, const MergedMesh& merged,
                    const ProgressCallback& progress) {
  return Certifier(faces, facets, kept, merged).run(progress);
}

}  // namespace mortise
