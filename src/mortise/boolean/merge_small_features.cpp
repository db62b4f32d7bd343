// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/boolean/merge_small_features.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "mortise/base/error.h"
#include "mortise/base/sort_unique.h"
#include "mortise/boolean/share_within_tolerance.h"
#include "mortise/mesh/select_faces.h"

namespace mortise {
namespace {

/// A triangle by its corners, and what is on either side of it.
struct Layer {
  Triangle corners;  // ascending
  FaceId triangle;
  ModelRegionId front, behind;  // seen from where the corners are counterclockwise in that order

  [[nodiscard]] bool is_sheet() const { return front == behind; }
};

// Do the corners of a triangle run as they do in ascending order?
bool is_even(const Triangle& t) { return (t[0] < t[1]) != ((t[1] < t[2]) != (t[0] < t[2])); }

std::vector<Layer> layers_of(const ImprintedOperand& shared, const ClassifiedBrep& model) {
  std::vector<Layer> layers;
  for (std::size_t t = 0; t < shared.mesh.triangles.size(); ++t) {
    const Triangle& corners = shared.mesh.triangles[t];
    const ModelFace& face = model.brep.faces[model.classification.face_of_triangle[shared.source_face[t]]];
    Layer layer{corners, FaceId(t), face.region_in_front, face.region_behind};
    std::sort(layer.corners.begin(), layer.corners.end());
    if (!is_even(corners)) std::swap(layer.front, layer.behind);
    layers.push_back(layer);
  }
  std::stable_sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.corners < b.corners; });
  return layers;
}

// Two walls of which one has behind it what the other has in front become one, or none.
bool join_two(std::vector<Layer>& walls) {
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t j = 0; j < walls.size(); ++j) {
      if (i == j || walls[i].behind != walls[j].front) continue;
      walls[i].behind = walls[j].behind;
      const bool is_nothing = walls[i].is_sheet();
      walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(j));
      if (is_nothing) walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(i < j ? i : i - 1));
      return true;
    }
  }
  return false;
}

// What is left of triangles on each other. More than one: they bound what overlaps.
std::vector<Layer> joined(std::vector<Layer> layers) {
  if (layers.size() == 1) return layers;
  const auto walls_end = std::stable_partition(layers.begin(), layers.end(), [](const Layer& layer) { return !layer.is_sheet(); });
  std::vector<Layer> walls(layers.begin(), walls_end);
  while (join_two(walls)) {
  }
  if (walls.empty() && walls_end != layers.end()) walls.push_back(*walls_end);
  return walls;
}

/// Triangles of the shared mesh that stay, ascending, and those that lie on others.
struct Kept {
  std::vector<FaceId> triangles, overlapping;
};

Kept keep_layers(const std::vector<Layer>& layers) {
  Kept kept;
  for (std::size_t i = 0, end = 0; i < layers.size(); i = end) {
    while (end < layers.size() && layers[end].corners == layers[i].corners) ++end;
    const std::vector<Layer> left =
        joined(std::vector<Layer>(layers.begin() + static_cast<std::ptrdiff_t>(i), layers.begin() + static_cast<std::ptrdiff_t>(end)));
    for (const Layer& layer : left) {
      kept.triangles.push_back(layer.triangle);
      if (left.size() > 1) kept.overlapping.push_back(layer.triangle);
    }
  }
  std::sort(kept.triangles.begin(), kept.triangles.end());
  return kept;
}

std::vector<FaceId> missing_among(const std::vector<FaceId>& sources, std::size_t count) {
  std::vector<std::uint8_t> is_there(count, 0);
  for (const FaceId t : sources) is_there[t.index()] = 1;
  std::vector<FaceId> missing;
  for (std::size_t t = 0; t < count; ++t) {
    if (is_there[t] == 0) missing.emplace_back(t);
  }
  return missing;
}

}  // namespace

MergedFeatures merge_small_features(const SurfaceMesh& mesh, const ClassifiedBrep& model, double least, const ProgressCallback& progress) {
  if (!(least > 0 && least <= std::numeric_limits<double>::max()))
    throw Error(ErrorCode::InvalidArgument, "merge_small_features", "the least feature must be a positive length");
  const SharedOperands all = share_within_tolerance(std::array{&mesh}, least, progress);
  const ImprintedOperand& shared = all.operands.front();
  const Kept kept = keep_layers(layers_of(shared, model));
  MergedFeatures merged;
  merged.mesh = select_faces(shared.mesh, kept.triangles).mesh;
  merged.mesh.diagonals.clear();
  const auto source_of = [&](FaceId t) { return FaceId(shared.source_face[t.index()]); };
  for (const FaceId t : kept.triangles) merged.sources.push_back(source_of(t));
  merged.gone = missing_among(merged.sources, mesh.triangles.size());
  for (const OperandFace& face : all.report.unresolved) merged.unresolved.emplace_back(face.face);
  for (const FaceId t : kept.overlapping) merged.unresolved.push_back(source_of(t));
  sort_unique(merged.unresolved);
  merged.moved_vertices = all.report.moved_vertices;
  merged.largest_move = all.report.largest_move;
  return merged;
}

}  // namespace mortise
