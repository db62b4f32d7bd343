// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Vertex properties of PLY files as data channels.
#include "mortise/io/ply_data.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

#include "mortise/mesh/corner_data.h"

namespace mortise {
namespace {

/// Columns that are one channel when all of them are there, the last one apart.
struct KnownColumns {
  std::string_view channel;
  DataKind kind;
  std::array<std::string_view, 4> columns;
  std::size_t least, most;
};

constexpr std::array<KnownColumns, 5> known_columns{{{"normal", DataKind::Normal, {"nx", "ny", "nz", ""}, 3, 3},
                                                     {"uv", DataKind::Value, {"s", "t", "", ""}, 2, 2},
                                                     {"uv", DataKind::Value, {"u", "v", "", ""}, 2, 2},
                                                     {"uv", DataKind::Value, {"texture_u", "texture_v", "", ""}, 2, 2},
                                                     {"color", DataKind::Value, {"red", "green", "blue", "alpha"}, 3, 4}}};

bool is_coordinate(std::string_view name) { return name == "x" || name == "y" || name == "z"; }

double largest_of(PlyType type) { return type == PlyType::Uint8 ? 255 : type == PlyType::Uint16 ? 65535 : 1; }

class ColumnReader {
 public:
  explicit ColumnReader(const PlyElement& element) : properties_(element.properties) { result_.targets.resize(properties_.size()); }

  PlyVertexData read() {
    for (const KnownColumns& known : known_columns) take(known);
    for (std::size_t i = 0; i < properties_.size(); ++i) {
      const bool is_taken = result_.targets[i].channel != PlyTarget::none;
      const PlyProperty& p = properties_[i];
      if (!is_taken && !p.is_list && !is_coordinate(p.name) && !has_channel(p.name)) add(p.name, DataKind::Value, {i});
    }
    return std::move(result_);
  }

 private:
  void take(const KnownColumns& known) {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < known.most; ++k) {
      const auto at = std::find_if(properties_.begin(), properties_.end(),
                                   [&](const PlyProperty& p) { return !p.is_list && p.name == known.columns[k]; });
      if (at != properties_.end() && found.size() == k) found.push_back(static_cast<std::size_t>(at - properties_.begin()));
    }
    if (found.size() < known.least || has_channel(known.channel)) return;
    add(known.channel, known.kind, found);
    if (known.channel != "color") return;
    for (const std::size_t i : found) result_.targets[i].whole = largest_of(properties_[i].type);
  }

  [[nodiscard]] bool has_channel(std::string_view name) const {
    return std::any_of(result_.channels.begin(), result_.channels.end(), [&](const DataChannel& c) { return c.name == name; });
  }

  void add(std::string_view name, DataKind kind, const std::vector<std::size_t>& columns) {
    const auto channel = static_cast<std::uint32_t>(result_.channels.size());
    result_.channels.push_back({std::string(name), static_cast<std::uint32_t>(columns.size()), kind, {}});
    for (std::uint32_t k = 0; k < columns.size(); ++k) result_.targets[columns[k]] = {channel, k, 1};
  }

  const std::vector<PlyProperty>& properties_;
  PlyVertexData result_;
};

/// A word that can stand in a header.
bool is_word(std::string_view name) {
  return std::none_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == 127; });
}

std::string column_name(const DataChannel& channel, std::uint32_t component) {
  for (const KnownColumns& known : known_columns) {
    const bool is_it = known.channel == channel.name && known.kind == channel.kind && channel.components >= known.least;
    if (is_it && channel.components <= known.most) return std::string(known.columns[component]);
  }
  return channel.components == 1 ? channel.name : channel.name + "_" + std::to_string(component);
}

}  // namespace

PlyVertexData read_vertex_columns(const PlyElement& element) { return ColumnReader(element).read(); }

std::uint8_t PlyColumn::byte(std::size_t vertex) const {
  const double x = value(vertex);
  return is_no_value(x) ? std::uint8_t{0} : static_cast<std::uint8_t>(std::clamp(x, 0.0, 1.0) * 255 + 0.5);
}

std::vector<PlyColumn> write_vertex_columns(const std::vector<DataChannel>& channels) {
  std::vector<PlyColumn> columns;
  for (const DataChannel& c : channels) {
    for (std::uint32_t k = 0; k < c.components; ++k) {
      std::string name = column_name(c, k);
      const auto has_name = [&](const PlyColumn& other) { return other.name == name; };
      if (!is_word(name) || is_coordinate(name) || std::any_of(columns.begin(), columns.end(), has_name)) continue;
      const bool is_byte = name == "red" || name == "green" || name == "blue" || name == "alpha";
      columns.push_back({std::move(name), &c, k, is_byte});
    }
  }
  return columns;
}

}  // namespace mortise
