// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Refuses meshes no operation can work on.
#include "mortise/mesh/validate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mortise/base/error.h"

namespace mortise {
namespace {

constexpr const char* stage = "validate";

bool is_finite(const Vec3d& p) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::fabs(p.x) <= largest && std::fabs(p.y) <= largest && std::fabs(p.z) <= largest;
}

/// Throws the error with the places where `is_bad`, if there are any.
template <class IsBad>
void refuse(std::size_t count, IsBad is_bad, IdKind kind, Error error) {
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_bad(i)) places.push_back(static_cast<std::uint32_t>(i));
  }
  if (!places.empty()) throw std::move(error).with_ids(kind, std::move(places));
}

void validate_channel(const DataChannel& channel, std::size_t places, std::string_view place_name) {
  const auto fail = [&](const std::string& what) -> void {
    throw Error(ErrorCode::InvalidArgument, stage, "channel '" + channel.name + "' " + what);
  };
  if (channel.name.empty()) throw Error(ErrorCode::InvalidArgument, stage, "a data channel has no name");
  if (channel.components == 0) fail("has no components");
  if (channel.kind != DataKind::Value && channel.components != 3) fail("holds vectors or normals: they have 3 components");
  if (channel.values.size() / channel.components != places || channel.values.size() % channel.components != 0) {
    fail("has " + std::to_string(channel.values.size()) + " values for " + std::to_string(places) + " " + std::string(place_name) + " of " +
         std::to_string(channel.components) + " components");
  }
  constexpr double largest = std::numeric_limits<double>::max();
  if (std::any_of(channel.values.begin(), channel.values.end(), [](double x) { return std::fabs(x) > largest; })) {
    fail("has an infinite value: NaN is the one for none");
  }
}

void validate_data(const SurfaceMesh& mesh) {
  std::vector<std::string_view> names;
  for (const DataChannel& c : mesh.vertex_data) {
    validate_channel(c, mesh.points.size(), "vertices");
    names.push_back(c.name);
  }
  for (const DataChannel& c : mesh.corner_data) {
    validate_channel(c, 3 * mesh.triangles.size(), "corners");
    names.push_back(c.name);
  }
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) {
    throw Error(ErrorCode::InvalidArgument, stage, "two data channels have the name '" + std::string(*twice) + "'");
  }
}

}  // namespace

void validate(const SurfaceMesh& mesh) {
  refuse(
      mesh.points.size(), [&](std::size_t v) { return !is_finite(mesh.points[v]); }, IdKind::Vertices,
      Error(ErrorCode::NotFinite, stage, "a coordinate is not a finite number"));
  const auto has_bad_index = [&](std::size_t f) {
    return std::any_of(mesh.triangles[f].begin(), mesh.triangles[f].end(), [&](VertexId v) { return v.index() >= mesh.points.size(); });
  };
  refuse(
      mesh.triangles.size(), has_bad_index, IdKind::Faces,
      Error(ErrorCode::BadIndex, stage, "a triangle names a vertex that does not exist: there are " + std::to_string(mesh.points.size())));
  if (!mesh.walls.empty() && mesh.walls.size() != mesh.triangles.size()) {
    throw Error(
        ErrorCode::InvalidArgument, stage,
        "there are " + std::to_string(mesh.walls.size()) + " marks of walls for " + std::to_string(mesh.triangles.size()) + " triangles");
  }
  if (!mesh.diagonals.empty() && mesh.diagonals.size() != mesh.triangles.size()) {
    throw Error(ErrorCode::InvalidArgument, stage,
                "there are " + std::to_string(mesh.diagonals.size()) + " marks of diagonals for " + std::to_string(mesh.triangles.size()) +
                    " triangles");
  }
  refuse(
      mesh.diagonals.size(), [&](std::size_t f) { return mesh.diagonals[f] > 7; }, IdKind::Faces,
      Error(ErrorCode::InvalidArgument, stage, "a triangle has three edges: marks of diagonals are below 8"));
  validate_data(mesh);
  if (mesh.face_labels.empty()) return;
  if (mesh.face_labels.size() != mesh.triangles.size()) {
    throw Error(ErrorCode::InvalidArgument, stage,
                "there are " + std::to_string(mesh.face_labels.size()) + " face labels for " + std::to_string(mesh.triangles.size()) +
                    " triangles");
  }
  refuse(
      mesh.face_labels.size(), [&](std::size_t f) { return mesh.face_labels[f] >= mesh.label_names.size(); }, IdKind::Faces,
      Error(ErrorCode::InvalidArgument, stage, "a face label has no name"));
}

}  // namespace mortise
