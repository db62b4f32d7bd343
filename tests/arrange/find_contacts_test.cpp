// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Which faces touch: against all pairs one by one, within operands, at faces without area, and at the limits of a call.
#include "mortise/arrange/find_contacts.h"

#include <algorithm>
#include <map>
#include <set>

#include "mortise/mesh/shapes.h"
#include "support/arrangement.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

constexpr std::uint64_t plenty = std::uint64_t{1} << 31;
const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});

Contacts contacts_of(const std::vector<SurfaceMesh>& operands, const std::vector<std::size_t>& self = {}) {
  return find_contacts(gather(operands, self), plenty, {});
}

struct PairKey {
  std::uint32_t a, b;
  PairContact kind;
  std::vector<Incidence> incidences;

  bool operator==(const PairKey&) const = default;
};

std::vector<PairKey> pairs_of(const Contacts& contacts) {
  std::vector<PairKey> result;
  for (const Contact& c : contacts.contacts) {
    const auto incidences = contacts.incidences_of(c);
    result.push_back({c.face_a.value, c.face_b.value, c.kind, {incidences.begin(), incidences.end()}});
  }
  return result;
}

/// Every pair of proper faces of different operands, one by one.
std::vector<PairKey> all_pairs(const OperandFaces& faces) {
  std::vector<PairKey> result;
  PairClassification pair;
  for (std::uint32_t a = 0; a < faces.corners.size(); ++a) {
    for (std::uint32_t b = a + 1; b < faces.corners.size(); ++b) {
      if (faces.operand[SourceId(a)] == faces.operand[SourceId(b)]) continue;
      classify_pair(corners_of(faces, SourceId(a)), corners_of(faces, SourceId(b)), pair);
      if (pair.contact != PairContact::None) result.push_back({a, b, pair.contact, pair.incidences});
    }
  }
  return result;
}

std::set<std::array<std::uint32_t, 2>> touching_faces(const Contacts& contacts) {
  std::set<std::array<std::uint32_t, 2>> result;
  for (const Contact& c : contacts.contacts) result.insert({c.face_a.value, c.face_b.value});
  return result;
}

}  // namespace

TEST_CASE("contacts of the small scenes are those of all pairs one by one, sorted, each once") {
  std::size_t found = 0;
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const OperandFaces faces = gather(scene.operands);
    const Contacts contacts = find_contacts(faces, plenty, {});
    CHECK(pairs_of(contacts) == all_pairs(faces));
    CHECK(contacts.candidate_pairs >= contacts.contacts.size());
    CHECK(contacts.stray_points.empty());
    found += contacts.contacts.size();
  }
  CHECK(found > 1000);
}

TEST_CASE("shapes of many faces touch as all pairs one by one do") {
  const std::vector<SurfaceMesh> shapes{make_icosphere(1, 2), moved(make_torus(1, 0.25, 16, 8), {0.5, 0.25, 0.125}),
                                        make_cylinder(0.5, 2, 20)};
  const OperandFaces faces = gather(shapes);
  const std::vector<PairKey> expected = all_pairs(faces);
  CHECK(expected.size() > 150);
  CHECK(pairs_of(find_contacts(faces, plenty, {})) == expected);
}

TEST_CASE("operands apart are no candidates; boxes that meet are candidates without contact") {
  CHECK(contacts_of({unit, moved(unit, {3, 0, 0})}).candidate_pairs == 0);
  const Contacts near = contacts_of({unit, tetrahedron({0.9, 0.9, 0.9}, {0.95, 0.9, 0.9}, {0.9, 0.95, 0.9}, {0.9, 0.9, 0.95})});
  CHECK(near.contacts.empty());
  const Contacts nested = contacts_of({tetrahedron({0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}), box({1, 1, 1}, {2, 2, 2})});
  CHECK(nested.contacts.empty());
  CHECK(nested.candidate_pairs == 12);  // the box of the slanted face holds the whole inner box
}

TEST_CASE("the order of operands changes the numbers of contacts, not the contacts") {
  const std::vector<SurfaceMesh> parts{unit, moved(unit, {0.5, 0.25, 0}), octahedron({1, 0.5, 0.5}, 0.375)};
  const auto forward = touching_faces(contacts_of(parts)), backward = touching_faces(contacts_of({parts[2], parts[1], parts[0]}));
  CHECK(forward.size() > 10);
  std::set<std::array<std::uint32_t, 2>> renumbered;
  for (const auto& [a, b] : backward) {
    const auto number = [](std::uint32_t f) { return f < 8 ? f + 24 : f < 20 ? f + 4 : f - 20; };
    renumbered.insert({std::min(number(a), number(b)), std::max(number(a), number(b))});
  }
  CHECK(forward == renumbered);
}

