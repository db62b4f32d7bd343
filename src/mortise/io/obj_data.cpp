// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Texture coordinates and normals of OBJ texts.
#include "mortise/io/obj_data.h"

#include <algorithm>
#include <functional>

#include "mortise/base/bits.h"
#include "mortise/base/numbers.h"
#include "mortise/mesh/corner_data.h"

namespace mortise {
namespace {

std::optional<DataChannel> find_channel(const SurfaceMesh& mesh, const std::function<bool(const DataChannel&)>& is_wanted) {
  const auto at_corner = std::find_if(mesh.corner_data.begin(), mesh.corner_data.end(), is_wanted);
  if (at_corner != mesh.corner_data.end()) return *at_corner;
  const auto at_vertex = std::find_if(mesh.vertex_data.begin(), mesh.vertex_data.end(), is_wanted);
  if (at_vertex == mesh.vertex_data.end()) return std::nullopt;
  return as_corner_data(*at_vertex, mesh.triangles);
}

/// Orders corners by the bits of their values.
class ValueOrder {
 public:
  explicit ValueOrder(const DataChannel& channel) : channel_(channel) {}

  [[nodiscard]] int compare(std::uint32_t a, std::uint32_t b) const {
    for (std::size_t k = 0; k < channel_.components; ++k) {
      const auto x = bits(a, k), y = bits(b, k);
      if (x != y) return x < y ? -1 : 1;
    }
    return 0;
  }
  [[nodiscard]] bool lacks_value(std::uint32_t corner) const {
    const auto first = channel_.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{corner} * channel_.components);
    return std::any_of(first, first + channel_.components, is_no_value);
  }

 private:
  [[nodiscard]] std::uint64_t bits(std::uint32_t corner, std::size_t k) const {
    return cast_bits<std::uint64_t>(channel_.values[std::size_t{corner} * channel_.components + k]);
  }

  const DataChannel& channel_;
};

/// For every corner the lowest one with its values.
std::vector<std::uint32_t> lowest_equals(const ValueOrder& order, std::size_t corners) {
  std::vector<std::uint32_t> sorted(corners), lowest(corners);
  for (std::uint32_t c = 0; c < corners; ++c) sorted[c] = c;
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
    const int way = order.compare(a, b);
    return way != 0 ? way < 0 : a < b;
  });
  for (std::size_t i = 0; i < corners; ++i) {
    const bool is_new = i == 0 || order.compare(sorted[i - 1], sorted[i]) != 0;
    lowest[sorted[i]] = is_new ? sorted[i] : lowest[sorted[i - 1]];
  }
  return lowest;
}

}  // namespace

void append_indexed(int index, std::size_t before, const ObjValues& values, std::vector<double>& numbers) {
  const std::int64_t place = index > 0 ? std::int64_t{index} - 1 : static_cast<std::int64_t>(before) + index;
  const bool exists = index != 0 && place >= 0 && place < static_cast<std::int64_t>(values.size());
  for (std::size_t k = 0; k < values.components; ++k) {
    numbers.push_back(exists ? values.numbers[static_cast<std::size_t>(place) * values.components + k] : no_value);
  }
}

bool has_values(const DataChannel& channel) { return !std::all_of(channel.values.begin(), channel.values.end(), is_no_value); }

std::optional<DataChannel> uv_of(const SurfaceMesh& mesh) {
  return find_channel(mesh, [](const DataChannel& c) { return c.name == "uv" && c.components == 2; });
}

std::optional<DataChannel> normals_of(const SurfaceMesh& mesh) {
  return find_channel(mesh, [](const DataChannel& c) { return c.name == "normal" && c.kind == DataKind::Normal; });
}

std::vector<std::uint32_t> write_values(std::string_view keyword, const std::optional<DataChannel>& at_corners, std::string& text) {
  std::vector<std::uint32_t> numbers;
  if (!at_corners) return numbers;
  const std::size_t n = at_corners->components;
  const ValueOrder order(*at_corners);
  const std::vector<std::uint32_t> lowest = lowest_equals(order, at_corners->values.size() / n);
  std::uint32_t written = 0;
  for (std::uint32_t c = 0; c < lowest.size(); ++c) {
    if (lowest[c] != c || order.lacks_value(c)) {
      numbers.push_back(lowest[c] != c ? numbers[lowest[c]] : 0);
      continue;
    }
    numbers.push_back(++written);
    text.append(keyword);
    for (std::size_t k = 0; k < n; ++k) append_double(text.append(" "), at_corners->values[c * n + k]);
    text += '\n';
  }
  return numbers;
}

void append_indices(std::uint32_t texture, std::uint32_t normal, std::string& text) {
  if (texture == 0 && normal == 0) return;
  text += '/';
  if (texture != 0) text += std::to_string(texture);
  if (normal != 0) text.append("/").append(std::to_string(normal));
}

}  // namespace mortise
