// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A list as a sorted set.
#pragma once

#include <algorithm>
#include <vector>

namespace mortise {

/// Ascending, each value once.
template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace mortise