// ---- faces of one operand ------------------------------------------------------------------------------------------------

TEST_CASE("neighbours of one operand are no contacts") {
  CHECK(contacts_of({unit}, {0}).contacts.empty());
  CHECK(contacts_of({make_grid_sheet(4, 4, 4, 4)}, {0}).contacts.empty());
  CHECK(contacts_of({joined({unit, moved(unit, {1, 1, 0})})}, {0}).contacts.empty());  // they share an edge of four faces
  CHECK(contacts_of({joined({unit, moved(unit, {1, 1, 1})})}, {0}).contacts.empty());  // and here a corner
}

TEST_CASE("without a reason the contacts of an operand with itself are not searched") {
  const SurfaceMesh far = moved(unit, {9, 9, 9});
  CHECK(contacts_of({unit, far}).candidate_pairs == 0);
  CHECK(contacts_of({unit, far}, {0}).candidate_pairs > 0);
  // Parts are searched against each other, but not within themselves: both boxes have twelve faces.
  const Contacts parts = contacts_of({joined({unit, moved(unit, {0.5, 0.5, 0.5})}), far});
  CHECK(touching_faces(parts) == touching_faces(contacts_of({unit, moved(unit, {0.5, 0.5, 0.5})})));
  CHECK(parts.candidate_pairs == contacts_of({unit, moved(unit, {0.5, 0.5, 0.5})}).candidate_pairs);
}

TEST_CASE("faces of one operand that share a corner and cross are a contact") {
  const SurfaceMesh crossing = make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 1, 1}, {2, 1, -1}}, {{0, 1, 2}, {0, 3, 4}});
  const Contacts contacts = contacts_of({crossing});  // open: its self contacts are searched anyway
  REQUIRE(contacts.contacts.size() == 1);
  CHECK(contacts.contacts[0].kind == PairContact::Touching);
  CHECK(contacts.incidences.size() == 2);
  // The same two faces apart but for the corner.
  CHECK(contacts_of({make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 1, 3}, {2, 1, 1}}, {{0, 1, 2}, {0, 3, 4}})}).contacts.empty());
}

TEST_CASE("faces of one operand folded onto each other along their edge overlap") {
  const Contacts contacts = contacts_of({make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {2, 2, 0}}, {{0, 1, 2}, {1, 0, 3}})});
  REQUIRE(contacts.contacts.size() == 1);
  CHECK(contacts.contacts[0].kind == PairContact::Overlap);
  // Unfolded they are neighbours.
  CHECK(contacts_of({make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {2, -2, 0}}, {{0, 1, 2}, {1, 0, 3}})}).contacts.empty());
}

TEST_CASE("edges of one operand that lie on each other without a shared corner are a contact") {
  const Contacts contacts =
      contacts_of({make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {1, 0, 0}, {3, 0, 0}, {2, -2, 0}}, {{0, 1, 2}, {4, 3, 5}})});
  REQUIRE(contacts.contacts.size() == 1);
  CHECK(contacts.contacts[0].kind == PairContact::Touching);
  CHECK(contacts.incidences.size() == 2);
}

TEST_CASE("coincident faces of one operand overlap") {
  const Contacts contacts = contacts_of({joined({unit, unit})});
  const auto overlaps =
      std::count_if(contacts.contacts.begin(), contacts.contacts.end(), [](const Contact& c) { return c.kind == PairContact::Overlap; });
  CHECK(overlaps == 12);
}

// ---- faces without area --------------------------------------------------------------------------------------------------

namespace {

/// Two faces, and a face without area whose middle point lies at `middle`.
SurfaceMesh with_stray(const Vec3d& middle) {
  // Along the line through the middle, from 1 before to 1 behind.
  const Vec3d step{0.5, 0, 0};
  return make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, -4, 0}, middle - step, middle, middle + step}, {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}});
}

}  // namespace

TEST_CASE("corners of a face without area are strays on the edges and faces of their operand") {
  const Contacts on_edge = contacts_of({with_stray({2, 0, 0})});
  CHECK(on_edge.contacts.empty());
  REQUIRE(on_edge.stray_points.size() == 6);  // three points, each on the common edge of two faces
  for (const StrayPoint& s : on_edge.stray_points) CHECK(s.feature == Feature{Feature::Kind::Edge, 0});
  const Contacts on_face = contacts_of({with_stray({1, 1, 0})});
  REQUIRE(on_face.stray_points.size() == 3);
  for (const StrayPoint& s : on_face.stray_points) {
    CHECK(s.feature.kind == Feature::Kind::Inside);
    CHECK(s.face == SourceId(std::size_t{0}));
  }
  CHECK(contacts_of({with_stray({1, 1, 0.0625})}).stray_points.empty());
  // Only the middle and the end behind it lie in the face.
  CHECK(contacts_of({with_stray({0.25, 2, 0})}).stray_points.size() == 2);
}

