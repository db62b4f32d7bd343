// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Reports as JavaScript objects.
#include "report.h"

#include <algorithm>
#include <string>
#include <vector>

#include "arrays.h"
#include "mortise/base/numbers.h"
#include "mortise/base/stopwatch.h"
#include "mortise/mesh/inspect.h"
#include "mortise/mesh/weld.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

// JavaScript has no integers of 64 bits without BigInt; counts stay far below 2^53.
val count_out(std::uint64_t count) { return val(static_cast<double>(count)); }

val corner_out(const Vec3d& p) {
  val array = val::array();
  for (std::size_t i = 0; i < 3; ++i) array.call<void>("push", p[i]);
  return array;
}

val box_out(const Box3& box) {
  if (box.is_empty()) return val::null();
  val object = val::object();
  object.set("min", corner_out(box.lo));
  object.set("max", corner_out(box.hi));
  return object;
}

val angle_out(const MeshReport& report, double degrees) { return report.triangles == 0 ? val::null() : val(degrees); }

/// The fields a mesh has by itself.
val mesh_report_out(const MeshReport& report, Search search) {
  val object = val::object();
  object.set("vertices", count_out(report.vertices));
  object.set("triangles", count_out(report.triangles));
  object.set("closed", report.closed);
  object.set("oriented", report.oriented);
  object.set("manifold", report.manifold);
  object.set("boundaryEdges", count_out(report.boundary_edges));
  object.set("nonManifoldEdges", count_out(report.non_manifold_edges));
  object.set("components", count_out(report.components));
  object.set("genus", report.genus ? val(static_cast<double>(*report.genus)) : val::null());
  object.set("volume", report.volume ? val(*report.volume) : val::null());
  object.set("area", report.area);
  object.set("bbox", box_out(report.bbox));
  object.set("minAngleDeg", angle_out(report, report.min_angle_deg));
  object.set("maxAngleDeg", angle_out(report, report.max_angle_deg));
  object.set("selfIntersections", search == Search::Nothing ? val::null() : count_out(report.self_intersections));
  return object;
}

val stage_out(const StageTime& time) {
  val object = val::object();
  object.set("stage", time.stage);
  object.set("milliseconds", time.milliseconds);
  return object;
}

template <class Item, class Convert>
val list_out(const std::vector<Item>& items, Convert convert) {
  val array = val::array();
  for (const Item& item : items) array.call<void>("push", convert(item));
  return array;
}

val graph_counts_out(const IntersectionGraph& graph) {
  val object = val::object();
  object.set("vertices", count_out(graph.points.size()));
  object.set("edges", count_out(graph.edges.size()));
  object.set("closedLoops", graph.closed_loops);
  object.set("openChains", graph.open_chains);
  return object;
}

val contact_out(const ContactMeasure& contact) {
  val object = val::object();
  object.set("points", count_out(contact.points));
  object.set("length", contact.length);
  object.set("area", contact.area);
  return object;
}

val operands_out(std::span<const SurfaceMesh* const> operands, std::span<const std::size_t> half_spaces, const BooleanReport& report) {
  val array = val::array();
  auto sheet = report.sheets.begin();
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    val object = val::object();
    object.set("vertices", count_out(operands[k]->points.size()));
    object.set("triangles", count_out(operands[k]->triangles.size()));
    object.set("selfContacts", std::binary_search(report.self_contacts.begin(), report.self_contacts.end(), k));
    const bool is_sheet = sheet != report.sheets.end() && sheet->operand == k;
    const bool is_half_space = std::find(half_spaces.begin(), half_spaces.end(), k) != half_spaces.end();
    object.set("kind", is_sheet ? "sheet" : is_half_space ? "halfSpace" : "solid");
    if (is_sheet) object.set("openEdges", copy_out((sheet++)->open_edges));
    array.call<void>("push", object);
  }
  return array;
}

void note_if(std::vector<std::string>& notes, std::uint64_t count, const std::string& what) {
  if (count != 0) notes.push_back(std::to_string(count) + " " + what);
}

