// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Spaces on both sides of stacked triangles cancel in pairs; what is left are the two outermost, or a sheet. Or faces of one operand
// cancel.
#include "mortise/boolean/join_coincident.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>

#include "mortise/boolean/facet_sources.h"
#include "mortise/boolean/stacked_triangles.h"

namespace mortise {
namespace {

// A source of one of the triangles on the same corners.
struct StackedSource {
  SourceFace face;  // flipped: the ascending corners run against it
  StackedTriangle triangle;
};

// Removes pairs of faces of one operand that run against each other, but for those of sheets; the rest ascending.
void cancel_opposites(const Provenance& p, std::vector<StackedSource>& sources) {
  const auto is_of_sheet = [&](const StackedSource& s) { return p.covering[s.triangle.triangle] == p.covering_front[s.triangle.triangle]; };
  std::sort(sources.begin(), sources.end(), [](const StackedSource& a, const StackedSource& b) {
    return a.face != b.face ? a.face < b.face : a.triangle.triangle < b.triangle.triangle;
  });
  for (std::size_t i = 0; i < sources.size();) {
    const auto opposite = std::find_if(sources.begin() + static_cast<std::ptrdiff_t>(i) + 1, sources.end(), [&](const StackedSource& s) {
      const bool is_opposite = s.face.operand == sources[i].face.operand && s.face.is_flipped != sources[i].face.is_flipped;
      return is_opposite && !is_of_sheet(s) && !is_of_sheet(sources[i]);
    });
    if (opposite == sources.end()) {
      ++i;
      continue;
    }
    sources.erase(opposite);
    sources.erase(sources.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

class Joiner {
 public:
  Joiner(const FacetOrder& precedes, MergedMesh& merged)
      : precedes_(precedes), merged_(merged), remains_(merged.mesh.triangles.size(), 0) {}

  [[nodiscard]] std::vector<std::uint8_t> run() {
    const std::vector<StackedTriangle> sorted = sorted_by_corners(merged_.mesh.triangles);
    joined_.resize(remains_.size());
    for (std::size_t i = 0; i < sorted.size();) {
      std::size_t end = i;
      while (end < sorted.size() && sorted[end].corners == sorted[i].corners) ++end;
      if (end - i == 1) remains_[sorted[i].triangle] = 1;
      if (end - i > 1) join(std::span(sorted).subspan(i, end - i));
      i = end;
    }
    write_sources();
    return std::move(remains_);
  }

 private:
  void join(std::span<const StackedTriangle> stack) {
    const std::vector<StackedTriangle> by_facet = sorted_by_facet(stack);
    const std::optional<OuterSpaces> spaces = outer_spaces(by_facet, merged_.provenance);
    std::vector<StackedSource> sources = sources_of(stack);
    if (merged_.keeps_all_sources) cancel_opposites(merged_.provenance, sources);
    if (sources.empty() || (!spaces && !merged_.keeps_all_sources)) return;
    const StackedTriangle& kept = sources.front().triangle;
    remains_[kept.triangle] = 1;
    std::vector<SourceFace>& faces = joined_[kept.triangle];
    for (const StackedSource& s : sources) faces.push_back({s.face.operand, s.face.face, s.face.is_flipped == kept.is_even});
    Provenance& p = merged_.provenance;
    if (merged_.keeps_all_sources) {
      set_spaces_by_sources(stack, kept.triangle);
      p.category[kept.triangle] = category_seen_from(faces.front(), faces, p, kept.triangle);
    } else {
      p.covering_front[kept.triangle] = kept.is_even ? spaces->in_front : spaces->behind;
      p.covering[kept.triangle] = kept.is_even ? spaces->behind : spaces->in_front;
    }
    mark_wall(kept.triangle);
    set_facet(by_facet.front(), kept);
  }

  [[nodiscard]] std::vector<StackedTriangle> sorted_by_facet(std::span<const StackedTriangle> stack) const {
    std::vector<StackedTriangle> sorted(stack.begin(), stack.end());
    std::stable_sort(sorted.begin(), sorted.end(), [&](const StackedTriangle& s, const StackedTriangle& t) {
      return precedes_(merged_.facet_of_triangle[s.triangle].facet, merged_.facet_of_triangle[t.triangle].facet);
    });
    return sorted;
  }

  void set_facet(const StackedTriangle& from, const StackedTriangle& to) {
    const KeptFacet source = merged_.facet_of_triangle[from.triangle];
    KeptFacet& facet = merged_.facet_of_triangle[to.triangle];
    facet.facet = source.facet;
    facet.is_flipped = source.is_flipped == (from.is_even == to.is_even);
  }

  void mark_wall(std::uint32_t t) {
    const Provenance& p = merged_.provenance;
    const bool is_wall = p.covering_sets[p.covering[t]].empty() == p.covering_sets[p.covering_front[t]].empty();
    std::vector<std::uint8_t>& walls = merged_.mesh.walls;
    if (is_wall) walls.resize(remains_.size(), 0);
    if (!walls.empty()) walls[t] = is_wall ? 1 : 0;
  }

  // Operands that have a face here which parts their inside from their outside; ascending.
  [[nodiscard]] std::vector<std::uint32_t> parted_operands(std::span<const StackedTriangle> stack) const {
    const Provenance& p = merged_.provenance;
    std::vector<std::uint32_t> parted;
    for (const StackedTriangle& t : stack) {
      const auto &behind = p.covering_sets[p.covering[t.triangle]], &in_front = p.covering_sets[p.covering_front[t.triangle]];
      std::set_symmetric_difference(behind.begin(), behind.end(), in_front.begin(), in_front.end(), std::back_inserter(parted));
    }
    std::sort(parted.begin(), parted.end());
    parted.erase(std::unique(parted.begin(), parted.end()), parted.end());
    return parted;
  }

  // Rounding may have laid faces on one another in another order than the exact one: the spaces between them say nothing then,
  // but an operand is behind its faces.
  void set_spaces_by_sources(std::span<const StackedTriangle> stack, std::uint32_t kept) {
    Provenance& p = merged_.provenance;
    const std::vector<std::uint32_t> parted = parted_operands(stack);
    const auto is_parted = [&](std::uint32_t k) { return std::binary_search(parted.begin(), parted.end(), k); };
    std::vector<std::uint32_t> behind = p.covering_sets[p.covering[kept]];
    std::erase_if(behind, is_parted);
    std::vector<std::uint32_t> in_front = behind;
    for (const SourceFace& s : joined_[kept]) {
      if (is_parted(s.operand)) (s.is_flipped ? in_front : behind).push_back(s.operand);
    }
    p.covering[kept] = covering_of(std::move(behind));
    p.covering_front[kept] = covering_of(std::move(in_front));
  }

  [[nodiscard]] std::uint32_t covering_of(std::vector<std::uint32_t> operands) {
    std::sort(operands.begin(), operands.end());
    operands.erase(std::unique(operands.begin(), operands.end()), operands.end());
    std::vector<std::vector<std::uint32_t>>& sets = merged_.provenance.covering_sets;
    const auto at = std::find(sets.begin(), sets.end(), operands);
    const auto number = static_cast<std::uint32_t>(at - sets.begin());
    if (at == sets.end()) sets.push_back(std::move(operands));
    return number;
  }

  [[nodiscard]] std::vector<StackedSource> sources_of(std::span<const StackedTriangle> stack) const {
    std::vector<StackedSource> sources;
    for (const StackedTriangle& t : stack) {
      for (SourceFace s : facet_sources(merged_.provenance, t.triangle)) {
        s.is_flipped = s.is_flipped == t.is_even;
        sources.push_back({s, t});
      }
    }
    return sources;
  }

  void write_sources() {
    Provenance& p = merged_.provenance;
    Provenance others;
    for (std::size_t t = 0; t < remains_.size(); ++t) {
      others.other_source_begin.push_back(static_cast<std::uint32_t>(others.other_source_face.size()));
      const std::vector<SourceFace> sources = joined_[t].empty() ? facet_sources(p, t) : std::move(joined_[t]);
      p.source_operand[t] = sources.front().operand;
      p.source_face[t] = sources.front().face;
      p.flipped[t] = sources.front().is_flipped ? 1 : 0;
      for (const SourceFace& s : std::span(sources).subspan(1)) {
        others.other_source_operand.push_back(s.operand);
        others.other_source_face.push_back(s.face);
        others.other_source_flipped.push_back(s.is_flipped ? 1 : 0);
      }
    }
    others.other_source_begin.push_back(static_cast<std::uint32_t>(others.other_source_face.size()));
    p.other_source_begin = std::move(others.other_source_begin);
    p.other_source_operand = std::move(others.other_source_operand);
    p.other_source_face = std::move(others.other_source_face);
    p.other_source_flipped = std::move(others.other_source_flipped);
  }

  const FacetOrder& precedes_;
  MergedMesh& merged_;
  std::vector<std::uint8_t> remains_;
  std::vector<std::vector<SourceFace>> joined_;  // per triangle that stands for several
};

}  // namespace

std::vector<std::uint8_t> join_coincident(const FacetOrder& precedes, MergedMesh& merged) { return Joiner(precedes, merged).run(); }

}  // namespace mortise
