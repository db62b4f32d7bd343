// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// All operands of one call as faces over one set of points: what every later stage reads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/arrange/operand_list.h"
#include "mortise/arrange/placed_boxes.h"
#include "mortise/base/ids.h"
#include "mortise/exact/point_set.h"
#include "mortise/geom/vec.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// A face of any operand, in one running numbering: operand after operand, face after face.
using SourceId = Id<struct SourceTag>;

enum class FaceShape : std::uint8_t {
  Proper,     ///< has area
  Collinear,  ///< three different points on one line: gives its points to the edges it touches, and is dropped
  Repeated,   ///< names one point twice: dropped
};

/// Which contacts of an operand with itself are searched (exact-core: self pairs).
enum class SelfContacts : std::uint8_t {
  None,       ///< a clean operand: closed, no face without area or twice
  Collinear,  ///< only those of its faces without area
  Parts,      ///< also those between parts (connected through vertices) whose boxes meet
  All,        ///< open edges, coincident faces, crossings that a former pass came upon, or the only operand of a call
};

/// What bounds space, and what only divides it (exact-core 4).
enum class OperandKind : std::uint8_t {
  Solid,           ///< every face separates inside from outside
  SolidWithWalls,  ///< some faces lie inside or outside: between regions of one operand, or sheets attached to it
  Sheet,           ///< no face bounds anything
  HalfSpace,       ///< a solid that stands for all behind a plane: its vertices are not part of it
};

/// A prepared operand of which all that is known but for boxes holds where it is now.
struct KnownOperand {
  const PreparedOperand* prepared = nullptr;  ///< null for a plain mesh, and where rounding has made different positions equal
  bool is_in_place = false;                   ///< also the boxes hold
  double rounding = 0;                        ///< how far its points are beside their exact images, seen in its mesh
  PlacedBoxes boxes;                          ///< from where it was prepared to where it is
};

[[nodiscard]] inline bool has_walls(OperandKind kind) { return kind == OperandKind::SolidWithWalls || kind == OperandKind::Sheet; }

struct OperandFaces {
  PointSet points;
  IdVector<SourceId, PlanePoints> corners;
  IdVector<SourceId, FaceShape> shape;
  IdVector<SourceId, OperandId> operand;
  IdVector<SourceId, std::uint8_t> is_wall;  ///< 1: crossing the face changes no winding
  IdVector<OperandId, std::uint32_t> first;  ///< operand count + 1 entries: its faces are first[k] .. first[k + 1] - 1
  IdVector<OperandId, SelfContacts> self_contacts;
  IdVector<OperandId, OperandKind> kind;
  IdVector<OperandId, Box3> bounds;
  IdVector<OperandId, KnownOperand> known;
  IdVector<SourceId, std::uint32_t> part;  ///< faces of one operand with the same number are connected through vertices
  IdVector<OperandId, std::vector<PointId>> point_of_vertex;

  [[nodiscard]] std::size_t operand_count() const { return self_contacts.size(); }
  [[nodiscard]] std::uint32_t face_in_operand(SourceId f) const { return f.value - first[operand[f]]; }
  [[nodiscard]] std::uint32_t end(OperandId k) const { return first[OperandId(k.index() + 1)]; }
  [[nodiscard]] Box3 box(SourceId f) const;
  [[nodiscard]] const Vec3d& corner_position(SourceId f, std::size_t i) const { return points.nearest(corners[f][i]); }
};

/// Welds equal positions of all operands, sorts out faces without area, and finds who is closed (exact-core 2). Of prepared
/// operands only what rounding may have changed is looked at again. Refers to these.
///
/// @throws Error{NotFinite, BadIndex}
/// O(n) in the faces.
[[nodiscard]] OperandFaces gather_operands(const OperandList& operands);

/// Calls visit(face) for all faces of an operand whose boxes meet a box, in any order.
template <class Visit>
void for_each_face_meeting(const Box3& box, const OperandFaces& faces, OperandId k, Visit visit) {
  const auto visit_if_meeting = [&](SourceId f) {
    if (boxes_meet(faces.box(f), box)) visit(f);
  };
  const KnownOperand& known = faces.known[k];
  if (known.prepared == nullptr) {
    for (SourceId f(faces.first[k]); f.value < faces.end(k); ++f.value) visit_if_meeting(f);
    return;
  }
  const auto may_meet = [&](const Box3& node) { return boxes_meet(known.is_in_place ? node : known.boxes.image_of(node), box); };
  const BoxTree& tree = known.prepared->tree();
  tree.for_each_leaf_below(may_meet, [&](std::uint32_t leaf) {
    for (const BoxTree::Item& item : tree.items_of(tree.nodes()[leaf])) visit_if_meeting(SourceId(faces.first[k] + item.id));
  });
}

/// From now on all faces of the operand are walls.
void make_sheet(OperandId k, OperandFaces& faces);

}  // namespace mortise
