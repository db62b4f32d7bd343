// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Spaces on both sides of stacked triangles cancel in pairs; what is left are the two outermost.
#include "mortise/boolean/join_coincident.h"

#include <algorithm>
#include <array>
#include <span>

namespace mortise {
namespace {

struct Stacked {
  std::array<VertexId, 3> corners;  // ascending
  std::uint32_t triangle;
  bool is_even;  // runs along them

  bool operator<(const Stacked& other) const { return corners != other.corners ? corners < other.corners : triangle < other.triangle; }
};

bool repeats_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

std::vector<Stacked> sorted_by_corners(const std::vector<Triangle>& triangles) {
  std::vector<Stacked> sorted;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    if (repeats_corner(t)) continue;
    Stacked s{{t[0], t[1], t[2]}, i, true};
    std::sort(s.corners.begin(), s.corners.end());
    const auto first = static_cast<std::size_t>(std::find(t.begin(), t.end(), s.corners[0]) - t.begin());
    s.is_even = t[(first + 1) % 3] == s.corners[1];
    sorted.push_back(s);
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

class Joiner {
 public:
  explicit Joiner(MergedMesh& merged) : merged_(merged), remains_(merged.mesh.triangles.size(), 0) {}

  [[nodiscard]] std::vector<std::uint8_t> run() {
    const std::vector<Stacked> sorted = sorted_by_corners(merged_.mesh.triangles);
    others_.resize(remains_.size());
    for (std::size_t i = 0; i < sorted.size();) {
      std::size_t end = i;
      while (end < sorted.size() && sorted[end].corners == sorted[i].corners) ++end;
      join(std::span(sorted).subspan(i, end - i));
      i = end;
    }
    add_other_sources();
    return std::move(remains_);
  }

 private:
  void join(std::span<const Stacked> stack) {
    if (stack.size() == 1) {
      remains_[stack.front().triangle] = 1;
      return;
    }
    std::vector<std::uint32_t> fronts, backs;  // of the corners in ascending order
    for (const Stacked& s : stack) {
      const std::uint32_t front = merged_.provenance.covering_front[s.triangle], back = merged_.provenance.covering[s.triangle];
      fronts.push_back(s.is_even ? front : back);
      backs.push_back(s.is_even ? back : front);
    }
    for (const std::uint32_t space : std::vector<std::uint32_t>(fronts)) {
      const auto at = std::find(backs.begin(), backs.end(), space);
      if (at == backs.end()) continue;
      backs.erase(at);
      fronts.erase(std::find(fronts.begin(), fronts.end(), space));
    }
    if (fronts.empty()) return;
    const Stacked& first = stack.front();
    remains_[first.triangle] = 1;
    merged_.provenance.covering_front[first.triangle] = first.is_even ? fronts.front() : backs.front();
    merged_.provenance.covering[first.triangle] = first.is_even ? backs.front() : fronts.front();
    for (const Stacked& s : stack.subspan(1)) others_[first.triangle].push_back(s.triangle);
  }

  void add_other_sources() {
    Provenance& p = merged_.provenance;
    std::vector<std::uint32_t> begin, operand, face;
    const auto add_others_of = [&](std::size_t t) {
      for (std::uint32_t i = p.other_source_begin[t]; i < p.other_source_begin[t + 1]; ++i) {
        operand.push_back(p.other_source_operand[i]);
        face.push_back(p.other_source_face[i]);
      }
    };
    for (std::size_t t = 0; t < remains_.size(); ++t) {
      begin.push_back(static_cast<std::uint32_t>(operand.size()));
      add_others_of(t);
      for (const std::uint32_t other : others_[t]) {
        operand.push_back(p.source_operand[other]);
        face.push_back(p.source_face[other]);
        add_others_of(other);
      }
    }
    begin.push_back(static_cast<std::uint32_t>(operand.size()));
    p.other_source_begin = std::move(begin);
    p.other_source_operand = std::move(operand);
    p.other_source_face = std::move(face);
  }

  MergedMesh& merged_;
  std::vector<std::uint8_t> remains_;
  std::vector<std::vector<std::uint32_t>> others_;  // per triangle: those it stands for as well
};

}  // namespace

std::vector<std::uint8_t> join_coincident(MergedMesh& merged) { return Joiner(merged).run(); }

}  // namespace mortise
