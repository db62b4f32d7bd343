// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Angles against two thresholds, then chains: weak edges that continue a feature stay, short dangling creases go.
#include "mortise/brep/feature_edges.h"

#include <algorithm>
#include <string>

#include "mortise/base/error.h"
#include "mortise/base/trig.h"

namespace mortise {
namespace {

constexpr const char* stage_name = "build_brep";

enum class Mark : std::uint8_t {
  Smooth,
  Weak,    // above the weak angle only
  Crease,  // above the face angle
  Fixed,   // a feature by more than its angle
};

class FeatureFinder {
 public:
  FeatureFinder(const SurfaceMesh& mesh, const MeshTopology& topology, const FaceNormals& normals, const FeatureRules& rules)
      : mesh_(mesh), topology_(topology), normals_(normals), rules_(rules), marks_(topology.edges.size(), Mark::Smooth) {}

  [[nodiscard]] std::vector<std::uint8_t> find() {
    refuse_angles();
    if (!rules_.groups.empty() && rules_.groups.size() != mesh_.triangles.size())
      throw Error(ErrorCode::InvalidArgument, stage_name, "there is not one group per triangle");
    mark_by_triangles();
    mark_user_edges();
    if (rules_.weak_angle_deg) keep_weak_that_continue();
    if (rules_.least_dangling > 0) drop_dangling();
    std::vector<std::uint8_t> is_feature(marks_.size());
    std::transform(marks_.begin(), marks_.end(), is_feature.begin(), [](Mark m) { return m >= Mark::Crease ? 1 : 0; });
    return is_feature;
  }

 private:
  void refuse_angles() const {
    const double weak = rules_.weak_angle_deg.value_or(rules_.face_angle_deg);
    if (!(weak >= 0 && weak <= rules_.face_angle_deg && rules_.face_angle_deg <= 180))
      throw Error(ErrorCode::InvalidArgument, stage_name, "angles lie between 0 and 180 degrees, the weak one below the other");
  }

  void mark_by_triangles() {
    const double crease_cosine = trig::cos_deg(rules_.face_angle_deg);
    const double weak_cosine = trig::cos_deg(rules_.weak_angle_deg.value_or(rules_.face_angle_deg));
    for (std::size_t e = 0; e < marks_.size(); ++e) {
      const auto uses = topology_.uses_of(MeshEdgeId(e));
      if (uses.size() != 2 || parts_faces(uses[0], uses[1])) {
        marks_[e] = Mark::Fixed;
        continue;
      }
      const double cosine = cosine_between(face_of(uses[0]), face_of(uses[1]));
      if (cosine < weak_cosine) marks_[e] = cosine < crease_cosine ? Mark::Crease : Mark::Weak;
    }
  }

  [[nodiscard]] bool parts_faces(HalfEdge h, HalfEdge other) const {
    if (origin_of(mesh_, h) == origin_of(mesh_, other)) return true;
    if (!mesh_.walls.empty() && mesh_.walls[face_of(h).index()] != mesh_.walls[face_of(other).index()]) return true;
    const auto differ = [&](const std::vector<std::uint32_t>& numbers) {
      return !numbers.empty() && numbers[face_of(h).index()] != numbers[face_of(other).index()];
    };
    return differ(rules_.groups) || (rules_.splits_at_labels && differ(mesh_.face_labels));
  }

  // 1 where a triangle has no normal.
  [[nodiscard]] double cosine_between(FaceId f, FaceId g) const {
    if (!normals_.planes.empty() && normals_.planes[f.index()] == normals_.planes[g.index()]) return 1;
    const Vec3d &n = normals_.normals[f.index()], &m = normals_.normals[g.index()];
    const double cosine = dot(n, m);
    return cosine == 0 && (dot(n, n) == 0 || dot(m, m) == 0) ? 1 : cosine;
  }

  void mark_user_edges() {
    for (const std::array<VertexId, 2>& ends : rules_.user_edges) {
      const MeshEdgeId edge = find_edge(topology_, ends[0], ends[1]);
      if (!edge.is_valid()) refuse_user_edge(ends, stage_name);
      marks_[edge.index()] = Mark::Fixed;
    }
  }

  [[nodiscard]] Lists<VertexId, MeshEdgeId> round_vertices(Mark least) const {
    std::vector<std::uint8_t> is_marked(marks_.size());
    std::transform(marks_.begin(), marks_.end(), is_marked.begin(), [least](Mark m) { return m >= least ? 1 : 0; });
    return edges_round_vertices(topology_, is_marked, mesh_.points.size());
  }

