// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Cells of the result, and which sides of which sheets they see.
#include "mortise/boolean/cut_by_sheets.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mortise/boolean/keep_triangles.h"
#include "mortise/mesh/face_marks.h"
#include "mortise/mesh/find_cells.h"

namespace mortise {
namespace {

class SheetCut {
 public:
  SheetCut(const OperandFaces& faces, const Facets& facets, MergedMesh& merged)
      : faces_(faces), facets_(facets), merged_(merged), cells_(find_cells(merged.mesh)), is_inside_(cells_.cells.size(), 0) {}

  [[nodiscard]] std::vector<std::string> run(std::vector<std::uint32_t>& failed_faces) && {
    for (std::size_t t = 0; t < cells_.behind.size(); ++t) look_at(t);
    for (const auto& [place, seen] : seen_) {
      if (seen.back && !seen.front) is_inside_[place.first] = 0;
    }
    failed_faces = renumbered(failed_faces, drop_cells());
    return notes();
  }

 private:
  struct Seen {
    bool front = false, back = false;
  };

  // A triangle between inside and outside makes the cell behind it part of the solid; a wall shows its sides.
  void look_at(std::size_t t) {
    const std::uint32_t behind = cells_.behind[t], in_front = cells_.in_front[t];
    const KeptFacet& kept = merged_.facet_of_triangle[t];
    if (!kept.is_wall) {
      is_inside_[behind] = 1;
      return;
    }
    is_inside_[behind] = is_inside_[in_front] = 1;
    for (const FacetSource& s : facets_.sources_of(kept.facet)) {
      if (faces_.is_wall[s.face] == 0 || faces_.operand[s.face] == OperandId(0)) continue;
      const bool runs_along = s.is_opposite == kept.is_flipped;
      seen_[{runs_along ? behind : in_front, faces_.operand[s.face]}].back = true;
      seen_[{runs_along ? in_front : behind, faces_.operand[s.face]}].front = true;
    }
  }

  // Answers which triangles stay.
  std::vector<std::uint8_t> drop_cells() {
    std::vector<std::uint8_t> is_kept(cells_.behind.size(), 0);
    for (std::size_t t = 0; t < is_kept.size(); ++t) {
      const bool is_inside_behind = is_inside_[cells_.behind[t]] != 0, is_inside_in_front = is_inside_[cells_.in_front[t]] != 0;
      is_kept[t] = is_inside_behind != is_inside_in_front ? 1 : 0;
      if (is_kept[t] != 0 && is_inside_in_front) turn_facet_over(t);
      merged_.facet_of_triangle[t].is_wall = false;
    }
    merged_.mesh.walls.clear();
    merged_.provenance.covering_front.clear();
    keep_triangles(is_kept, merged_);
    return is_kept;
  }

  void turn_facet_over(std::size_t t) {
    turn_over(FaceId(t), merged_.mesh);
    KeptFacet& kept = merged_.facet_of_triangle[t];
    kept.is_flipped = !kept.is_flipped;
    std::swap(kept.inside, kept.outside);
    merged_.provenance.flipped[t] = kept.is_flipped ? 1 : 0;
    merged_.provenance.covering[t] = merged_.provenance.covering_front[t];
  }

  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<OperandId> ending;
    for (const auto& [place, seen] : seen_) {
      if (seen.back && seen.front) ending.push_back(place.second);
    }
    std::sort(ending.begin(), ending.end());
    ending.erase(std::unique(ending.begin(), ending.end()), ending.end());
    std::vector<std::string> notes;
    for (const OperandId k : ending) {
      notes.push_back("sheet operand " + std::to_string(k.value) + " ends inside the solid: what it does not separate stays whole");
    }
    return notes;
  }

  const OperandFaces& faces_;
  const Facets& facets_;
  MergedMesh& merged_;
  MeshCells cells_;
  std::vector<std::uint8_t> is_inside_;                       // per cell
  std::map<std::pair<std::uint32_t, OperandId>, Seen> seen_;  // per cell and sheet
};

}  // namespace

std::vector<std::string> cut_by_sheets(const OperandFaces& faces, const Facets& facets, MergedMesh& merged,
                                       std::vector<std::uint32_t>& failed_faces) {
  return SheetCut(faces, facets, merged).run(failed_faces);
}

}  // namespace mortise
