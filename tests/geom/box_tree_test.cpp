// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The box tree against brute force.
#include "mortise/geom/box_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "support/catch.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Up to 60 boxes with corners on a grid (many touch, many are equal or flat), stretched by `scale`.
std::vector<Box3> random_boxes(std::mt19937& random, double scale) {
  const auto coordinate = [&] { return scale * (static_cast<double>(random() % 17) / 8 - 1); };
  std::vector<Box3> boxes(random() % 60);
  for (Box3& box : boxes) {
    box.extend(Vec3d{coordinate(), coordinate(), coordinate()});
    if (random() % 4 != 0) box.extend(Vec3d{coordinate(), coordinate(), coordinate()});
  }
  return boxes;
}

Pairs meeting_pairs(const std::vector<Box3>& a, const std::vector<Box3>& b) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      if (boxes_meet(a[i], b[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs pairs_within(const BoxTree& tree) {
  Pairs pairs;
  for_each_meeting_pair_within(tree, [&](std::uint32_t i, std::uint32_t j) { pairs.emplace_back(i, j); });
  return pairs;
}

}  // namespace

TEST_CASE("Every query finds what brute force finds, at every scale", "[geom][box_tree]") {
  const unsigned seed = 11;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  constexpr std::array<double, 4> scales{1, 1.7e308, 0x1p-1074 * 64, 1e-3};
  for (std::size_t round = 0; round < test::scaled_count(400, 4000); ++round) {
    const double scale = scales[round % scales.size()];
    const std::vector<Box3> boxes_a = random_boxes(random, scale);
    const std::vector<Box3> boxes_b = random_boxes(random, scale);
    const BoxTree a(boxes_a);
    const BoxTree b(boxes_b);

    Pairs pairs;
    for_each_meeting_pair(a, b, [&](std::uint32_t i, std::uint32_t j) { pairs.emplace_back(i, j); });
    REQUIRE(sorted(pairs) == meeting_pairs(boxes_a, boxes_b));

    Pairs single;
    for (std::uint32_t i = 0; i < boxes_a.size(); ++i) b.for_each_meeting(boxes_a[i], [&](std::uint32_t j) { single.emplace_back(i, j); });
    REQUIRE(sorted(single) == meeting_pairs(boxes_a, boxes_b));

    Pairs within = meeting_pairs(boxes_a, boxes_a);
    within.erase(std::remove_if(within.begin(), within.end(), [](const auto& pair) { return pair.first >= pair.second; }), within.end());
    REQUIRE(sorted(pairs_within(a)) == within);
  }
}

TEST_CASE("An empty tree meets nothing and has empty bounds", "[geom][box_tree]") {
  const BoxTree tree{std::vector<Box3>{}};
  const BoxTree other{std::vector<Box3>{Box3{{0, 0, 0}, {1, 1, 1}}}};
  int visits = 0;
  tree.for_each_meeting(Box3{{-1, -1, -1}, {1, 1, 1}}, [&](std::uint32_t) { ++visits; });
  for_each_meeting_pair(tree, other, [&](std::uint32_t, std::uint32_t) { ++visits; });
  for_each_meeting_pair(other, tree, [&](std::uint32_t, std::uint32_t) { ++visits; });
  for_each_meeting_pair_within(tree, [&](std::uint32_t, std::uint32_t) { ++visits; });
  CHECK(visits == 0);
  CHECK(tree.bounds().is_empty());
  CHECK(other.bounds().hi == Vec3d{1, 1, 1});
}

TEST_CASE("Empty boxes meet nothing and do not disturb the others", "[geom][box_tree]") {
  const Box3 unit{{0, 0, 0}, {1, 1, 1}};
  const BoxTree tree{std::vector<Box3>{Box3{}, unit, Box3{}, unit, Box3{}, Box3{}, Box3{}}};
  CHECK(pairs_within(tree) == Pairs{{1, 3}});
  CHECK(tree.bounds().lo == Vec3d{0, 0, 0});
}

TEST_CASE("Equal boxes are balanced, not chained", "[geom][box_tree]") {
  const BoxTree tree{std::vector<Box3>(1000, Box3{{3, 4, 5}, {3, 4, 5}})};
  CHECK(pairs_within(tree).size() == 1000 * 999 / 2);
  CHECK(tree.nodes().size() < 1024);
}

TEST_CASE("The tree depends on the boxes and their order only", "[geom][box_tree]") {
  std::mt19937 random(3);
  const std::vector<Box3> boxes = random_boxes(random, 1);
  const std::vector<Box3> copy(boxes.begin(), boxes.end());
  CHECK(pairs_within(BoxTree(boxes)) == pairs_within(BoxTree(copy)));
}

TEST_CASE("A tree over other boxes holds those that are not empty below the nodes that may keep", "[geom][box_tree]") {
  std::mt19937 random(12);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Box3> first = random_boxes(random, 1), partners = random_boxes(random, 3);
    std::vector<Box3> other = random_boxes(random, 3);
    other.resize(first.size());  // too short: the rest are empty
    const BoxTree tree(first);
    const Box3 middle{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
    const bool keeps_all = round % 2 == 0;
    std::vector<std::uint32_t> asked;
    const BoxTree changed = tree.with_boxes([&](const Box3& node) { return keeps_all || boxes_meet(node, middle); },
                                            [&](std::uint32_t id) {
                                              asked.push_back(id);
                                              return other[id];
                                            });
    for (std::uint32_t i = 0; i < first.size(); ++i) {
      const bool must_ask = !first[i].is_empty() && (keeps_all || boxes_meet(first[i], middle));
      CHECK((!must_ask || std::find(asked.begin(), asked.end(), i) != asked.end()));
    }
    std::vector<Box3> held(first.size());
    for (const std::uint32_t id : asked) held[id] = other[id];
    Pairs found;
    for_each_meeting_pair(changed, BoxTree(partners), [&](std::uint32_t i, std::uint32_t j) { found.emplace_back(i, j); });
    CHECK(sorted(found) == meeting_pairs(held, partners));
    CHECK(sorted(pairs_within(changed)) == sorted(pairs_within(BoxTree(held))));
    CHECK(changed.empty() == std::all_of(held.begin(), held.end(), [](const Box3& b) { return b.is_empty(); }));
  }
}

}  // namespace mortise
