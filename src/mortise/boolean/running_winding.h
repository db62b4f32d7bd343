// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Winding numbers of all operands, along a walk through the regions of space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/base/ids.h"

namespace mortise {

/// Winding numbers of one region, of all operands; positive is inside.
class RunningWinding {
 public:
  explicit RunningWinding(std::vector<int> winding);

  [[nodiscard]] int of(OperandId k) const { return winding_[k.index()]; }
  [[nodiscard]] bool is_inside(OperandId k) const { return winding_[k.index()] > 0; }
  [[nodiscard]] std::size_t inside_count() const { return inside_count_; }
  [[nodiscard]] std::size_t operand_count() const { return winding_.size(); }

  /// Operands that were entered or left since the walk visited a region before, or since all were outside; an operand may
  /// be named several times.
  [[nodiscard]] std::span<const OperandId> crossed() const { return crossed_; }
  void forget_crossed() { crossed_.clear(); }

  /// 64 bits of all windings: equal windings have equal digests.
  [[nodiscard]] std::uint64_t digest() const { return digest_; }
  /// By how much a change adds to the digest, modulo 2^64.
  [[nodiscard]] static std::uint64_t digest_of_change(OperandId k, int by);

  void change(OperandId k, int by);
  void change_to(const std::vector<int>& winding);

 private:
  std::vector<int> winding_;
  std::vector<OperandId> crossed_;
  std::size_t inside_count_ = 0;
  std::uint64_t digest_ = 0;
};

}  // namespace mortise
