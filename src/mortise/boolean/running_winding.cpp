// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Keeps count, digest and crossings in step with the windings.
#include "mortise/boolean/running_winding.h"

#include "mortise/base/bits.h"

namespace mortise {

RunningWinding::RunningWinding(std::vector<int> winding) : winding_(winding.size(), 0) { change_to(winding); }

std::uint64_t RunningWinding::digest_of_change(OperandId k, int by) {
  return mixed_bits(k.value) * static_cast<std::uint64_t>(std::int64_t{by});
}

void RunningWinding::change(OperandId k, int by) {
  int& w = winding_[k.index()];
  const bool was_inside = w > 0;
  w += by;
  digest_ += digest_of_change(k, by);
  if (was_inside == (w > 0)) return;
  crossed_.push_back(k);
  inside_count_ = was_inside ? inside_count_ - 1 : inside_count_ + 1;
}

void RunningWinding::change_to(const std::vector<int>& winding) {
  for (std::size_t k = 0; k < winding.size(); ++k) {
    if (winding[k] != winding_[k]) change(OperandId(k), winding[k] - winding_[k]);
  }
}

}  // namespace mortise
