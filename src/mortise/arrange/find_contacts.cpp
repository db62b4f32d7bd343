// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Broad phase over box trees, narrow phase over exact signs.
#include "mortise/arrange/find_contacts.h"

#include <algorithm>
#include <string>

#include "mortise/base/sort_in_buckets.h"
#include "mortise/exact/predicates.h"
#include "mortise/geom/box_tree.h"

namespace mortise {
namespace {

constexpr const char* stage_name = "find_contacts";

struct Pair {
  std::uint32_t a, b;  // a < b
};

// Counts before it stores: n^2 pairs are legal, running out of memory is not.
class PairList {
 public:
  explicit PairList(std::uint64_t memory) : most_pairs_(memory / bytes_per_pair) {}

  void add(std::uint32_t a, std::uint32_t b) {
    ++count_;
    if (count_ <= most_pairs_) pairs_.push_back({std::min(a, b), std::max(a, b)});
  }
  [[nodiscard]] std::vector<Pair> take(std::size_t face_count) && {
    if (count_ > most_pairs_) {
      throw Error(ErrorCode::ResultTooLarge, stage_name,
                  std::to_string(count_) + " pairs of faces may touch; they need " + std::to_string(count_ * bytes_per_pair) + " bytes");
    }
    const auto first_face = [](const Pair& p) { return p.a; };
    return sorted_in_buckets(pairs_, face_count, first_face, [](const Pair& p, const Pair& q) { return p.b < q.b; });
  }

 private:
  static constexpr std::uint64_t bytes_per_pair = 2 * sizeof(Pair);  // sorting takes as much again

  std::uint64_t most_pairs_;
  std::uint64_t count_ = 0;
  std::vector<Pair> pairs_;
};

// The faces of one operand that may touch anything, and a tree of their boxes.
class Reach {
 public:
  /// Faces in any order, and their boxes.
  Reach(std::vector<SourceId> faces, const std::vector<Box3>& boxes) : faces_(std::move(faces)), own_(boxes) {}
  /// All faces from the first on.
  Reach(std::uint32_t first, BoxTree tree) : first_(first), own_(std::move(tree)) {}
  Reach(std::uint32_t first, const BoxTree* kept) : first_(first), kept_(kept) {}

  [[nodiscard]] const BoxTree& tree() const { return kept_ != nullptr ? *kept_ : own_; }
  [[nodiscard]] SourceId face(std::uint32_t item) const { return faces_.empty() ? SourceId(first_ + item) : faces_[item]; }