  // From creases and fixed edges along weak ones.
  void keep_weak_that_continue() {
    const Lists<VertexId, MeshEdgeId> round = round_vertices(Mark::Weak);
    std::vector<MeshEdgeId> todo;
    for (std::size_t e = 0; e < marks_.size(); ++e) {
      if (marks_[e] >= Mark::Crease) todo.emplace_back(e);
    }
    while (!todo.empty()) {
      const MeshEdgeId e = todo.back();
      todo.pop_back();
      for (const VertexId v : topology_.edges[e.index()]) {
        for (const MeshEdgeId next : round.of(v)) {
          if (marks_[next.index()] != Mark::Weak) continue;
          marks_[next.index()] = Mark::Crease;
          todo.push_back(next);
        }
      }
    }
  }

  // The crease that ends at v, from there to the next vertex with other than two features; empty when it is to stay.
  [[nodiscard]] std::vector<MeshEdgeId> short_crease_from(VertexId v, const Lists<VertexId, MeshEdgeId>& round) const {
    std::vector<MeshEdgeId> crease;
    while (true) {
      const auto here = round.of(v);
      const auto is_next = [&](MeshEdgeId e) { return is_feature(e) && (crease.empty() || e != crease.back()); };
      const auto count = std::count_if(here.begin(), here.end(), is_next);
      if (count != 1) return crease;
      const MeshEdgeId next = *std::find_if(here.begin(), here.end(), is_next);
      if (marks_[next.index()] == Mark::Fixed) return {};
      crease.push_back(next);
      if (crease.size() >= rules_.least_dangling) return {};
      const std::array<VertexId, 2>& ends = topology_.edges[next.index()];
      v = ends[0] == v ? ends[1] : ends[0];
    }
  }

  [[nodiscard]] bool is_feature(MeshEdgeId e) const { return marks_[e.index()] >= Mark::Crease; }

  // Dropping one crease may leave another dangling: that one is looked at again from its new end.
  void drop_dangling() {
    const Lists<VertexId, MeshEdgeId> round = round_vertices(Mark::Crease);
    const auto degree = [&](VertexId v) {
      const auto here = round.of(v);
      return std::count_if(here.begin(), here.end(), [&](MeshEdgeId e) { return is_feature(e); });
    };
    std::vector<VertexId> ends;
    for (std::size_t v = 0; v < round.size(); ++v) {
      if (degree(VertexId(v)) == 1) ends.emplace_back(v);
    }
    while (!ends.empty()) {
      const VertexId v = ends.back();
      ends.pop_back();
      if (degree(v) != 1) continue;
      for (const MeshEdgeId e : short_crease_from(v, round)) {
        marks_[e.index()] = Mark::Smooth;
        for (const VertexId end : topology_.edges[e.index()]) {
          if (degree(end) == 1) ends.push_back(end);
        }
      }
    }
  }

  const SurfaceMesh& mesh_;
  const MeshTopology& topology_;
  const FaceNormals& normals_;
  const FeatureRules& rules_;
  std::vector<Mark> marks_;
};

}  // namespace

std::vector<std::uint8_t> find_feature_edges(const SurfaceMesh& mesh, const MeshTopology& topology, const FaceNormals& normals,
                                             const FeatureRules& rules) {
  return FeatureFinder(mesh, topology, normals, rules).find();
}

void refuse_user_edge(const std::array<VertexId, 2>& ends, std::string_view stage) {
  throw Error(ErrorCode::InvalidArgument, stage,
              "there is no edge from vertex " + std::to_string(ends[0].value) + " to " + std::to_string(ends[1].value));
}

Lists<VertexId, MeshEdgeId> edges_round_vertices(const MeshTopology& topology, const std::vector<std::uint8_t>& is_marked,
                                                 std::size_t vertex_count) {
  std::vector<std::pair<VertexId, MeshEdgeId>> ends;
  for (std::size_t e = 0; e < is_marked.size(); ++e) {
    if (is_marked[e] == 0) continue;
    for (const VertexId v : topology.edges[e]) ends.emplace_back(v, MeshEdgeId(e));
  }
  return lists_of<VertexId, MeshEdgeId>(
      ends, vertex_count, [](const auto& end) { return end.first; }, [](const auto& end) { return end.second; });
}

}  // namespace mortise
