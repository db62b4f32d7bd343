// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertex properties of PLY files as data channels, and channels as properties.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mortise/io/ply_header.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Where the values of a column belong.
struct PlyTarget {
  static constexpr std::uint32_t none = 0xffffffffU;

  std::uint32_t channel = none;  ///< none: nowhere
  std::uint32_t component = 0;
  double whole = 1;  ///< what the value is divided by: 255 for colours of one byte
};

/// The channels of the vertices of a file, empty, and a target for each of their columns.
struct PlyVertexData {
  std::vector<DataChannel> channels;
  std::vector<PlyTarget> targets;
};

/// What the columns of an element "vertex" mean, coordinates apart: nx, ny, nz are "normal"; s, t or u, v or texture_u, texture_v are
/// "uv"; red, green, blue and perhaps alpha are "color", from 0 to 1; every other number is a channel of its own name.
[[nodiscard]] PlyVertexData read_vertex_columns(const PlyElement& element);

/// A column of numbers for each vertex.
struct PlyColumn {
  std::string name;
  const DataChannel* channel;
  std::uint32_t component;
  bool is_byte;  ///< a colour: from 0 to 255, 0 where there is no value

  [[nodiscard]] double value(std::size_t vertex) const { return channel->values[vertex * channel->components + component]; }
  [[nodiscard]] std::uint8_t byte(std::size_t vertex) const;
};

/// The columns that read_vertex_columns() takes for these channels. Others of several components are one column each, "name_0" and so
/// on; a name the format cannot hold, or has already, is left out.
[[nodiscard]] std::vector<PlyColumn> write_vertex_columns(const std::vector<DataChannel>& channels);

}  // namespace mortise
