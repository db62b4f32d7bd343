// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sorts triangles by corners, cancels the spaces between them.
#include "mortise/boolean/stacked_triangles.h"

#include <algorithm>

namespace mortise {
namespace {

bool repeats_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

}  // namespace

std::vector<StackedTriangle> sorted_by_corners(const std::vector<Triangle>& triangles) {
  std::vector<StackedTriangle> sorted;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    if (repeats_corner(t)) continue;
    StackedTriangle s{{t[0], t[1], t[2]}, i, true};
    std::sort(s.corners.begin(), s.corners.end());
    const auto first = static_cast<std::size_t>(std::find(t.begin(), t.end(), s.corners[0]) - t.begin());
    s.is_even = t[(first + 1) % 3] == s.corners[1];
    sorted.push_back(s);
  }
  std::sort(sorted.begin(), sorted.end(), [](const StackedTriangle& a, const StackedTriangle& b) {
    return a.corners != b.corners ? a.corners < b.corners : a.triangle < b.triangle;
  });
  return sorted;
}

std::optional<OuterSpaces> outer_spaces(std::span<const StackedTriangle> stack, const Provenance& p) {
  std::vector<std::uint32_t> in_front, behind;
  for (const StackedTriangle& s : stack) {
    in_front.push_back(s.is_even ? p.covering_front[s.triangle] : p.covering[s.triangle]);
    behind.push_back(s.is_even ? p.covering[s.triangle] : p.covering_front[s.triangle]);
  }
  for (const std::uint32_t space : std::vector<std::uint32_t>(in_front)) {
    const auto at = std::find_if(behind.begin(), behind.end(), [&](std::uint32_t other) { return p.space_of(other) == p.space_of(space); });
    if (at == behind.end()) continue;
    behind.erase(at);
    in_front.erase(std::find(in_front.begin(), in_front.end(), space));
  }
  if (in_front.empty()) {
    const auto is_sheet = [&](const StackedTriangle& s) { return p.covering[s.triangle] == p.covering_front[s.triangle]; };
    const auto sheet = std::find_if(stack.begin(), stack.end(), is_sheet);
    if (sheet == stack.end()) return std::nullopt;
    return OuterSpaces{p.covering[sheet->triangle], p.covering[sheet->triangle]};
  }
  return OuterSpaces{in_front.front(), behind.front()};
}

}  // namespace mortise
