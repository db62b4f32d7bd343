// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The pipeline of the paper, one call per stage.
#include "mortise/boolean/evaluate_boolean.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>

#include "mortise/arrange/triangulate_faces.h"
#include "mortise/base/stopwatch.h"
#include "mortise/boolean/categorize.h"
#include "mortise/boolean/certify_or_repair.h"
#include "mortise/boolean/cut_by_sheets.h"
#include "mortise/boolean/evaluate_selection.h"
#include "mortise/boolean/exact_places.h"
#include "mortise/boolean/given_operands.h"
#include "mortise/boolean/intersection_graph.h"
#include "mortise/boolean/merge.h"
#include "mortise/boolean/refuse_operands.h"
#include "mortise/boolean/repair_by_snapping.h"
#include "mortise/boolean/share_within_tolerance.h"
#include "mortise/boolean/simplify.h"
#include "mortise/boolean/transfer_data.h"
#include "mortise/mesh/volume_sign.h"

namespace mortise {
namespace {

struct Arrangement {
  FaceIntersectionMap map;
  Facets facets;
  Categories categories;
  std::vector<std::uint32_t> self_contacts;  // operands that touch themselves beyond what their faces share
};

std::vector<std::uint32_t> operands_with_self_contacts(const OperandFaces& faces, const Contacts& contacts) {
  std::vector<std::uint32_t> result;
  for (const Contact& c : contacts.contacts) {
    if (faces.operand[c.face_a] == faces.operand[c.face_b]) result.push_back(faces.operand[c.face_a].value);
  }
  for (const StrayPoint& s : contacts.stray_points) result.push_back(faces.operand[s.face].value);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Calls a stage, and adds its time to those of its name.
template <class Stage>
auto timed(std::vector<StageTime>& times, const char* name, Stage stage) {
  const Stopwatch watch;
  auto result = stage();
  const auto found = std::find_if(times.begin(), times.end(), [&](const StageTime& t) { return t.stage == name; });
  if (found == times.end()) {
    times.push_back({name, watch.milliseconds()});
  } else {
    found->milliseconds += watch.milliseconds();
  }
  return result;
}

Arrangement arrange(OperandFaces& faces, const BooleanOptions& options, std::vector<StageTime>& times) {
  const ProgressCallback& progress = options.progress;
  const Contacts contacts = timed(times, "find_contacts", [&] { return find_contacts(faces, options.contact_memory, progress); });
  const Overlays overlays = timed(times, "overlay_coplanar", [&] { return overlay_coplanar(faces, contacts); });
  Arrangement result;
  result.self_contacts = operands_with_self_contacts(faces, contacts);
  result.map = timed(times, "face_intersection_map", [&] { return build_face_intersection_map(faces, contacts, overlays); });
  const LineSubdivision lines = timed(times, "split_segments", [&] { return split_segments(faces, overlays, result.map, progress); });
  result.facets = timed(times, "triangulate_faces", [&] { return triangulate_faces(faces, overlays, result.map, lines, progress); });
  report_progress(progress, "categorize", 0.65);
  result.categories = timed(times, "categorize", [&] { return categorize(faces, result.map, result.facets); });
  return result;
}

// Arranges again with the self contacts of operands that turned out to need them (exact-core 3).
Arrangement arrange_until_simple(OperandFaces& faces, const BooleanOptions& options, std::vector<StageTime>& times) {
  Arrangement result = arrange(faces, options, times);
  while (!result.categories.doubtful.empty()) {
    for (const OperandId k : result.categories.doubtful) faces.self_contacts[k] = SelfContacts::All;
    result = arrange(faces, options, times);
  }
  return result;
}

// Operands with a border become sheets; what they cut is cut already, only windings change.
Arrangement arrange_sheets_and_solids(OperandFaces& faces, const BooleanOptions& options, std::vector<StageTime>& times) {
  Arrangement result = arrange_until_simple(faces, options, times);
  const std::vector<OperandId> sheets = options.require_solids ? std::vector<OperandId>() : find_sheets(result.categories);
  if (sheets.empty()) return result;
  for (const OperandId k : sheets) make_sheet(k, faces);
  result.categories = timed(times, "categorize", [&] { return categorize(faces, result.map, result.facets); });
  return result.categories.doubtful.empty() ? std::move(result) : arrange_until_simple(faces, options, times);
}

void mark_half_spaces(std::span<const std::size_t> half_spaces, OperandFaces& faces) {
  for (const std::size_t k : half_spaces) faces.kind[OperandId(k)] = OperandKind::HalfSpace;
}

// No vertex of a half-space may be one of the result.
void refuse_unbounded(std::string_view name, const OperandFaces& faces, const Facets& facets, const Selection& selection) {
  std::vector<PointId> far;
  for (std::size_t k = 0; k < faces.operand_count(); ++k) {
    if (faces.kind[OperandId(k)] != OperandKind::HalfSpace) continue;
    const std::vector<PointId>& points = faces.point_of_vertex[OperandId(k)];
    far.insert(far.end(), points.begin(), points.end());
  }
  if (far.empty()) return;
  std::sort(far.begin(), far.end());
  for (const KeptFacet& k : selection.kept) {
    for (const PointId p : facets.corners[k.facet]) {
      if (std::binary_search(far.begin(), far.end(), p))
        throw Error(ErrorCode::InvalidArgument, name, "the result would reach to infinity");
    }
  }
}

std::vector<DataChannel> transfer_to(const BooleanResult& result, const ExactOperands& source, std::vector<DataChannel> channels,
                                     const ProgressCallback& progress) {
  transfer_data(source, triangles_in_faces(source.faces, result), channels, progress);
  return channels;
}

// Faces of equal labels may be joined, unless they have data that would have to agree too.
AgreementOfFaces agreement_of_labels(std::span<const SurfaceMesh* const> operands, const OperandFaces& faces) {
  return [operands, &faces](SourceId f, SourceId g) {
    const SurfaceMesh &a = *operands[faces.operand[f].index()], &b = *operands[faces.operand[g].index()];
    const auto has_data = [](const SurfaceMesh& mesh) { return !mesh.vertex_data.empty() || !mesh.corner_data.empty(); };
    if (has_data(a) || has_data(b)) return false;
    const auto label_of = [](const SurfaceMesh& mesh, std::uint32_t face) {
      return mesh.face_labels.empty() ? std::string_view() : mesh.label_names[mesh.face_labels[face]];
    };
    return label_of(a, faces.face_in_operand(f)) == label_of(b, faces.face_in_operand(g));
  };
}

std::vector<SheetOperand> sheets_of(const OperandList& operands, const OperandFaces& faces) {
  std::vector<SheetOperand> sheets;
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    if (faces.kind[OperandId(k)] == OperandKind::Sheet) sheets.push_back({k, open_edges(operands.mesh(k), faces, OperandId(k))});
  }
  return sheets;
}

// Which selection, and how.
struct Call {
  std::string_view name;
  const Selector& select;
  const BooleanOptions& options;
  bool is_repair;                         // the operands have been accepted before
  std::span<const std::uint32_t> folded;  // operands all of whose contacts with themselves are resolved
};

// Keeps what it takes to arrange again what the certificate could not prove. Facets behind the first ones were joined from these.
void keep_for_repair(const Call& call, std::span<const SurfaceMesh* const> operands, const Arrangement& arrangement,
                     std::size_t facet_count, const RoundedResult& rounded, EvaluatedSelection& evaluated) {
  if (rounded.is_given_up) return;
  for (const std::uint32_t t : rounded.certified.certificate.failed_faces) {
    for (const FacetSource& s : arrangement.facets.sources_of(rounded.merged.facet_of_triangle[t].facet)) {
      evaluated.failed_faces.push_back(s.face);
    }
  }
  if (evaluated.failed_faces.empty() || call.is_repair) return;
  Facets facets = arrangement.facets;
  facets.corners.resize(facet_count);
  facets.sources.resize(facets.first_source[FacetId(facet_count)]);
  facets.first_source.resize(facet_count + 1);
  const Selection all = select_all(evaluated.faces, facets, arrangement.categories);
  evaluated.all_facets = merge(operands, evaluated.faces, facets, all, call.options.coordinates);
}

// What doubles leave nothing of is debris between operands that almost coincide; what float32 leaves nothing of may have been wanted.
void refuse_to_vanish(Coordinates coordinates, const SurfaceMesh& mesh, BooleanReport& report) {
  if (coordinates == Coordinates::Float64 || !mesh.triangles.empty()) return;
  report.certificate.status = CertificateStatus::Uncertified;
  report.notes.push_back("float32 coordinates are too coarse for this mesh: nothing is left of it");
}

// From the faces of the operands to the result, without data.
EvaluatedSelection evaluate_gathered(const Call& call, const OperandList& operands, OperandFaces&& gathered) {
  const BooleanOptions& options = call.options;
  EvaluatedSelection evaluated;
  evaluated.faces = std::move(gathered);
  OperandFaces& faces = evaluated.faces;
  BooleanResult& result = evaluated.result;
  BooleanReport& report = result.report;
  std::vector<StageTime>& times = report.stages;
  mark_half_spaces(options.half_spaces, faces);
  Arrangement arrangement = arrange_sheets_and_solids(faces, options, times);
  if (!call.is_repair) refuse_operands(operands.meshes(), faces, arrangement.categories);
  report_progress(options.progress, "select", 0.75);
  Selection selection = timed(times, "select", [&] { return call.select(faces, arrangement.facets, arrangement.categories); });
  refuse_unbounded(call.name, faces, arrangement.facets, selection);
  result.graph = timed(times, "intersection_graph", [&] {
    return build_intersection_graph(faces, arrangement.map, arrangement.facets, arrangement.categories.patches);
  });
  report.contact = measure_contact(faces, arrangement.facets, result.graph);
  const std::size_t facet_count = arrangement.facets.size();
  if (options.simplify != Simplify::Off) {
    const SimplifyRule rule{options.simplify, agreement_of_labels(operands.meshes(), faces), arrangement.map.contact_points};
    selection = timed(times, "simplify", [&] { return simplify(rule, faces, arrangement.facets, std::move(selection)); });
  }
  const Coordinates coordinates = options.coordinates;
  MergedMesh merged = timed(times, "merge", [&] { return merge(operands.meshes(), faces, arrangement.facets, selection, coordinates); });
  const int most_rounds = call.is_repair ? 2 : 8;
  const auto certify = [&] {
    return certify_or_repair(faces, arrangement.facets, std::move(merged), coordinates, most_rounds, options.progress);
  };
  RoundedResult rounded = timed(times, "certify", certify);
  keep_for_repair(call, operands.meshes(), arrangement, facet_count, rounded, evaluated);
  report.certificate = std::move(rounded.certified.certificate);
  if (options.certify == CertificateLevel::Absolute) {
    const auto certify_all = [&] { return certify_all_pairs(rounded.merged.mesh, std::move(report.certificate)); };
    report.certificate = timed(times, "certify", certify_all);
  }
  if (selection.is_cut_by_sheets) report.notes = cut_by_sheets(faces, arrangement.facets, rounded.merged, report.certificate.failed_faces);
  if (rounded.is_given_up) report.notes.push_back("float32 coordinates are too coarse for this mesh: many of its vertices became one");
  if (!selection.kept.empty()) refuse_to_vanish(coordinates, rounded.merged.mesh, report);
  report.self_contacts = arrangement.self_contacts;
  report.sheets = sheets_of(operands, faces);
  result.mesh = std::move(rounded.merged.mesh);
  result.provenance = std::move(rounded.merged.provenance);
  evaluated.point_of_vertex = std::move(rounded.merged.point_of_vertex);
  return evaluated;
}

// The same for operands of a former arrangement, rounded: these are solids or sheets, crossing themselves where rounding folded them.
EvaluatedSelection evaluate_cut_operands(const Call& call, std::span<const SurfaceMesh* const> operands) {
  BooleanOptions options = call.options;
  options.require_solids = false;
  if (options.progress) options.progress = [&](std::string_view, double) { return call.options.progress("repair_by_snapping", 0.95); };
  const OperandList list(operands);
  OperandFaces faces = gather_operands(list);
  for (std::size_t k = 0; k < faces.operand_count(); ++k) faces.self_contacts[OperandId(k)] = SelfContacts::All;
  return evaluate_gathered({call.name, call.select, options, true, {}}, list, std::move(faces));
}

// Where coordinates brought very many faces together there may be no room to arrange them; then the result stays as it is.
void snap_within_memory(const OperandList& operands, Coordinates coordinates, const EvaluateAgain& again, EvaluatedSelection& evaluated) {
  try {
    repair_by_snapping(operands, coordinates, again, evaluated);
  } catch (const Error& error) {
    if (error.code != ErrorCode::ResultTooLarge) throw;
    evaluated.result.report.notes.push_back("rounding brought so many faces together that their repair would need too much memory");
  }
}

EvaluatedSelection evaluate_and_snap(const Call& call, const OperandList& operands) {
  std::vector<StageTime> times;
  report_progress(call.options.progress, "gather_operands", 0);
  OperandFaces faces = timed(times, "gather_operands", [&] { return gather_operands(operands); });
  for (const std::uint32_t k : call.folded) faces.self_contacts[OperandId(k)] = SelfContacts::All;
  EvaluatedSelection evaluated = evaluate_gathered(call, operands, std::move(faces));
  std::vector<StageTime>& stages = evaluated.result.report.stages;
  stages.insert(stages.begin(), times.begin(), times.end());
  if (evaluated.failed_faces.empty()) return evaluated;
  const auto again = [&](std::span<const SurfaceMesh* const> cut) { return evaluate_cut_operands(call, cut); };
  const Stopwatch watch;
  snap_within_memory(operands, call.options.coordinates, again, evaluated);
  refuse_to_vanish(call.options.coordinates, evaluated.result.mesh, evaluated.result.report);
  evaluated.result.report.stages.push_back({"repair_by_snapping", watch.milliseconds()});
  return evaluated;
}

EvaluatedSelection evaluate_and_repair(const Call& call, const OperandList& operands) {
  EvaluatedSelection evaluated = evaluate_and_snap(call, operands);
  Certificate& certificate = evaluated.result.report.certificate;
  certificate.exact_places =
      exact_places(evaluated.result.mesh, certificate.failed_faces, evaluated.faces.points, evaluated.point_of_vertex);
  return evaluated;
}

// What evaluate_and_repair says of shared operands, said of those they were made from.
EvaluatedSelection evaluate_for_given(const Call& call, const OperandList& given, OperandFaces& given_faces, const OperandList& shared) {
  EvaluatedSelection evaluated = evaluate_and_repair(call, shared);
  for (SheetOperand& sheet : evaluated.result.report.sheets) {
    const OperandId k(sheet.operand);
    given_faces.kind[k] = OperandKind::Sheet;
    sheet.open_edges = open_edges(given.mesh(k.index()), given_faces, k);
  }
  return evaluated;
}

// Has sharing turned the operand that is inside out?
bool is_turned_by_sharing(const Error& error, const OperandList& given) {
  return error.code == ErrorCode::InsideOut && error.operand >= 0 &&
         enclosed_volume_sign(given.mesh(static_cast<std::size_t>(error.operand))) == Sign::Positive;
}

// Nothing is left of an operand that sharing turned inside out, for it is thinner than the tolerance.
EvaluatedSelection evaluate_what_is_left(const Call& call, const OperandList& given, OperandFaces& given_faces, SharedOperands& shared) {
  while (true) {
    try {
      return evaluate_for_given(call, given, given_faces, OperandList(meshes_of(shared.operands)));
    } catch (const Error& error) {
      if (!is_turned_by_sharing(error, given)) {
        if (error.operand >= 0) refuse_operand(given.meshes(), given_faces, OperandId(static_cast<std::size_t>(error.operand)), error.code);
        throw;
      }
      const auto k = static_cast<std::size_t>(error.operand);
      shared.operands[k] = {};
      shared.operands[k].mesh.label_names = given.mesh(k).label_names;
    }
  }
}

// Does every triangle occur as often one way round as the other?
bool is_folded_flat(const SurfaceMesh& mesh) {
  std::map<Triangle, int> times;
  for (Triangle t : mesh.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const bool is_forward = t[1] < t[2];
    if (!is_forward) std::swap(t[1], t[2]);
    times[t] += is_forward ? 1 : -1;
  }
  return std::all_of(times.begin(), times.end(), [](const auto& entry) { return entry.second == 0; });
}

// Only where faces collapsed may an operand be folded flat.
std::vector<std::string> notes_of_vanished(const OperandList& given, const SharedOperands& shared) {
  std::vector<std::uint8_t> has_collapsed(given.size(), 0);
  for (const OperandFace& face : shared.report.collapsed) has_collapsed[face.operand] = 1;
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const SurfaceMesh& mesh = shared.operands[k].mesh;
    const bool may_vanish = has_collapsed[k] != 0 || (mesh.triangles.empty() && !given.mesh(k).triangles.empty());
    if (may_vanish && is_folded_flat(mesh)) notes.push_back("operand " + std::to_string(k) + " is thinner than the tolerance and vanished");
  }
  return notes;
}

// The operands as they share what is near, evaluated; then seen from the operands as given.
EvaluatedSelection evaluate_shared(const Call& call, const OperandList& operands) {
  report_progress(call.options.progress, "gather_operands", 0);
  std::vector<StageTime> times;
  OperandFaces given_faces = timed(times, "gather_operands", [&] { return gather_operands(operands); });
  const auto share = [&] { return share_within_tolerance(operands.meshes(), call.options.tolerance, call.options.progress); };
  SharedOperands shared = timed(times, "share_within_tolerance", share);
  const Call of_shared{call.name, call.select, call.options, false, shared.folded};
  EvaluatedSelection evaluated = evaluate_what_is_left(of_shared, operands, given_faces, shared);
  BooleanReport& report = evaluated.result.report;
  report.stages.insert(report.stages.begin(), times.begin(), times.end());
  for (std::string& note : notes_of_vanished(operands, shared)) report.notes.push_back(std::move(note));
  report.tolerance = std::move(shared.report);
  std::vector<OperandVertex>& moved = report.certificate.moved_input_vertices;
  const std::vector<OperandVertex> snapped = std::move(moved);
  moved = name_given_sources(operands.meshes(), shared.operands, call.options.coordinates, evaluated);
  for (const OperandVertex& v : snapped) {
    const std::uint32_t source = shared.operands[v.operand].source_vertex[v.vertex];
    if (source != Provenance::none) moved.push_back({v.operand, source});
  }
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  return at_its_doubles(operands, std::move(evaluated.result));
}

}  // namespace

