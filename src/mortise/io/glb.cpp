// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Binary glTF: a text of JSON, then the numbers it points at.
#include "mortise/io/glb.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <string_view>

#include "mortise/base/error.h"
#include "mortise/base/numbers.h"
#include "mortise/base/sort_unique.h"
#include "mortise/geom/coordinates.h"
#include "mortise/geom/length.h"
#include "mortise/io/bytes.h"
#include "mortise/mesh/corners_to_vertices.h"
#include "mortise/mesh/group_by_label.h"

namespace mortise {
namespace {

constexpr std::string_view stage_name = "write_glb";

/// What glTF calls the channel; empty when it has no place for it.
std::string_view attribute_of(const DataChannel& channel) {
  const std::uint32_t n = channel.components;
  if (channel.name == "normal" && n == 3) return "NORMAL";
  if (channel.name == "uv" && n == 2) return "TEXCOORD_0";
  return channel.name == "color" && (n == 3 || n == 4) ? "COLOR_0" : "";
}

void drop_other_channels(std::vector<DataChannel>& channels) {
  const auto is_other = [](const DataChannel& c) { return attribute_of(c).empty(); };
  channels.erase(std::remove_if(channels.begin(), channels.end(), is_other), channels.end());
}

void refuse_large_coordinates(const SurfaceMesh& mesh) {
  std::vector<std::uint32_t> too_large;
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId v : triangle) {
      if (!fits_float32(mesh.points[v.index()])) too_large.push_back(v.value);
    }
  }
  if (too_large.empty()) return;
  sort_unique(too_large);
  throw Error(ErrorCode::OutOfRange, stage_name, "a coordinate does not fit a float").with_ids(IdKind::Vertices, std::move(too_large));
}

/// Triangles of one label in a row, data at vertices, no other data.
GroupedMesh prepare_mesh(const SurfaceMesh& given) {
  GroupedMesh result = group_by_label(given);
  refuse_large_coordinates(given);
  SurfaceMesh& mesh = result.part.mesh;
  drop_other_channels(mesh.vertex_data);
  drop_other_channels(mesh.corner_data);
  if (!mesh.vertex_data.empty() || !mesh.corner_data.empty()) mesh = corners_to_vertices(mesh, 0).mesh;
  return result;
}

/// Bytes of a character in UTF-8 at the beginning of a text; 0 when there is none.
std::size_t utf8_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xC2 ? 0 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : byte(0) < 0xF5 ? 4 : 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  return size;
}

/// Bytes that are no UTF-8 are taken for Latin-1.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (std::size_t i = 0, size = 0; i < text.size(); i += std::max<std::size_t>(size, 1)) {
    size = utf8_size(text.substr(i));
    const auto code = static_cast<unsigned char>(text[i]);
    if (size > 0 && code >= 0x20 && code != '"' && code != '\\') {
      result += text.substr(i, size);
    } else {
      constexpr std::string_view digits = "0123456789abcdef";
      result.append("\\u00").append(1, digits[code / 16]).append(1, digits[code % 16]);
    }
  }
  return result + '"';
}

/// One after the other, in less code than a chain of +.
std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

std::string text_of(std::size_t number) { return std::to_string(number); }

std::string list_of(const Vec3d& p) {
  const auto text = [](double x) { return format_float(static_cast<float>(x)); };
  return joined({"[", text(p.x), ",", text(p.y), ",", text(p.z), "]"});
}

class GlbWriter {
 public:
  explicit GlbWriter(const GroupedMesh& grouped) : mesh_(grouped.part.mesh), groups_(grouped.groups) {}

  std::string write() {
    if (!groups_.empty()) {
      add_positions();
      for (const DataChannel& channel : mesh_.vertex_data) add_channel(channel);
      add_primitives(add_indices());
    }
    return file_of(json());
  }

 private:
  /// A list of JSON, an item at a time.
  struct JsonList {
    std::string items;
    std::size_t count = 0;

    /// Returns the number of the item.
    std::string add(std::initializer_list<std::string_view> parts) {
      items.append(count == 0 ? "" : ",").append(joined(parts));
      return text_of(count++);
    }
  };

  /// Closes the view that begins at an offset; returns its number.
  std::string add_view(std::size_t begin, std::string_view target) {
    return views_.add({R"({"buffer":0,"byteOffset":)", text_of(begin), R"(,"byteLength":)", text_of(numbers_.size() - begin),
                       R"(,"target":)", target, "}"});
  }

