// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Copies values to corners that were there; the others are sorted by face and point, so that each place is found once.
#include "mortise/boolean/transfer_data.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>

#include "mortise/base/error.h"
#include "mortise/exact/point_in_triangle.h"
#include "mortise/mesh/corner_data.h"

namespace mortise {
namespace {

void join(const DataChannel& channel, std::size_t operand, std::vector<DataChannel>& joined) {
  const auto same_name = std::find_if(joined.begin(), joined.end(), [&](const DataChannel& c) { return c.name == channel.name; });
  if (same_name == joined.end()) {
    joined.push_back({channel.name, channel.components, channel.kind, {}});
    return;
  }
  if (same_name->components != channel.components) {
    throw Error(ErrorCode::InvalidArgument, "transfer_data",
                "channel '" + channel.name + "' has " + std::to_string(channel.components) + " components here and " +
                    std::to_string(same_name->components) + " in an operand before")
        .in_operand(operand);
  }
  if (same_name->kind != channel.kind) {
    throw Error(ErrorCode::InvalidArgument, "transfer_data",
                "channel '" + channel.name + "' is of another kind (values, vectors, normals) than in an operand before")
        .in_operand(operand);
  }
}

/// Where an operand has the values of a channel; nowhere by default.
struct ChannelSource {
  const DataChannel* at_vertices = nullptr;
  const DataChannel* at_corners = nullptr;
};

ChannelSource find_channel(const SurfaceMesh& mesh, const std::string& name) {
  ChannelSource source;
  for (const DataChannel& c : mesh.vertex_data) {
    if (c.name == name) source.at_vertices = &c;
  }
  for (const DataChannel& c : mesh.corner_data) {
    if (c.name == name) source.at_corners = &c;
  }
  return source;
}

/// A corner of a triangle that is no corner of its face.
struct MadeCorner {
  SourceId face;
  PointId point;
  std::uint32_t corner;  ///< 3 t + i

  [[nodiscard]] bool is_at_same_place(const MadeCorner& other) const { return face == other.face && point == other.point; }
  bool operator<(const MadeCorner& o) const { return std::tie(face, point, corner) < std::tie(o.face, o.point, o.corner); }
};

class DataTransfer {
 public:
  DataTransfer(const ExactOperands& source, std::vector<DataChannel>& channels) : source_(source), channels_(channels) {
    for (const SurfaceMesh* mesh : source.operands) {
      for (const DataChannel& c : channels) channel_sources_.push_back(find_channel(*mesh, c.name));
    }
  }

  void copy_corners(std::span<const TriangleInFace> triangles) {
    for (DataChannel& c : channels_) c.values.assign(triangles.size() * values_per_face(c), no_value);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const PlanePoints& face_corners = source_.faces.corners[triangles[t].face];
      for (std::uint32_t i = 0; i < 3; ++i) {
        const PointId p = source_.point_of_vertex[triangles[t].corners[i].index()];
        const auto at = static_cast<std::size_t>(std::find(face_corners.begin(), face_corners.end(), p) - face_corners.begin());
        if (at < 3) {
          copy(triangles[t].face, at, 3 * t + i);
        } else {
          made_.push_back({triangles[t].face, p, 3 * t + i});
        }
      }
    }
  }

  void interpolate_made_corners(const ProgressCallback& progress) {
    std::sort(made_.begin(), made_.end());
    constexpr std::size_t corners_per_report = 1024;
    for (std::size_t begin = 0, end = 0, next_report = corners_per_report; begin < made_.size(); begin = end) {
      while (end < made_.size() && made_[end].is_at_same_place(made_[begin])) ++end;
      interpolate(std::span(made_).subspan(begin, end - begin));
      if (end < next_report) continue;
      next_report = end + corners_per_report;
      report_progress(progress, "transfer_data", 0.95 + 0.05 * static_cast<double>(end) / static_cast<double>(made_.size()));
    }
  }

 private:
  [[nodiscard]] const ChannelSource& source_of(SourceId face, std::size_t channel) const {
    return channel_sources_[source_.faces.operand[face].index() * channels_.size() + channel];
  }

  /// The values of a face at one of its corners; null where its operand has none.
  [[nodiscard]] const double* values_at(SourceId face, std::size_t corner, std::size_t channel) const {
    const ChannelSource& source = source_of(face, channel);
    const std::size_t f = source_.faces.face_in_operand(face);
    if (source.at_corners != nullptr) return source.at_corners->values.data() + (3 * f + corner) * source.at_corners->components;
    if (source.at_vertices == nullptr) return nullptr;
    const SurfaceMesh& mesh = *source_.operands[source_.faces.operand[face].index()];
    return source.at_vertices->values.data() + mesh.triangles[f][corner].index() * source.at_vertices->components;
  }

  void copy(SourceId face, std::size_t at, std::size_t corner) {
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      const double* const values = values_at(face, at, c);
      const std::size_t n = channels_[c].components;
      for (std::size_t k = 0; values != nullptr && k < n; ++k) {
        channels_[c].values[corner * n + k] = is_no_value(values[k]) ? no_value : values[k];  // NaN has one bit pattern here
      }
    }
  }

  void interpolate(std::span<const MadeCorner> corners) {
    const SourceId face = corners.front().face;
    const PointInTriangle place(source_.faces.points, source_.faces.corners[face], corners.front().point);
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      const double *const first = values_at(face, 0, c), *const second = values_at(face, 1, c), *const third = values_at(face, 2, c);
      const std::size_t n = channels_[c].components;
      for (std::size_t k = 0; first != nullptr && k < n; ++k) {
        const double value = place.interpolate({first[k], second[k], third[k]});
        for (const MadeCorner& m : corners) channels_[c].values[m.corner * n + k] = value;
      }
    }
  }

  const ExactOperands& source_;
  std::vector<DataChannel>& channels_;
  std::vector<ChannelSource> channel_sources_;  ///< operand after operand, one per channel
  std::vector<MadeCorner> made_;
};

void turn_normals_of_flipped(std::span<const TriangleInFace> triangles, std::vector<DataChannel>& channels) {
  for (DataChannel& c : channels) {
    if (c.kind != DataKind::Normal) continue;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (triangles[t].is_flipped) turn_normals(FaceId(t), c);
    }
  }
}

}  // namespace

std::vector<DataChannel> join_channels(std::span<const SurfaceMesh* const> operands) {
  std::vector<DataChannel> joined;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    for (const DataChannel& c : operands[k]->vertex_data) join(c, k, joined);
    for (const DataChannel& c : operands[k]->corner_data) join(c, k, joined);
  }
  return joined;
}

void transfer_data(const ExactOperands& source, std::span<const TriangleInFace> triangles, std::vector<DataChannel>& channels,
                   const ProgressCallback& progress) {
  if (channels.empty()) return;
  report_progress(progress, "transfer_data", 0.95);
  DataTransfer transfer(source, channels);
  transfer.copy_corners(triangles);
  transfer.interpolate_made_corners(progress);
  turn_normals_of_flipped(triangles, channels);
}

std::vector<TriangleInFace> triangles_in_faces(const OperandFaces& faces, const BooleanResult& result) {
  std::vector<TriangleInFace> triangles;
  const Provenance& p = result.provenance;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const SourceId face(std::size_t{faces.first[OperandId(p.source_operand[t])]} + p.source_face[t]);
    triangles.push_back({result.mesh.triangles[t], face, p.flipped[t] != 0});
  }
  return triangles;
}

}  // namespace mortise