 private:
  std::vector<SourceId> faces_;  // of the items; empty: they are in order
  std::uint32_t first_ = 0;
  BoxTree own_;
  const BoxTree* kept_ = nullptr;
};

// Where an operand can meet the others: the box round all meetings of its bounds with theirs.
Box3 meeting_box(const OperandFaces& faces, OperandId k) {
  Box3 result;
  const Box3& own = faces.bounds[k];
  for (std::size_t m = 0; m < faces.operand_count(); ++m) {
    const Box3& other = faces.bounds[OperandId(m)];
    if (m == k.index() || !boxes_meet(own, other)) continue;
    Box3 common;
    for (std::size_t i = 0; i < 3; ++i) {
      common.lo[i] = std::max(own.lo[i], other.lo[i]);
      common.hi[i] = std::min(own.hi[i], other.hi[i]);
    }
    result.extend(common);
  }
  return result;
}

// Are all pairs of faces of this operand known that may touch?
bool has_known_self_pairs(const OperandFaces& faces, OperandId k) {
  const KnownOperand& known = faces.known[k];
  if (known.prepared == nullptr) return false;
  const SelfPairs& pairs = known.prepared->self_pairs();
  return pairs.is_known && known.rounding <= pairs.slack;
}

Reach collect_reach(const OperandFaces& faces, OperandId k, const Box3& meeting) {
  std::vector<SourceId> reached;
  std::vector<Box3> boxes;
  for (std::uint32_t f = faces.first[k]; f < faces.end(k); ++f) {
    const Box3 box = faces.box(SourceId(f));
    if (!boxes_meet(box, meeting)) continue;
    reached.push_back(SourceId(f));
    boxes.push_back(box);
  }
  return Reach(std::move(reached), boxes);
}

Reach find_reach(const OperandFaces& faces, OperandId k, bool is_complete) {
  const Box3 meeting = is_complete ? faces.bounds[k] : meeting_box(faces, k);
  const KnownOperand& known = faces.known[k];
  if (known.prepared == nullptr) return collect_reach(faces, k, meeting);
  const BoxTree& tree = known.prepared->tree();
  if (known.is_in_place) return Reach(faces.first[k], &tree);
  const auto may_meet = [&](const Box3& box) { return boxes_meet(known.boxes.image_of(box), meeting); };
  const auto box_of_item = [&](std::uint32_t item) {
    const Box3 box = faces.box(SourceId(faces.first[k] + item));
    return boxes_meet(box, meeting) ? box : Box3{};
  };
  return Reach(faces.first[k], tree.with_boxes(may_meet, box_of_item));
}

void add_pairs_between(const Reach& a, const Reach& b, PairList& pairs) {
  for_each_meeting_pair(a.tree(), b.tree(), [&](std::uint32_t i, std::uint32_t j) { pairs.add(a.face(i).value, b.face(j).value); });
}

void add_pairs_within(const OperandFaces& faces, OperandId k, const Reach& reach, PairList& pairs) {
  const SelfContacts kind = faces.self_contacts[k];
  if (kind == SelfContacts::All || kind == SelfContacts::Parts) {
    for_each_meeting_pair_within(reach.tree(), [&](std::uint32_t i, std::uint32_t j) {
      const SourceId f = reach.face(i);
      const SourceId g = reach.face(j);
      if (kind == SelfContacts::All || faces.part[f] != faces.part[g]) pairs.add(f.value, g.value);
    });
  }
  if (kind == SelfContacts::All) return;
  for (SourceId f(faces.first[k]); f.value < faces.end(k); ++f.value) {
    if (faces.shape[f] != FaceShape::Collinear) continue;
    reach.tree().for_each_meeting(faces.box(f), [&](std::uint32_t j) {
      if (faces.shape[reach.face(j)] == FaceShape::Proper) pairs.add(f.value, reach.face(j).value);
    });
  }
}

// The same out of the pairs that are known.
void add_known_pairs_within(const OperandFaces& faces, OperandId k, PairList& pairs) {
  const SelfContacts kind = faces.self_contacts[k];
  const auto is_collinear_beside_proper = [&](SourceId f, SourceId g) {
    return faces.shape[f] == FaceShape::Collinear && faces.shape[g] == FaceShape::Proper;
  };
  for (const auto& [i, j] : faces.known[k].prepared->self_pairs().pairs) {
    const SourceId f(faces.first[k] + i), g(faces.first[k] + j);
    if (!boxes_meet(faces.box(f), faces.box(g))) continue;
    const bool is_between_parts = kind == SelfContacts::Parts && faces.part[f] != faces.part[g];
    if (kind == SelfContacts::All || is_between_parts || is_collinear_beside_proper(f, g) || is_collinear_beside_proper(g, f)) {
      pairs.add(f.value, g.value);
    }
  }
}

std::vector<Pair> find_candidates(const OperandFaces& faces, std::uint64_t memory, const ProgressCallback& progress) {
  PairList pairs(memory);
  const std::size_t n = faces.operand_count();
  std::vector<Reach> reach;
  for (std::size_t i = 0; i < n; ++i) {
    const OperandId k(i);
    const bool needs_self_pairs = faces.self_contacts[k] != SelfContacts::None;
    const bool knows_self_pairs = needs_self_pairs && has_known_self_pairs(faces, k);
    reach.push_back(find_reach(faces, k, needs_self_pairs && !knows_self_pairs));
    if (knows_self_pairs) {
      add_known_pairs_within(faces, k, pairs);
    } else if (needs_self_pairs) {
      add_pairs_within(faces, k, reach.back(), pairs);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    report_progress(progress, stage_name, 0.1 * static_cast<double>(i) / static_cast<double>(n));
    const OperandId k(i);
    for (std::size_t j = i + 1; j < n; ++j) {
      const OperandId m(j);
      if (boxes_meet(faces.bounds[k], faces.bounds[m])) add_pairs_between(reach[i], reach[j], pairs);
    }
  }
  return std::move(pairs).take(faces.corners.size());
}

bool are_shared_corners(const Incidence& i) { return i.on_a.kind == Feature::Kind::Corner && i.on_b.kind == Feature::Kind::Corner; }

// Faces of one operand that meet only in corners they share, or in the edge between two of them, are neighbours.
bool is_adjacency(const PairClassification& pair) {
  return pair.contact == PairContact::Touching && std::all_of(pair.incidences.begin(), pair.incidences.end(), are_shared_corners);
}

void add_stray_points(const OperandFaces& faces, SourceId collinear, SourceId face, std::vector<StrayPoint>& stray_points) {
  const TriangleCorners t = corners_of(faces, face);
  const std::optional<Axis> axis = projection_axis(t.position[0], t.position[1], t.position[2]);
  for (const PointId p : faces.corners[collinear]) {
    if (std::find(t.id.begin(), t.id.end(), p.value) != t.id.end()) continue;
    const Vec3d& position = faces.points.nearest(p);
    Feature feature;
    if (orient3d(t.position[0], t.position[1], t.position[2], position) != Sign::Zero) continue;
    if (locate_in_plane(t, *axis, position, feature)) stray_points.push_back({p, face, feature});
  }
}

// The narrow phase of one candidate pair.
void classify_candidate(const OperandFaces& faces, const Pair& pair, PairClassification& scratch, Contacts& contacts) {
  const SourceId a(pair.a);
  const SourceId b(pair.b);
  const FaceShape shape_a = faces.shape[a];
  const FaceShape shape_b = faces.shape[b];
  const bool same_operand = faces.operand[a] == faces.operand[b];
  if (shape_a != FaceShape::Proper || shape_b != FaceShape::Proper) {
    if (same_operand && shape_a == FaceShape::Collinear && shape_b == FaceShape::Proper)
      add_stray_points(faces, a, b, contacts.stray_points);
    if (same_operand && shape_b == FaceShape::Collinear && shape_a == FaceShape::Proper)
      add_stray_points(faces, b, a, contacts.stray_points);
    return;
  }
  classify_pair(corners_of(faces, a), corners_of(faces, b), scratch);
  if (scratch.contact == PairContact::None || (same_operand && is_adjacency(scratch))) return;
  MORTISE_CHECK(scratch.contact == PairContact::Overlap || scratch.incidences.size() <= 2,
                "faces " + std::to_string(pair.a) + " and " + std::to_string(pair.b));
  contacts.contacts.push_back({a, b, scratch.contact, static_cast<std::uint32_t>(contacts.incidences.size()),
                               static_cast<std::uint32_t>(scratch.incidences.size())});
  contacts.incidences.insert(contacts.incidences.end(), scratch.incidences.begin(), scratch.incidences.end());
}

}  // namespace

TriangleCorners corners_of(const OperandFaces& faces, SourceId f) {
  TriangleCorners t{};
  for (std::size_t i = 0; i < 3; ++i) {
    t.id[i] = faces.corners[f][i].value;
    t.position[i] = faces.corner_position(f, i);
  }
  return t;
}

bool meet_beyond_shared(const OperandFaces& faces, SourceId f, SourceId g) {
  PairClassification pair;
  classify_pair(corners_of(faces, f), corners_of(faces, g), pair);
  return pair.contact != PairContact::None && !is_adjacency(pair);
}

Contacts find_contacts(const OperandFaces& faces, std::uint64_t memory, const ProgressCallback& progress) {
  const std::vector<Pair> candidates = find_candidates(faces, memory, progress);
  Contacts contacts;
  contacts.candidate_pairs = candidates.size();
  PairClassification scratch;
  constexpr std::size_t pairs_per_report = 65536;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i % pairs_per_report == 0) {
      report_progress(progress, stage_name, 0.1 + 0.2 * static_cast<double>(i) / static_cast<double>(candidates.size()));
    }
    classify_candidate(faces, candidates[i], scratch, contacts);
  }
  return contacts;
}

}  // namespace mortise