  /// The attribute whose numbers begin at an offset, for every vertex.
  void add_attribute(std::string_view name, std::uint32_t components, std::size_t begin, std::string_view range) {
    const std::string accessor = accessors_.add({R"({"bufferView":)", add_view(begin, "34962"), R"(,"componentType":5126,"type":"VEC)",
                                                 text_of(components), R"(","count":)", text_of(mesh_.points.size()), range, "}"});
    attributes_.add({"\"", name, "\":", accessor});
  }

  void add_positions() {
    const std::size_t begin = numbers_.size();
    Vec3d lo = nearest_float32(mesh_.points[0]), hi = lo;
    for (const Vec3d& given : mesh_.points) {
      const Vec3d p = nearest_float32(given);
      for (std::size_t k = 0; k < 3; ++k) {
        lo[k] = std::min(lo[k], p[k]);
        hi[k] = std::max(hi[k], p[k]);
        append(p[k]);
      }
    }
    add_attribute("POSITION", 3, begin, joined({R"(,"min":)", list_of(lo), R"(,"max":)", list_of(hi)}));
  }

  void add_channel(const DataChannel& channel) {
    const std::string_view name = attribute_of(channel);
    const std::size_t begin = numbers_.size();
    for (std::size_t i = 0; i < channel.values.size(); i += channel.components) {
      const double* const values = channel.values.data() + i;
      if (name == "NORMAL") {
        append_normal({values[0], values[1], values[2]});
      } else if (name == "COLOR_0") {
        for (std::size_t k = 0; k < channel.components; ++k) append(std::clamp(values[k], 0.0, 1.0));
      } else {
        append(values[0]);
        append(1 - values[1]);
      }
    }
    add_attribute(name, channel.components, begin, "");
  }

  void append(double x) {
    constexpr double most = std::numeric_limits<float>::max();
    append_little_endian(numbers_, static_cast<float>(std::clamp(x, -most, most)));
  }

  /// Of length 1; glTF knows no other.
  void append_normal(const Vec3d& n) {
    const double size = length(n);
    if (!(size > 0)) return append_normal({0, 0, 1});
    for (std::size_t k = 0; k < 3; ++k) append(n[k] / size);
  }

  /// Returns the number of their view.
  std::string add_indices() {
    const std::size_t begin = numbers_.size();
    for (const Triangle& triangle : mesh_.triangles) {
      for (const VertexId v : triangle) append_little_endian(numbers_, v.value);
    }
    return add_view(begin, "34963");
  }

  void add_primitives(const std::string& view) {
    for (const FaceGroup& group : groups_) {
      const std::string accessor =
          accessors_.add({R"({"bufferView":)", view, R"(,"byteOffset":)", text_of(std::size_t{12} * group.first),
                          R"(,"componentType":5125,"type":"SCALAR","count":)", text_of(std::size_t{3} * group.count), "}"});
      const std::string label = mesh_.face_labels.empty() ? std::string() : mesh_.label_names[group.label];
      const std::string name = label.empty() ? std::string() : joined({R"("name":)", quoted(label), ","});
      const std::string material = materials_.add({"{", name, R"("pbrMetallicRoughness":{"metallicFactor":0},"doubleSided":true})"});
      primitives_.add({R"({"attributes":{)", attributes_.items, R"(},"indices":)", accessor, R"(,"material":)", material, "}"});
    }
  }

  [[nodiscard]] std::string json() const {
    constexpr std::string_view head = R"({"asset":{"version":"2.0","generator":"Mortise"},"scene":0,"scenes":[{)";
    if (groups_.empty()) return joined({head, "}]}"});
    return joined({head, R"("nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)", primitives_.items, R"(]}],"materials":[)",
                   materials_.items, R"(],"accessors":[)", accessors_.items, R"(],"bufferViews":[)", views_.items,
                   R"(],"buffers":[{"byteLength":)", text_of(numbers_.size()), "}]}"});
  }

  /// Header and chunks, the text filled up to whole words.
  [[nodiscard]] std::string file_of(std::string text) const {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::uint64_t size = 20 + std::uint64_t{text.size()} + (numbers_.empty() ? 0 : 8 + numbers_.size());
    if (size > 0xffffffffU) throw Error(ErrorCode::OutOfRange, stage_name, "a GLB file has at most 4 GB");
    std::string bytes = "glTF";
    for (const std::uint64_t word : {std::uint64_t{2}, size, std::uint64_t{text.size()}})
      append_little_endian(bytes, static_cast<std::uint32_t>(word));
    bytes.append("JSON").append(text);
    if (numbers_.empty()) return bytes;
    append_little_endian(bytes, static_cast<std::uint32_t>(numbers_.size()));
    return bytes.append("BIN", 4).append(numbers_);
  }

  const SurfaceMesh& mesh_;
  const std::vector<FaceGroup>& groups_;
  std::string numbers_;
  JsonList views_, accessors_, attributes_, materials_, primitives_;
};

}  // namespace

std::string write_glb(const SurfaceMesh& mesh) { return GlbWriter(prepare_mesh(mesh)).write(); }

}  // namespace mortise
