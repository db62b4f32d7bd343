// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Disjoint sets whose representative is the smallest member, whatever the order of joins.
#include "mortise/base/union_find.h"

#include <algorithm>
#include <random>
#include <utility>

#include "support/catch.h"
#include "support/test_scale.h"

using namespace mortise;

TEST_CASE("the representative is the smallest member, for every order of joins") {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joins{{4, 2}, {2, 7}, {9, 4}, {1, 3}};
  std::sort(joins.begin(), joins.end());
  do {
    UnionFind sets(10);
    for (const auto& [a, b] : joins) sets.join(a, b);
    for (const std::uint32_t i : {2U, 4U, 7U, 9U}) CHECK(sets.find(i) == 2);
    for (const std::uint32_t i : {1U, 3U}) CHECK(sets.find(i) == 1);
    for (const std::uint32_t i : {0U, 5U, 6U, 8U}) CHECK(sets.find(i) == i);
  } while (std::next_permutation(joins.begin(), joins.end()));
}

TEST_CASE("an added member is alone until it is joined") {
  UnionFind sets(2);
  CHECK(sets.add() == 2);
  CHECK(sets.size() == 3);
  CHECK(sets.find(2) == 2);
  sets.join(2, 1);
  CHECK(sets.find(2) == 1);
  CHECK(UnionFind(0).add() == 0);
}

TEST_CASE("random joins agree with relabelling everything") {
  constexpr std::uint32_t seed = 12;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (std::size_t round = 0; round < mortise::test::scaled_count(50, 5000); ++round) {
    const auto n = static_cast<std::uint32_t>(1 + random() % 60);
    UnionFind sets(n);
    std::vector<std::uint32_t> label(n);
    for (std::uint32_t i = 0; i < n; ++i) label[i] = i;
    for (std::uint32_t j = 0; j < n; ++j) {
      const auto a = static_cast<std::uint32_t>(random() % n), b = static_cast<std::uint32_t>(random() % n);
      sets.join(a, b);
      const std::uint32_t low = std::min(label[a], label[b]), high = std::max(label[a], label[b]);
      std::replace(label.begin(), label.end(), high, low);
    }
    for (std::uint32_t i = 0; i < n; ++i) CHECK(sets.find(i) == label[i]);
  }
}

TEST_CASE("a chain of a million joins is found without deep recursion") {
  constexpr std::uint32_t n = 1000000;
  UnionFind sets(n);
  for (std::uint32_t i = n - 1; i > 0; --i) sets.join(i - 1, i);
  CHECK(sets.find(n - 1) == 0);
}
