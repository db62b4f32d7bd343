// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Makes vertices of exactly equal position one vertex, by an open hash table; ids follow first occurrence, not the table.
#include "mortise/mesh/weld.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "mortise/base/bits.h"
#include "mortise/mesh/corner_data.h"

namespace mortise {
namespace {

using PositionKey = std::array<std::uint64_t, 3>;

/// Equal for equal positions: adding +0 turns -0 into +0.
PositionKey key_of(const Vec3d& p) {
  return {cast_bits<std::uint64_t>(p.x + 0.0), cast_bits<std::uint64_t>(p.y + 0.0), cast_bits<std::uint64_t>(p.z + 0.0)};
}

std::uint64_t hash_of(const PositionKey& key) {
  std::uint64_t h = 0;
  for (const std::uint64_t bits : key) {
    h = (h ^ bits) * 0x9e3779b97f4a7c15U;
    h ^= h >> 32;
  }
  return h * 0xd6e8feb86659fd93U >> 16;
}

/// Gives every new position the next id.
class PositionTable {
 public:
  explicit PositionTable(std::size_t positions) : slots_(std::bit_ceil(2 * positions + 1), empty_slot) { first_.reserve(positions); }

  VertexId id_of(const Vec3d& p) {
    const PositionKey key = key_of(p);
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash_of(key)) & mask;
    for (; slots_[slot] != empty_slot; slot = (slot + 1) & mask) {
      if (key_of(first_[slots_[slot]]) == key) return VertexId(slots_[slot]);
    }
    slots_[slot] = static_cast<std::uint32_t>(first_.size());
    first_.push_back(p);
    return VertexId(first_.size() - 1);
  }

  [[nodiscard]] std::vector<Vec3d> take_positions() { return std::move(first_); }

 private:
  static constexpr std::uint32_t empty_slot = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> slots_;
  std::vector<Vec3d> first_;
};

}  // namespace

WeldedMesh weld(const SurfaceMesh& mesh) {
  WeldedMesh welded;
  PositionTable table(mesh.points.size());
  welded.new_vertex.reserve(mesh.points.size());
  for (const Vec3d& p : mesh.points) {
    const VertexId v = table.id_of(p);
    if (v.index() == welded.old_vertex.size()) welded.old_vertex.push_back(VertexId(welded.new_vertex.size()));
    welded.new_vertex.push_back(v);
  }
  welded.mesh = {table.take_positions(),  mesh.triangles, mesh.face_labels, mesh.label_names, mesh.walls, mesh.diagonals, {},
                 all_as_corner_data(mesh)};
  for (Triangle& triangle : welded.mesh.triangles) {
    for (VertexId& vertex : triangle) vertex = welded.new_vertex[vertex.index()];
  }
  return welded;
}

}  // namespace mortise
