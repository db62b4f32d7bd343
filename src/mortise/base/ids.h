// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Strong 32-bit ids, and arrays that only the right id can index.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace mortise {

/// A 32-bit index that does not mix with ids of another tag. Default: invalid.
template <class Tag>
struct Id {
  std::uint32_t value = std::numeric_limits<std::uint32_t>::max();

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}

  [[nodiscard]] constexpr bool is_valid() const { return value != std::numeric_limits<std::uint32_t>::max(); }
  [[nodiscard]] constexpr std::size_t index() const { return value; }
  constexpr auto operator<=>(const Id&) const = default;
};

using VertexId = Id<struct VertexTag>;    ///< vertex of one SurfaceMesh
using FaceId = Id<struct FaceTag>;        ///< triangle of one SurfaceMesh
using OperandId = Id<struct OperandTag>;  ///< position of an operand in a call

/// std::vector indexed by one kind of id.
template <class IdType, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t size, const T& value = T()) : values_(size, value) {}

  [[nodiscard]] decltype(auto) operator[](IdType id) { return values_[id.index()]; }
  [[nodiscard]] decltype(auto) operator[](IdType id) const { return values_[id.index()]; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] IdType next_id() const { return IdType(values_.size()); }
  [[nodiscard]] auto begin() { return values_.begin(); }
  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() { return values_.end(); }
  [[nodiscard]] auto end() const { return values_.end(); }
  [[nodiscard]] const std::vector<T>& values() const { return values_; }

  void reserve(std::size_t size) { values_.reserve(size); }
  void resize(std::size_t size, const T& value = T()) { values_.resize(size, value); }
  IdType push_back(const T& value) {
    values_.push_back(value);
    return IdType(values_.size() - 1);
  }

 private:
  std::vector<T> values_;
};

}  // namespace mortise
