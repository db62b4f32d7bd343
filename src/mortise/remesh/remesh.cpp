// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mortise/mesh/measures.h"
#include "mortise/remesh/bound_deviation.h"
#include "mortise/remesh/model_edge_chains.h"
#include "mortise/remesh/new_crossings.h"
#include "mortise/remesh/passes.h"
#include "mortise/remesh/triangle_shape.h"
#include "mortise/remesh/zone_part.h"

namespace mortise {
namespace {

constexpr int sweeps = 3;                                   // of moves per round
constexpr double splits_allowed = 4;                        // over the count foretold, per round
constexpr double long_when_few = 1.2;                       // edges longer than this may be split when triangles are too few
constexpr double longer_when_many = 1.05;                   // of the longest: collapses may make such edges when they are too many
constexpr double good_enough = 0.75;                        // a mean ratio, about 26 degrees
constexpr double even_enough = 0.3;                         // a change of the size on a triangle, of the size
constexpr int deepest = 8;                                  // quarters of quarters
constexpr double triangles_per_square = 2.309401076758503;  // 4 / sqrt(3): equilateral ones of edge 1 on area 1
constexpr std::uint32_t times_of_triangles = 20;            // before whole model faces stay

// The integral of the count per area, over quarters as long as sizes vary much on them.
double count_on(const Vec3d& a, const Vec3d& b, const Vec3d& c, const SizingProxy& sizes, int depth = 0) {
  const Vec3d middle = 1.0 / 3 * (a + b + c);
  const double h = sizes.size_at(middle),
               reach = std::sqrt(std::max({dot(a - middle, a - middle), dot(b - middle, b - middle), dot(c - middle, c - middle)}));
  if (sizes.slope() * reach <= even_enough * h || depth == deepest) {
    const Vec3d area = area_vector(a, b, c);
    return triangles_per_square * std::sqrt(dot(area, area)) / 2 / (h * h);
  }
  const Vec3d ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  return count_on(a, ab, ca, sizes, depth + 1) + count_on(ab, b, bc, sizes, depth + 1) + count_on(ca, bc, c, sizes, depth + 1) +
         count_on(ab, bc, ca, sizes, depth + 1);
}

double count_on(const Triangle& t, const std::vector<Vec3d>& points, const SizingProxy& sizes) {
  return count_on(points[t[0].index()], points[t[1].index()], points[t[2].index()], sizes);
}

void check_rules(const SurfaceMesh& mesh, const RemeshRules& rules) {
  if (!rules.zone.empty() && rules.zone.size() != mesh.triangles.size())
    throw Error(ErrorCode::InvalidArgument, "remesh", "the zone has " + std::to_string(rules.zone.size()) + " marks, not one per triangle");
  const bool are_rounds_fine =
      std::all_of(rules.rounds.begin(), rules.rounds.end(), [](double coarse) { return coarse >= 1 && coarse <= 64; });
  if (!are_rounds_fine) throw Error(ErrorCode::InvalidArgument, "remesh", "rounds are for 1 to 64 times the size");
  const bool is_fine = rules.shortest > 0 && rules.longest > rules.shortest && rules.longest < 1e3 && rules.worst_angle_deg >= 0 &&
                       rules.worst_angle_deg < 60;
  if (!is_fine) throw Error(ErrorCode::InvalidArgument, "remesh", "rules need 0 < shortest < longest < 1000 and 0 <= worst_angle_deg < 60");
  if (!(rules.most_deviation > 0)) throw Error(ErrorCode::InvalidArgument, "remesh", "the most deviation must be positive");
}

/// What is under change: all of the given mesh, or the part of it that a zone may change.
struct Subject {
  const SurfaceMesh& mesh;
  const ClassifiedBrep& model;
  const FaceNormals& normals;
  const std::vector<std::uint8_t>& zone;
  const ZonePart* part = nullptr;