EvaluatedSelection evaluate_selection_exactly(std::string_view name, const Selector& select, const OperandList& operands,
                                              const BooleanOptions& options) {
  if (operands.empty()) throw Error(ErrorCode::InvalidArgument, name, "at least one operand is needed");
  if (!(options.tolerance >= 0) || options.tolerance > std::numeric_limits<double>::max())
    throw Error(ErrorCode::InvalidArgument, name, "the tolerance is a length, 0 or more");
  std::vector<DataChannel> channels = join_channels(operands.meshes());
  const Call call{name, select, options, false, {}};
  EvaluatedSelection evaluated = options.tolerance > 0 ? evaluate_shared(call, operands) : evaluate_and_repair(call, operands);
  if (!channels.empty()) {
    const ExactOperands source{operands.meshes(), evaluated.faces, evaluated.point_of_vertex};
    const auto transfer = [&] { return transfer_to(evaluated.result, source, std::move(channels), options.progress); };
    evaluated.result.mesh.corner_data = timed(evaluated.result.report.stages, "transfer_data", transfer);
  }
  report_progress(options.progress, "certify", 1);
  return evaluated;
}

BooleanResult evaluate_selection(std::string_view name, const Selector& select, const OperandList& operands,
                                 const BooleanOptions& options) {
  return evaluate_selection_exactly(name, select, operands, options).result;
}

BooleanResult evaluate_boolean(Operation operation, const OperandList& operands, const BooleanOptions& options) {
  const auto selector = [operation](const OperandFaces& faces, const Facets& facets, const Categories& categories) {
    return select(operation, faces, facets, categories);
  };
  return evaluate_selection(operation_name(operation), selector, operands, options);
}

BooleanResult unite(const Operand& a, const Operand& b, const BooleanOptions& options) {
  return evaluate_boolean(Operation::Union, std::array{a, b}, options);
}

BooleanResult intersect(const Operand& a, const Operand& b, const BooleanOptions& options) {
  return evaluate_boolean(Operation::Intersect, std::array{a, b}, options);
}

BooleanResult subtract(const Operand& a, const Operand& b, const BooleanOptions& options) {
  return evaluate_boolean(Operation::Subtract, std::array{a, b}, options);
}

BooleanResult symmetric_difference(const Operand& a, const Operand& b, const BooleanOptions& options) {
  return evaluate_boolean(Operation::SymmetricDifference, std::array{a, b}, options);
}

BooleanResult partition(const Operand& a, const Operand& b, const BooleanOptions& options) {
  return evaluate_boolean(Operation::Partition, std::array{a, b}, options);
}

}  // namespace mortise
