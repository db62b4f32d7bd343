// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/size/curvature_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "mortise/base/error.h"
#include "mortise/geom/length.h"
#include "mortise/size/face_curvature.h"

namespace mortise {
namespace {

constexpr double straight = 1e-4;  // angle in a path that is no turn
constexpr double infinite = std::numeric_limits<double>::infinity();

void check_rules(const CurvatureRules& rules) {
  const auto is_positive = [](double x) { return x > 0 && x < infinite; };
  const bool is_fine = (rules.chord_error || rules.segments_per_turn) && is_positive(rules.chord_error.value_or(1)) &&
                       is_positive(rules.segments_per_turn.value_or(1)) && rules.smallest >= 0 && rules.smallest < infinite &&
                       rules.largest > 0;
  if (!is_fine)
    throw Error(ErrorCode::InvalidArgument, "sizing",
                "curvature takes a positive chord error or number of segments per turn, and sizes that are not negative");
}

// Half the chord of a circle squared, where its arc is `sagitta` high.
double half_chord_square(double radius, double sagitta) {
  const double height = std::min(radius, sagitta);
  return height * (2 * radius - height);
}

double size_for(double radius, double by_chord_error, const CurvatureRules& rules) {
  const double by_turn = rules.segments_per_turn ? 2 * std::numbers::pi * radius / *rules.segments_per_turn : infinite;
  return std::max(rules.smallest, std::min(by_chord_error, by_turn));
}

double circle_radius(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double ab = length(b - a), bc = length(c - b), ca = length(a - c), twice_area = length(cross(b - a, c - b));
  return twice_area > 0 ? ab * (bc / (2 * twice_area)) * ca : infinite;
}

// Adds only what asks for something.
class CurvatureSources {
 public:
  CurvatureSources(const ModelView& view, const CurvatureRules& rules) : view_(view), rules_(rules) {
    Box3 box;
    for (const Vec3d& p : view.mesh.points) box.extend(p);
    largest_ = box.is_empty() ? 0 : std::min(rules.largest, length(box.hi - box.lo));
  }

  void add_faces(const std::vector<double>& curvatures) {
    for (std::size_t t = 0; t < curvatures.size(); ++t) {
      const Triangle& v = view_.mesh.triangles[t];
      const double size = curvatures[t] > 0 ? triangle_size_for(1 / curvatures[t], rules_) : infinite;
      if (is_wanted(size)) sources_.push_back(triangle_source(point(v[0]), point(v[1]), point(v[2]), size, rules_.growth));
    }
  }

  // Straight pieces count as one, however many mesh edges they are.
  void add_edge(ModelEdgeId e) {
    const auto path = view_.model.classification.path.of(e);
    const std::vector<std::size_t> ends = find_turns(path);
    const auto radius_at = [&](std::size_t i) {
      return i > 0 && i + 1 < ends.size() ? circle_radius(point(path[ends[i - 1]]), point(path[ends[i]]), point(path[ends[i + 1]]))
                                          : infinite;
    };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double size = segment_size_for(std::min(radius_at(i), radius_at(i + 1)), rules_);
      for (std::size_t k = ends[i]; is_wanted(size) && k < ends[i + 1]; ++k)
        sources_.push_back(segment_source(point(path[k]), point(path[k + 1]), size, rules_.growth));
    }
  }

  [[nodiscard]] std::vector<SizeSource> take() { return std::move(sources_); }

 private:
  [[nodiscard]] bool is_wanted(double size) const { return size > 0 && size < largest_; }
  [[nodiscard]] Vec3d point(VertexId v) const { return view_.mesh.points[v.index()]; }

  // Places in a path where it turns, and its ends.
  [[nodiscard]] std::vector<std::size_t> find_turns(std::span<const VertexId> path) const {
    std::vector<std::size_t> turns{0};
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const Vec3d before = point(path[i]) - point(path[turns.back()]), after = point(path[i + 1]) - point(path[i]);
      const bool goes_on = length(cross(before, after)) <= straight * length(before) * length(after) && dot(before, after) >= 0;
      if (!goes_on) turns.push_back(i);
    }
    turns.push_back(path.size() - 1);
    return turns;
  }

  const ModelView& view_;
  const CurvatureRules& rules_;
  double largest_ = 0;
  std::vector<SizeSource> sources_;
};

}  // namespace

double triangle_size_for(double radius, const CurvatureRules& rules) {
  return size_for(radius, rules.chord_error ? std::sqrt(3 * half_chord_square(radius, *rules.chord_error)) : infinite, rules);
}

double segment_size_for(double radius, const CurvatureRules& rules) {
  return size_for(radius, rules.chord_error ? 2 * std::sqrt(half_chord_square(radius, *rules.chord_error)) : infinite, rules);
}

std::vector<SizeSource> sources_of_curvature(const ModelView& view, const CurvatureRules& rules, const FaceNormals& normals) {
  check_rules(rules);
  CurvatureSources sources(view, rules);
  sources.add_faces(measure_curvatures(view, normals));
  for (std::uint32_t e = 0; e < view.model.brep.edges.size(); ++e) {
    if (!view.model.brep.edges[ModelEdgeId(e)].is_seam) sources.add_edge(ModelEdgeId(e));
  }
  return sources.take();
}

}  // namespace mortise