  [[nodiscard]] FaceId in_given(FaceId t) const { return part == nullptr ? t : part->triangles[t.index()]; }
  /// The triangle by its number in the given mesh; invalid when it is not there.
  [[nodiscard]] FaceId from_given(FaceId t) const {
    if (part == nullptr) return t;
    const auto at = std::lower_bound(part->triangles.begin(), part->triangles.end(), t);
    return at != part->triangles.end() && *at == t ? FaceId(static_cast<std::size_t>(at - part->triangles.begin())) : FaceId();
  }
};

// Triangles per model face; those outside the zone are there already. Or refuses.
IdVector<ModelFaceId, double> foretell_counts(const Subject& subject, const SurfaceMesh& given, const SizingProxy& sizes,
                                              const RemeshRules& rules) {
  IdVector<ModelFaceId, double> counts(subject.model.brep.faces.size());
  auto sum = static_cast<double>(given.triangles.size() - subject.mesh.triangles.size());
  for (std::size_t t = 0; t < subject.mesh.triangles.size(); ++t) {
    const bool stays = !subject.zone.empty() && subject.zone[t] == 0;
    const double count = stays ? 1 : count_on(subject.mesh.triangles[t], subject.mesh.points, sizes);
    if (!stays) counts[subject.model.classification.face_of_triangle[t]] += count;
    sum += count;
  }
  if (sum <= rules.most_triangles) return counts;
  throw Error(ErrorCode::ResultTooLarge, "remesh",
              "the sizes ask for about " + std::to_string(static_cast<std::uint64_t>(std::min(sum, 1e18))) + " triangles, more than " +
                  std::to_string(static_cast<std::uint64_t>(rules.most_triangles)));
}

double sum_of(const WorkingMesh& w, const IdVector<ModelFaceId, double>& counts) {
  double sum = 0;
  for (std::size_t f = 0; f < counts.size(); ++f) {
    const double coarseness = w.coarseness_of(ModelFaceId(f));
    sum += counts[ModelFaceId(f)] / (coarseness * coarseness);
  }
  return sum;
}

// While a mesh is coarse, few changes bring the fine one to its count; later each of them leaves a defect.
void approach_count(WorkingMesh& w, const IdVector<ModelFaceId, double>& counts, double longest) {
  const auto frozen = std::count(w.is_frozen.begin(), w.is_frozen.end(), std::uint8_t{1});
  const double excess = static_cast<double>(w.mesh.live_triangle_count()) - static_cast<double>(frozen) - sum_of(w, counts);
  if (excess > 0)
    collapse_short_edges(w, 1, longer_when_many * longest, excess);
  else
    split_long_edges(w, long_when_few, -excess);
  swap_edges(w);
}

void smooth_and_swap(WorkingMesh& w) {
  const std::vector<VertexId> vertices = vertices_inside_faces(w);
  for (int k = 0; k < sweeps; ++k) smooth_vertices(w, vertices, good_enough);
  swap_edges(w);
  settle_on_reference(w);
}

void change_lengths(WorkingMesh& w, const RemeshRules& rules, double most_new) {
  collapse_short_edges(w, rules.shortest, rules.longest);
  swap_edges(w);
  split_long_edges(w, rules.longest, most_new);
  collapse_short_edges(w, rules.shortest, rules.longest);
  swap_edges(w);
}

void change_worst(WorkingMesh& w, const RemeshRules& rules) {
  w.is_done = IdVector<ModelFaceId, std::uint8_t>(w.brep.faces.size());
  improve_worst_triangles(w, rules.worst_angle_deg, rules.longest, rules.last_rounds);
  settle_on_reference(w);
}

/// From .. to of the whole way.
struct ProgressSpan {
  double from = 0, to = 1;
  [[nodiscard]] double at(double fraction) const { return from + fraction * (to - from); }
};

void change_mesh(WorkingMesh& w, const RemeshRules& rules, const IdVector<ModelFaceId, double>& counts, const ProgressSpan& span) {
  const double most_new = splits_allowed * sum_of(w, counts) + 1000;
  const auto all = static_cast<double>(rules.rounds.size() + 1);
  if (rules.mesher == Mesher::Frontal) await_front(w);
  for (std::size_t round = 0; round < rules.rounds.size(); ++round) {
    w.coarseness = rules.rounds[round];
    w.fraction = span.at(static_cast<double>(round) / all);
    report_progress(w.progress, "remesh", w.fraction);
    swap_edges(w);
    resample_model_edges(w);
    if (round + 1 == rules.rounds.size()) mesh_planar_faces(w);
    change_lengths(w, rules, most_new);
    if (w.coarseness > 1) approach_count(w, counts, rules.longest);
    smooth_and_swap(w);
  }
  w.fraction = span.at(1 - 1 / all);
  report_progress(w.progress, "remesh", w.fraction);
  change_worst(w, rules);
}

// What deviates, in smaller sizes.
void change_zone(WorkingMesh& w, const RemeshRules& rules) {
  w.coarseness = 1;
  report_progress(w.progress, "remesh", w.fraction);
  resample_model_edges(w);
  change_lengths(w, rules, splits_allowed * static_cast<double>(w.mesh.live_triangle_count()) + 1000);
  smooth_and_swap(w);
  change_worst(w, rules);
}

// The mesh without holes in its numbering.
ChangedPart compact(const WorkingMesh& w) {
  ChangedPart changed;
  Classification& on = changed.classification;
  on.mesh_vertex = IdVector<ModelVertexId, VertexId>(w.brep.vertex_count);
  std::vector<VertexId>& new_vertex = changed.new_vertex;
  new_vertex.resize(w.mesh.vertex_count());
  for (std::size_t v = 0; v < w.mesh.vertex_count(); ++v) {
    const ModelEntity& entity = w.mesh.entity(VertexId(v));
    if (entity.dimension == EntityDimension::None) continue;
    new_vertex[v] = VertexId(changed.mesh.points.size());
    changed.mesh.points.push_back(w.mesh.points[v]);
    on.entity_of_vertex.push_back(entity);
    if (entity.dimension == EntityDimension::Vertex) on.mesh_vertex[ModelVertexId(entity.id)] = new_vertex[v];
  }
  for (std::size_t t = 0; t < w.mesh.triangle_count(); ++t) {
    if (!w.mesh.has(FaceId(t))) continue;
    const auto [a, b, c] = w.mesh.triangle(FaceId(t));
    changed.mesh.triangles.push_back({new_vertex[a.index()], new_vertex[b.index()], new_vertex[c.index()]});
    changed.sources.emplace_back(w.mesh.references[t]);
    on.face_of_triangle.push_back(w.mesh.face(FaceId(t)));
  }
  for (const std::vector<VertexId>& chain : trace_chains(w)) {
    for (const VertexId v : chain) on.path.items.push_back(new_vertex[v.index()]);
    on.path.close();
  }
  return changed;
}

void copy_marks(const SurfaceMesh& given, RemeshResult& result) {
  result.mesh.label_names = given.label_names;
  for (const FaceId source : result.sources) {
    if (!given.face_labels.empty()) result.mesh.face_labels.push_back(given.face_labels[source.index()]);
    if (!given.walls.empty()) result.mesh.walls.push_back(given.walls[source.index()]);
  }
}

/// With how many triangles first that were never under change.
struct WholeResult {
  RemeshResult result;
  std::size_t outside = 0;
};

WholeResult whole_of(ChangedPart changed, const Subject& subject, const SurfaceMesh& given, const ClassifiedBrep& model) {
  WholeResult whole;
  RemeshResult& result = whole.result;
  if (subject.part == nullptr) {
    result = {std::move(changed.mesh), std::move(changed.classification), std::move(changed.sources), {}, {}, {}};
  } else {
    PutBack all = put_back(*subject.part, changed, given, model);
    whole.outside = all.outside.size();
    for (const FaceId t : changed.sources) all.outside.push_back(subject.in_given(t));
    result = {std::move(all.mesh), std::move(all.classification), std::move(all.outside), {}, {}, {}};
  }
  copy_marks(given, result);
  return whole;
}

/// What audits have taken back.
struct Restraints {
  IdVector<ModelFaceId, std::uint8_t> stays_fine;
  std::vector<std::uint8_t> zone;  // as in RemeshRules
  std::uint32_t times = 0;         // how often triangles had to stay
};

// Faces of these triangles do without coarse rounds; where they did already, the triangles stay, and those round them; at last whole faces.
void restrain(Restraints& restraints, const std::vector<FaceId>& triangles, const SurfaceMesh& given, const ClassifiedBrep& model) {
  const std::vector<ModelFaceId>& face_of = model.classification.face_of_triangle;
  std::vector<std::uint8_t> is_marked(given.points.size(), 0);
  const auto mark = [&](std::size_t t) {
    for (const VertexId v : given.triangles[t]) is_marked[v.index()] = 1;
  };
  IdVector<ModelFaceId, std::uint8_t> is_marked_face(model.brep.faces.size());
  bool are_all_fine = true;
  for (const FaceId t : triangles) {
    std::uint8_t& is_fine = restraints.stays_fine[face_of[t.index()]];
    are_all_fine = are_all_fine && is_fine != 0;
    is_fine = 1;
    is_marked_face[face_of[t.index()]] = 1;
    mark(t.index());
  }
  if (!are_all_fine) return;
  if (restraints.zone.empty()) restraints.zone.assign(given.triangles.size(), 1);
  const bool are_whole_faces = restraints.times++ >= times_of_triangles;
  for (std::size_t t = 0; are_whole_faces && t < given.triangles.size(); ++t) {
    if (is_marked_face[face_of[t]] != 0) mark(t);
  }
  for (std::size_t t = 0; t < given.triangles.size(); ++t) {
    const Triangle& corners = given.triangles[t];
    if (std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return is_marked[v.index()] != 0; })) restraints.zone[t] = 0;
  }
}

