// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Bucket sort against the sort of the library.
#include "mortise/base/sort_in_buckets.h"

#include <cstdint>
#include <utility>

#include "support/catch.h"
#include "support/random_source.h"

using namespace mortise;

TEST_CASE("sorting in buckets is sorting") {
  using Item = std::pair<std::uint32_t, std::uint32_t>;
  for (std::size_t seed = 1; seed <= 50; ++seed) {
    test::RandomSource random(seed);
    const std::size_t buckets = 1 + random.below(40), count = random.below(300);
    std::vector<Item> items;
    for (std::size_t i = 0; i < count; ++i) {
      const auto bucket = static_cast<std::uint32_t>(random.below(buckets));
      items.emplace_back(bucket, static_cast<std::uint32_t>(random.below(1000)));
    }
    const auto bucket_of = [](const Item& item) { return item.first; };
    const auto is_before = [](const Item& a, const Item& b) { return a.second < b.second; };
    const std::vector<Item> sorted = sorted_in_buckets(items, buckets, bucket_of, is_before);
    std::sort(items.begin(), items.end());
    CHECK(sorted == items);
  }
}
