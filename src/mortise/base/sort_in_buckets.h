// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sorting by a small number first: linear time where few items share it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mortise {

/// The items by bucket, and within each bucket by `is_before`, a total order. Takes as much memory again.
///
/// @param bucket_of  item -> its number, below bucket_count
/// O(n log k + bucket_count) for at most k items in a bucket.
template <class Item, class BucketOf, class IsBefore>
[[nodiscard]] std::vector<Item> sorted_in_buckets(const std::vector<Item>& items, std::size_t bucket_count, BucketOf bucket_of,
                                                  IsBefore is_before) {
  std::vector<std::size_t> next(bucket_count + 1, 0);
  for (const Item& item : items) ++next[bucket_of(item) + 1];
  for (std::size_t b = 0; b < bucket_count; ++b) next[b + 1] += next[b];
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[next[bucket_of(item)]++] = item;
  for (std::size_t i = 0; i < sorted.size();) {
    const std::size_t end = next[bucket_of(sorted[i])];  // by now the end of the bucket
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(i), sorted.begin() + static_cast<std::ptrdiff_t>(end), is_before);
    i = end;
  }
  return sorted;
}

}  // namespace mortise