std::vector<std::string> mesh_notes(const MeshReport& report) {
  std::vector<std::string> notes;
  note_if(notes, report.crossing_pairs, "pairs of triangles cross");
  note_if(notes, report.overlapping_pairs, "pairs of triangles overlap in one plane");
  note_if(notes, report.touching_pairs, "pairs of triangles touch beyond what they share");
  note_if(notes, report.degenerate_faces, "triangles have no area");
  note_if(notes, report.duplicate_faces, "triangles repeat another");
  note_if(notes, report.non_manifold_vertices, "vertices join more than one fan of triangles");
  return notes;
}

std::string repair_note(const Certificate& certificate) {
  std::string note;
  if (certificate.merge_rounds > 0) note += "; vertices that rounding brought together were merged";
  if (certificate.swap_rounds > 0) note += "; slivers that rounding folded were swapped";
  if (certificate.snap_rounds > 0)
    note += "; folds were arranged again in " + std::to_string(certificate.snap_rounds) + " rounds of snapping";
  const std::size_t moved = certificate.moved_input_vertices.size();
  return moved == 0 ? note : note + ", which moved " + std::to_string(moved) + " vertices of operands";
}

std::string certificate_note(const Certificate& certificate, Coordinates coordinates) {
  const bool is_absolute = certificate.level == CertificateLevel::Absolute;
  const std::string triangles = std::to_string(certificate.triangles_tested), pairs = std::to_string(certificate.pairs_tested);
  const std::string subject = coordinates == Coordinates::Float32 ? "certificate of float32 coordinates: " : "certificate: ";
  const std::string tested = is_absolute
                                 ? "absolute " + subject + "all " + triangles + " triangles tested against one another"
                                 : "relative " + subject + triangles + " triangles with rounded vertices tested in " + pairs + " pairs";
  const std::string moved = ", largest displacement " + format_double(certificate.largest_displacement) + repair_note(certificate);
  if (certificate.status == CertificateStatus::Certified) return tested + moved;
  const std::string failed = "; " + std::to_string(certificate.failed_faces.size());
  return tested + moved + failed +
         (is_absolute ? " triangles are not free of crossings" : " triangles are not proven free of new crossings");
}

val places_out(const ExactPlaces& places) {
  val object = val::object();
  object.set("vertices", copy_out(places.vertices));
  object.set("begin", copy_out(places.begin));
  object.set("points", points_out(places.points));
  return object;
}

val certificate_out(const Certificate& certificate) {
  val object = val::object();
  object.set("level", certificate.level == CertificateLevel::Absolute ? "absolute" : "relative");
  object.set("trianglesTested", count_out(certificate.triangles_tested));
  object.set("pairsTested", count_out(certificate.pairs_tested));
  object.set("inheritedPairs", count_out(certificate.inherited_pairs));
  object.set("failedTriangles", copy_out(certificate.failed_faces));
  object.set("exactPlaces", places_out(certificate.exact_places));
  object.set("largestDisplacement", certificate.largest_displacement);
  object.set("repairDisplacement", certificate.repair_displacement);
  object.set("mergeRounds", certificate.merge_rounds);
  object.set("swapRounds", certificate.swap_rounds);
  object.set("snapRounds", certificate.snap_rounds);
  const auto vertex_out = [](const OperandVertex& v) {
    val pair = val::object();
    pair.set("operand", v.operand);
    pair.set("vertex", v.vertex);
    return pair;
  };
  object.set("movedInputVertices", list_out(certificate.moved_input_vertices, vertex_out));
  return object;
}

val tolerance_out(const ToleranceReport& report) {
  const auto face_out = [](const OperandFace& f) {
    val pair = val::object();
    pair.set("operand", f.operand);
    pair.set("face", f.face);
    return pair;
  };
  val object = val::object();
  object.set("movedVertices", count_out(report.moved_vertices));
  object.set("madeVertices", count_out(report.made_vertices));
  object.set("largestMove", report.largest_move);
  object.set("collapsed", list_out(report.collapsed, face_out));
  object.set("unresolved", list_out(report.unresolved, face_out));
  return object;
}