// Triangles under change, as they were given, where faces cross or are too far apart.
std::vector<FaceId> where_spoilt(const RemeshResult& result, const DeviatingPlaces& deviating, const Subject& subject) {
  std::vector<FaceId> triangles;
  for (const SelfCrossing& crossing : result.new_crossings) {
    for (const FaceId t : {crossing.a, crossing.b}) {
      const FaceId given = subject.from_given(result.sources[t.index()]);
      if (given.is_valid()) triangles.push_back(given);
    }
  }
  for (const PlaceBeyond& place : deviating.of_mesh) triangles.push_back(place.closest);
  for (const PlaceBeyond& place : deviating.of_given) triangles.push_back(place.triangle);
  return triangles;
}

std::vector<FaceId> kept_by(const Restraints& restraints, const Subject& subject) {
  std::vector<FaceId> kept;
  for (std::size_t t = 0; t < restraints.zone.size(); ++t) {
    if (restraints.zone[t] == 0 && (subject.zone.empty() || subject.zone[t] != 0)) kept.push_back(subject.in_given(FaceId(t)));
  }
  return kept;
}

}  // namespace

RemeshRules paper_rules() {
  RemeshRules rules;
  rules.shortest = 1;
  rules.longest = 2;
  rules.rounds = {1, 1, 1};
  return rules;
}

