// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/size/small_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mortise/base/error.h"
#include "mortise/brep/face_features.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/topology.h"

namespace mortise {
namespace {

constexpr double small = 0.7;                         // of the size
constexpr double pieces_of_closed = 3;                // no closed model edge has fewer mesh edges
constexpr double farthest_way = 16;                   // in sizes: wedges of 5 degrees and more are closed by then
constexpr double edge_over_gap = 1.1547005383792515;  // 2 / sqrt(3): of equilateral triangles in one row
constexpr double way_over_gap = 2;                    // where two lines meet at 60 degrees, the way along them is twice the gap
constexpr double looks_per_size = 2;
constexpr double no_gap = std::numeric_limits<double>::infinity();
constexpr double most_looks = 1e6;  // at one piece

class Finder {
 public:
  Finder(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SizingProxy& sizes, const SmallFeatureRules& rules)
      : mesh_(mesh), topology_(build_topology(mesh)), model_(model), sizes_(sizes), rules_(rules) {}

  [[nodiscard]] SmallFeatures run() {
    for (std::size_t e = 0; e < model_.brep.edges.size(); ++e) look_at_edge(ModelEdgeId(e));
    const std::vector<std::vector<ModelEdgeId>> edges = edges_of_faces(model_);
    for (std::size_t f = 0; f < edges.size(); ++f) look_round_face(ModelFaceId(f), FaceFeatures(mesh_, model_, edges[f]));
    return std::move(found_);
  }

 private:
  [[nodiscard]] const Vec3d& at(VertexId v) const { return mesh_.points[v.index()]; }

  void look_at_edge(ModelEdgeId e) {
    const ModelEdge& edge = model_.brep.edges[e];
    if (edge.is_seam) return;
    const std::span<const VertexId> path = model_.classification.path.of(e);
    double whole = 0, metric = 0;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      const double step = length(at(path[k + 1]) - at(path[k]));
      whole += step;
      metric += step / sizes_.size_at(0.5 * (at(path[k]) + at(path[k + 1])));
    }
    const double pieces = edge.start == edge.end ? pieces_of_closed : 1;
    if (metric >= small * pieces || whole / pieces < rules_.least || !(whole > 0)) return;
    ++found_.short_edges;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) ask(at(path[k]), at(path[k + 1]), whole / pieces);
  }

  void look_round_face(ModelFaceId face, FaceFeatures features) {
    for (std::uint32_t i = 0; i < features.pieces().size(); ++i) {
      const auto& [a, b] = features.pieces()[i];
      find_inwards(face, a, b);
      const double size = sizes_.size_at(0.5 * (at(a) + at(b)));
      const double looks = std::min(std::floor(looks_per_size * length(at(b) - at(a)) / size) + 1, most_looks);
      double gap = least_gap_at(features.on_piece(i, 0), features);
      for (double k = 0; k < looks; ++k) {
        const double next_gap = least_gap_at(features.on_piece(i, (k + 1) / looks), features), least = std::min(gap, next_gap);
        gap = next_gap;
        if (least == no_gap) continue;
        ++found_.close_places;
        ask(features.on_piece(i, k / looks).at, features.on_piece(i, (k + 1) / looks).at, edge_over_gap * least);
      }
    }
  }

  // Which ways lead from an edge into the face.
  void find_inwards(ModelFaceId face, VertexId a, VertexId b) {
    inwards_.clear();
    const Vec3d along = at(b) - at(a);
    for (const HalfEdge h : topology_.uses_of(find_edge(topology_, a, b))) {
      if (model_.classification.face_of_triangle[face_of(h).index()] != face) continue;
      const Vec3d to_apex = at(origin_of(mesh_, next_in_face(next_in_face(h)))) - at(a);
      inwards_.push_back(dot(along, along) * to_apex - dot(to_apex, along) * along);
    }
  }

  // The other sides of gaps ask at once.
  double least_gap_at(const FeaturePlace& place, FaceFeatures& features) {
    const double size = sizes_.size_at(place.at);
    double least = no_gap;
    for (const ClosePart& part : features.parts_close_to(place, small * size, farthest_way * size, inwards_)) {
      if (part.way <= way_over_gap * part.gap || part.vertices == 1 || part.gap < rules_.least) continue;
      least = std::min(least, part.gap);
      ask(part.at, part.at, edge_over_gap * part.gap);
    }
    return least;
  }

  void ask(const Vec3d& a, const Vec3d& b, double size) { found_.sources.push_back(segment_source(a, b, size, rules_.growth)); }

  const SurfaceMesh& mesh_;
  MeshTopology topology_;
  const ClassifiedBrep& model_;
  const SizingProxy& sizes_;
  const SmallFeatureRules& rules_;
  std::vector<Vec3d> inwards_;  // from the edge looked at
  SmallFeatures found_;
};

}  // namespace

SmallFeatures find_small_features(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SizingProxy& sizes,
                                  const SmallFeatureRules& rules) {
  if (!(rules.least >= 0 && rules.least <= std::numeric_limits<double>::max())) {
    throw Error(ErrorCode::InvalidArgument, "sizing", "the least feature must be a finite number, not negative");
  }
  return Finder(mesh, model, sizes, rules).run();
}

}  // namespace mortise