/// Ids begin with 1: 0 is the space outside.
val regions_out(const std::vector<ResultRegion>& regions) {
  val array = val::array();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    val object = val::object();
    object.set("id", static_cast<std::uint32_t>(i + 1));
    object.set("operands", list_out(regions[i].operands, [](std::uint32_t operand) { return val(operand); }));
    object.set("volume", regions[i].volume);
    object.set("area", regions[i].area);
    array.call<void>("push", object);
  }
  return array;
}

/// What a report says beside the mesh itself.
struct Account {
  bool certified = false;
  val certificate = val::null();
  val tolerance = val::null();
  val operands = val::array();
  std::vector<StageTime> times;
  std::vector<ResultRegion> regions;
  IntersectionGraph graph;
  ContactMeasure contact;
  std::vector<std::string> notes;
};

/// inspect(), with its time and notes added to the account.
MeshReport inspect_into(const SurfaceMesh& mesh, Search search, Account& account) {
  const Stopwatch watch;
  MeshReport report = search == Search::Nothing ? inspect_without_pairs(mesh) : inspect(mesh);
  account.times.push_back({"inspect", watch.milliseconds()});
  for (std::string& note : mesh_notes(report)) account.notes.push_back(std::move(note));
  return report;
}

/// The fields in the order of the documentation.
val report_out(const MeshReport& report, Search search, const Account& account) {
  val object = mesh_report_out(report, search);
  object.set("certified", account.certified);
  object.set("certificate", account.certificate);
  object.set("tolerance", account.tolerance);
  object.set("operands", account.operands);
  object.set("stages", list_out(account.times, stage_out));
  object.set("milliseconds", 0);
  object.set("regions", regions_out(account.regions));
  object.set("graph", graph_counts_out(account.graph));
  object.set("contact", contact_out(account.contact));
  object.set("notes", strings_out(account.notes));
  return object;
}

}  // namespace

val inspection_out(const SurfaceMesh& mesh) {
  Account account;
  const Stopwatch watch;
  const SurfaceMesh welded = weld(mesh).mesh;
  account.times.push_back({"weld", watch.milliseconds()});
  note_if(account.notes, mesh.points.size() - welded.points.size(), "vertices were welded to another of equal position");
  const MeshReport report = inspect_into(welded, Search::SelfIntersections, account);
  account.certified = report.self_intersections == 0 && report.degenerate_faces == 0;
  return report_out(report, Search::SelfIntersections, account);
}

val boolean_report_out(const EvaluatedCall& call, Search search) {
  const BooleanResult& result = call.result;
  Account account;
  account.certified = result.report.certificate.status == CertificateStatus::Certified;
  account.certificate = certificate_out(result.report.certificate);
  if (call.options.tolerance > 0) account.tolerance = tolerance_out(result.report.tolerance);
  account.operands = operands_out(call.operands, call.options.half_spaces, result.report);
  account.times = result.report.stages;
  account.graph = result.graph;
  account.contact = result.report.contact;
  account.notes = result.report.notes;
  for (const SheetOperand& sheet : result.report.sheets) {
    account.notes.push_back("operand " + std::to_string(sheet.operand) + " is a sheet: it has " +
                            std::to_string(sheet.open_edges.size() / 2) + " open edges");
  }
  account.notes.push_back(certificate_note(result.report.certificate, call.options.coordinates));
  note_if(account.notes, result.report.certificate.inherited_pairs, "crossings near the cut were brought along by an operand");
  note_if(account.notes, result.report.tolerance.unresolved.size(),
          "faces could not share all that is within the tolerance, or came to cross others");
  account.regions = call.regions.regions;
  for (const std::uint32_t k : find_idle_sheets(result, call.regions)) {
    account.notes.push_back("operand " + std::to_string(k) + " ends inside a region: it divides nothing there");
  }
  MeshReport report = inspect_into(result.mesh, search, account);
  correct_by_regions(result, call.regions, report);
  return report_out(report, search, account);
}

}  // namespace mortise::wasm