std::vector<std::uint8_t> layers_round(const SurfaceMesh& mesh, const std::vector<std::array<VertexId, 2>>& edges, std::uint32_t layers) {
  std::vector<std::uint8_t> is_reached(mesh.points.size(), 0), zone(mesh.triangles.size(), 0);
  for (const std::array<VertexId, 2>& ends : edges) {
    for (const VertexId v : ends) {
      if (v.index() >= mesh.points.size())
        throw Error(ErrorCode::InvalidArgument, "layers_round",
                    "an edge ends at vertex " + std::to_string(v.value) + ", which is not there");
      is_reached[v.index()] = 1;
    }
  }
  for (std::uint32_t layer = 0; layer < layers; ++layer) {
    std::vector<VertexId> next;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      const bool touches = std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return is_reached[v.index()] != 0; });
      if (zone[t] != 0 || !touches) continue;
      zone[t] = 1;
      next.insert(next.end(), corners.begin(), corners.end());
    }
    for (const VertexId v : next) is_reached[v.index()] = 1;
  }
  return zone;
}

double predict_triangle_count(const SurfaceMesh& mesh, const SizingProxy& sizes) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += count_on(t, mesh.points, sizes);
  return sum;
}

RemeshResult remesh(const SurfaceMesh& mesh, const ClassifiedBrep& model, const FaceNormals& normals, const SizingProxy& sizes,
                    const RemeshRules& rules) {
  check_rules(mesh, rules);
  const ZonePart part = rules.zone.empty() ? ZonePart() : cut_out(mesh, model, normals, rules.zone);
  const Subject subject = rules.zone.empty() ? Subject{mesh, model, normals, rules.zone, nullptr}
                                             : Subject{part.mesh, part.model, part.normals, part.zone, &part};
  const IdVector<ModelFaceId, double> counts = foretell_counts(subject, mesh, sizes, rules);
  const bool is_any_coarse = std::any_of(rules.rounds.begin(), rules.rounds.end(), [](double coarse) { return coarse > 1; });
  const bool is_bounded = rules.most_deviation < std::numeric_limits<double>::infinity();
  Restraints restraints{{}, subject.zone};
  restraints.stays_fine.resize(model.brep.faces.size(), is_any_coarse ? 0 : 1);
  double left = 1;  // of the progress
  for (std::uint32_t audit = 0;; ++audit, left /= 2) {
    WorkingMesh working(subject.mesh, subject.model, subject.normals, sizes, restraints.zone);
    working.progress = rules.progress;
    working.stays_fine = restraints.stays_fine;
    change_mesh(working, rules, counts, {1 - left, 1 - left / 2});
    std::vector<SizeSource> refinement;
    DeviatingPlaces deviating;
    if (is_bounded) {
      const FacedMesh given{subject.mesh, subject.model.classification.face_of_triangle};
      const auto remesh_zone = [&](WorkingMesh& w) { change_zone(w, rules); };
      deviating = bound_deviation(working, given, rules.most_deviation, remesh_zone, refinement);
    }
    auto [result, outside] = whole_of(compact(working), subject, mesh, model);
    result.kept = kept_by(restraints, subject);
    result.refinement = std::move(refinement);
    if (rules.audits > 0)
      result.new_crossings = find_new_crossings(result.mesh, result.classification.face_of_triangle, outside, mesh, model);
    const bool is_enough = result.new_crossings.empty() || audit >= rules.audits;
    if (is_enough && deviating.empty()) return std::move(result);
    restrain(restraints, where_spoilt(result, deviating, subject), subject.mesh, subject.model);
  }
}

}  // namespace mortise
