// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A hash table from positions to point ids; several points may share one position.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "mortise/base/bits.h"
#include "mortise/exact/point_set.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// Open addressing with linear probing; the positions stay with the owner of the table. -0 equals +0. Probing order depends
/// on the positions and on the order of insertion only.
class PointTable {
 public:
  /// The first point, in order of insertion, at this position for which is_same(id) holds; an invalid id if there is none.
  template <class IsSame>
  [[nodiscard]] PointId find(const std::vector<Vec3d>& positions, const Vec3d& position, IsSame&& is_same) const {
    if (slots_.empty()) return PointId();
    for (std::uint32_t slot = hash(position) & mask();; slot = (slot + 1) & mask()) {
      const PointId id = slots_[slot];
      if (!id.is_valid()) return id;
      if (positions[id.index()] == position && is_same(id)) return id;
    }
  }

  /// Adds the last of the positions.
  void insert_last(const std::vector<Vec3d>& positions) {
    if (2 * positions.size() > slots_.size()) {
      rebuild(positions, positions.size());
    } else {
      place(positions, PointId(positions.size() - 1));
    }
  }

  /// Makes room for `capacity` points.
  void rebuild(const std::vector<Vec3d>& positions, std::size_t capacity) {
    const auto wanted = std::uint64_t{2} * capacity;
    if (wanted > slots_.size() || slots_.empty())
      slots_.assign(static_cast<std::size_t>(std::bit_ceil(2 * wanted | 16)), PointId());
    else
      slots_.assign(slots_.size(), PointId());
    for (std::size_t i = 0; i < positions.size(); ++i) place(positions, PointId(i));
  }

 private:
  [[nodiscard]] std::uint32_t mask() const { return static_cast<std::uint32_t>(slots_.size() - 1); }

  [[nodiscard]] static std::uint32_t hash(const Vec3d& p) {
    std::uint64_t h = 0;
    for (const double x : {p.x, p.y, p.z}) {
      h = (h ^ cast_bits<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15ULL;  // + 0.0 makes -0 positive
      h ^= h >> 32;
    }
    return static_cast<std::uint32_t>((h * 0xd6e8feb86659fd93ULL) >> 32);
  }

  void place(const std::vector<Vec3d>& positions, PointId id) {
    std::uint32_t slot = hash(positions[id.index()]) & mask();
    while (slots_[slot].is_valid()) slot = (slot + 1) & mask();
    slots_[slot] = id;
  }

  std::vector<PointId> slots_;
};

}  // namespace mortise