TEST_CASE("a corner that a face has already is no stray") {
  const Contacts contacts = contacts_of({make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 3, 1}})});
  REQUIRE(contacts.stray_points.size() == 1);
  CHECK(contacts.stray_points[0].feature == Feature{Feature::Kind::Edge, 0});
}

TEST_CASE("faces without area touch no face of another operand, faces with a corner twice touch nothing") {
  SurfaceMesh needle = make_mesh({{0.25, 0.25, -1}, {0.25, 0.25, 0.5}, {0.25, 0.25, 3}}, {{0, 1, 2}});
  CHECK(contacts_of({unit, needle}).contacts.empty());
  CHECK(contacts_of({unit, needle}).stray_points.empty());
  SurfaceMesh repeated = unit;
  repeated.points.push_back({0.5, 0.5, 0});
  repeated.triangles.push_back({VertexId(0), VertexId(8), VertexId(8)});
  CHECK(contacts_of({repeated}, {0}).stray_points.empty());
  CHECK(contacts_of({repeated}, {0}).contacts.empty());
}

// ---- limits --------------------------------------------------------------------------------------------------------------

TEST_CASE("more pairs than the memory holds are refused with their number and bytes, before they are stored") {
  const OperandFaces faces = gather({unit, moved(unit, {0.5, 0.25, 0.125})});
  const std::uint64_t pairs = find_contacts(faces, plenty, {}).candidate_pairs;
  const std::uint64_t bytes = 16 * pairs;
  CHECK(find_contacts(faces, bytes, {}).candidate_pairs == pairs);
  for (const std::uint64_t memory : {bytes - 1, std::uint64_t{0}}) {
    const auto error = error_of([&] { (void)find_contacts(faces, memory, {}); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::ResultTooLarge);
    CHECK(error->stage == "find_contacts");
    CHECK(error->message.find(std::to_string(pairs) + " pairs") != std::string::npos);
    CHECK(error->message.find(std::to_string(bytes) + " bytes") != std::string::npos);
  }
}

TEST_CASE("a square number of pairs is counted without being stored") {
  // n needles through n needles: 2 n faces each, all pairs of boxes meet.
  SurfaceMesh along_x, along_y;
  for (int i = 0; i < 300; ++i) {
    along_x = joined({along_x, make_mesh({{-1, i * 1e-6, -1}, {1, i * 1e-6, -1}, {0, i * 1e-6, 1}}, {{0, 1, 2}})});
    along_y = joined({along_y, make_mesh({{i * 1e-6, -1, -1}, {i * 1e-6, 1, -1}, {i * 1e-6, 0, 1}}, {{0, 1, 2}})});
  }
  OperandFaces faces = gather({along_x, along_y});
  faces.self_contacts[OperandId(std::size_t{0})] = faces.self_contacts[OperandId(std::size_t{1})] = SelfContacts::None;
  const auto error = error_of([&] { (void)find_contacts(faces, 1 << 16, {}); });
  REQUIRE(error);
  CHECK(error->message.find("90000 pairs") != std::string::npos);
}

TEST_CASE("contacts can be cancelled at every report") {
  const OperandFaces faces = gather({unit, moved(unit, {0.5, 0, 0}), moved(unit, {0, 0.5, 0})});
  int calls = 0;
  const auto count = [&](std::string_view stage, double fraction) {
    CHECK(stage == "find_contacts");
    CHECK((fraction >= 0 && fraction <= 1));
    ++calls;
    return true;
  };
  const auto pairs = pairs_of(find_contacts(faces, plenty, count));
  REQUIRE(calls >= 4);  // one per operand, one per block of pairs
  for (int n = 1; n <= calls; ++n) {
    int left = n;
    const auto error = error_of([&] { (void)find_contacts(faces, plenty, [&](std::string_view, double) { return --left > 0; }); });
    REQUIRE(error);
    CHECK(error->code == ErrorCode::Cancelled);
    CHECK(left == 0);
  }
  CHECK(pairs_of(find_contacts(faces, plenty, {})) == pairs);
}
