// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Tags by name, and the faces that have them: taken from all cut faces after these are rounded and certified together.
#include "mortise/boolean/keep_faces.h"

#include <array>
#include <string_view>

#include "mortise/base/error.h"
#include "mortise/boolean/evaluate_selection.h"
#include "mortise/boolean/exact_places.h"
#include "mortise/boolean/keep_triangles.h"

namespace mortise {
namespace {

constexpr const char* stage_name = "keep_faces";
constexpr std::array<std::string_view, 6> tag_names{"10", "11", "20", "21", "same", "opposite"};  // by place of the bit

KeepTag tag_of(FacetCategory category, bool is_of_first) {
  switch (category) {
    case FacetCategory::Outside:
      return is_of_first ? KeepTag::FirstOutside : KeepTag::OtherOutside;
    case FacetCategory::Inside:
      return is_of_first ? KeepTag::FirstInside : KeepTag::OtherInside;
    case FacetCategory::OnSame:
      return KeepTag::OnSame;
    default:
      return KeepTag::OnOpposite;
  }
}

std::vector<std::uint8_t> triangles_in(KeepMask mask, const Provenance& provenance) {
  std::vector<std::uint8_t> is_kept;
  for (std::size_t t = 0; t < provenance.category.size(); ++t) {
    const KeepTag tag = tag_of(provenance.category[t], provenance.source_operand[t] == 0);
    is_kept.push_back((mask & static_cast<unsigned>(tag)) != 0 ? 1 : 0);
  }
  return is_kept;
}

}  // namespace

KeepMask keep_mask(std::span<const std::string> names) {
  unsigned mask = 0;
  for (const std::string& name : names) {
    std::size_t place = 0;
    while (place < tag_names.size() && tag_names[place] != name) ++place;
    if (place == tag_names.size()) {
      throw Error(ErrorCode::InvalidArgument, stage_name, "no tag is called '" + name + "': they are 10, 11, 20, 21, same, opposite");
    }
    mask |= 1U << place;
  }
  return static_cast<KeepMask>(mask);
}

BooleanResult keep_faces(KeepMask mask, const OperandList& operands, const BooleanOptions& options) {
  if (mask >= 1U << tag_names.size()) throw Error(ErrorCode::InvalidArgument, stage_name, "a mask has six bits");
  BooleanResult result = evaluate_selection(stage_name, select_cut_faces, operands, options);
  const std::vector<std::uint8_t> is_kept = triangles_in(mask, result.provenance);
  const std::vector<std::uint8_t> is_kept_vertex = keep_triangles(is_kept, result.mesh, result.provenance);
  result.provenance.covering_front.clear();
  result.mesh.walls.clear();
  Certificate& certificate = result.report.certificate;
  certificate.failed_faces = renumbered(certificate.failed_faces, is_kept);
  certificate.exact_places = renumbered(certificate.exact_places, is_kept_vertex);
  return result;
}

}  // namespace mortise
