// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/working_mesh.h"

#include <algorithm>
#include <cmath>

#include "mortise/geom/length.h"
#include "mortise/remesh/triangle_shape.h"

namespace mortise {
namespace {

constexpr double cosine_of_50 = 0.6427876096865394;
constexpr double good_enough = 0.3;                               // a collapse may leave triangles of this mean ratio
constexpr double has_normal = 1e-3;                               // below this mean ratio the normal of a triangle is noise
constexpr double found_within = 0.25, found_within_plane = 1e-6;  // of the size: places further off are looked for in the whole face
constexpr double mean_normal_of_tip = 0.65;                       // of a cone: the sine of its half angle
constexpr std::uint32_t changes_per_report = 4096;
constexpr double stray_of_swap = 0.2, stray_of_collapse = 0.25;  // from the reference, in units of the size
constexpr double least_gain = 1e-13;                             // of a cosine: swaps must end

const Vec3d& at(const WorkingMesh& w, VertexId v) { return w.mesh.points[v.index()]; }

const Vec3d& reference_normal(const WorkingMesh& w, HalfEdge h) { return w.reference.normal(w.mesh.references[face_of(h).index()]); }

struct Shape {
  Vec3d area;
  double quality = 0;
};

Shape shape_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return {area_vector(a, b, c), mean_ratio(a, b, c)}; }

Shape shape_of(const WorkingMesh& w, HalfEdge h) {
  return shape_of(at(w, w.mesh.origin(h)), at(w, w.mesh.target(h)), at(w, w.mesh.apex(h)));
}

// An estimate of how far the middle of an edge as long as this one is from a surface that turns away by the angle between the normals.
double stray_over(const Vec3d& edge, const Vec3d& area, const Vec3d& reference) {
  const Vec3d turned = cross(area, reference);
  const double squares = dot(area, area);
  return squares > 0 ? std::sqrt(dot(edge, edge) * dot(turned, turned) / squares) / 4 : 0;
}

// Does a triangle that takes the place of another face the same way? One without a side may take the place of another such one.
bool faces_alike(const Shape& now, const Shape& before, const Vec3d& reference) {
  if (now.quality < flat_mean_ratio) return before.quality < flat_mean_ratio;
  if (before.quality > has_normal && !is_within_angle(now.area, before.area, cosine_of_most_turn)) return false;
  return is_within_angle(now.area, reference, cosine_of_most_turn) || reference == Vec3d{};
}

}  // namespace

namespace {

// Vertices inside faces where these come to a point, as a cone does: the mean of the normals round them is short.
void fix_tips(WorkingMesh& w, const SurfaceMesh& given, const FaceNormals& normals) {
  std::vector<Vec3d> sums(given.points.size());
  std::vector<std::uint32_t> counts(given.points.size(), 0);
  for (std::size_t t = 0; t < given.triangles.size(); ++t) {
    for (const VertexId v : given.triangles[t]) {
      sums[v.index()] = sums[v.index()] + normals.normals[t];
      ++counts[v.index()];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double most = mean_normal_of_tip * counts[v];
    if (counts[v] > 0 && w.mesh.is_inside_face(VertexId(v)) && dot(sums[v], sums[v]) < most * most) w.is_fixed[v] = 1;
  }
}

}  // namespace

WorkingMesh::WorkingMesh(const SurfaceMesh& given, const ClassifiedBrep& model, const FaceNormals& normals, const SizingProxy& sizing,
                         const std::vector<std::uint8_t>& zone)
    : mesh(given, model),
      reference(given, model, normals),
      brep(model.brep),
      proxy(&sizing),
      sizes(sizing.sizes_at(given.points)),
      arcs(given.points.size()),
      nears(given.points.size()),
      stays_fine(model.brep.faces.size()),
      awaits_front(model.brep.faces.size()),
      is_done(model.brep.faces.size()) {
  for (std::uint32_t t = 0; t < given.triangles.size(); ++t) {
    for (const VertexId v : given.triangles[t]) nears[v.index()] = t;
  }
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    for (std::size_t k = 1; k + 1 < path.size(); ++k) arcs[path[k].index()] = reference.arcs(ModelEdgeId(e))[k];
  }
  is_fixed.assign(given.points.size(), 0);
  fix_tips(*this, given, normals);
  if (zone.empty()) return;
  is_frozen.assign(given.triangles.size(), 0);
  for (std::size_t t = 0; t < zone.size(); ++t) {
    if (zone[t] != 0) continue;
    is_frozen[t] = 1;
    for (const VertexId v : given.triangles[t]) is_fixed[v.index()] = 1;
  }
}

void count_change(WorkingMesh& w) {
  if (++w.changes % changes_per_report == 0) report_progress(w.progress, "remesh", w.fraction);
}

bool may_split(const WorkingMesh& w, HalfEdge h) {
  bool may = true;
  w.mesh.for_each_use(h, [&](HalfEdge u) { may = may && w.may_change(face_of(u)); });
  return may;
}

double metric_length(const WorkingMesh& w, VertexId a, VertexId b) {
  const double h0 = w.sizes[a.index()], h1 = w.sizes[b.index()], size = length(at(w, b) - at(w, a));
  return h0 == h1 ? size / h0 : size * (1 / h0 + 8 / (h0 + h1) + 1 / h1) / 6;
}

bool stands_for_edge(const EditMesh& mesh, HalfEdge h) {
  bool is_lowest = true;
  mesh.for_each_use(h, [&](HalfEdge u) { is_lowest = is_lowest && h <= u; });
  return is_lowest;
}

namespace {

// A triangle of the reference near an edge there is or would be, in the face of a triangle beside it.
std::uint32_t near_of(const WorkingMesh& w, VertexId a, VertexId b, HalfEdge beside) {
  if (w.mesh.is_inside_face(a)) return w.nears[a.index()];
  return w.mesh.is_inside_face(b) ? w.nears[b.index()] : w.mesh.references[face_of(beside).index()];
}

bool turns_over(const WorkingMesh& w, HalfEdge h, const Vec3d& point) {
  bool found = false;
  w.mesh.for_each_use(h, [&](HalfEdge u) {
    const Vec3d &p = at(w, w.mesh.origin(u)), &q = at(w, w.mesh.target(u)), &x = at(w, w.mesh.apex(u));
    const Shape before = shape_of(w, u);
    found = found || !faces_alike(shape_of(p, point, x), before, reference_normal(w, u)) ||
            !faces_alike(shape_of(point, q, x), before, reference_normal(w, u));
  });
  return found;
}

VertexId split(WorkingMesh& w, HalfEdge h, const Vec3d& point, double arc, std::uint32_t near) {
  count_change(w);
  const VertexId m = w.mesh.split_edge(h, point);
  add_values(w, m, arc, near);
  return m;
}

}  // namespace

void add_values(WorkingMesh& w, VertexId v, double arc, std::uint32_t near) {
  w.sizes.resize(w.mesh.vertex_count());
  w.arcs.resize(w.mesh.vertex_count());
  w.nears.resize(w.mesh.vertex_count());
  w.sizes[v.index()] = w.proxy->size_at(w.mesh.points[v.index()]);
  w.arcs[v.index()] = arc;
  w.nears[v.index()] = near;
}

SurfacePlace place_on_face(const WorkingMesh& w, ModelFaceId face, const Vec3d& p, std::uint32_t near, double size) {
  return w.reference.is_plane(face) ? SurfacePlace{p, near} : w.reference.locate(face, p, near, found_within * size);
}

std::uint32_t triangle_below(const WorkingMesh& w, ModelFaceId face, const Vec3d& p, std::uint32_t near, double size) {
  return w.reference.locate(face, p, near, size * (w.reference.is_plane(face) ? found_within_plane : found_within)).triangle;
}

void move_vertex(WorkingMesh& w, VertexId v, const SurfacePlace& place) {
  count_change(w);
  w.mesh.points[v.index()] = place.point;
  w.nears[v.index()] = place.triangle;
  w.sizes[v.index()] = w.proxy->size_at(place.point);
}

VertexId split_at_middle(WorkingMesh& w, HalfEdge h) {
  const Vec3d middle = 0.5 * (at(w, w.mesh.origin(h)) + at(w, w.mesh.target(h)));
  const VertexId a = w.mesh.origin(h), b = w.mesh.target(h);
  const SurfacePlace place = place_on_face(w, w.mesh.face(face_of(h)), middle, near_of(w, a, b, h), w.sizes[a.index()]);
  return split(w, h, turns_over(w, h, place.point) ? middle : place.point, 0, place.triangle);
}

VertexId split_at_arc(WorkingMesh& w, HalfEdge h, double arc) {
  return split(w, h, w.reference.point_at(w.mesh.model_edge(h), arc), arc, 0);
}

namespace {

bool is_further(const WorkingMesh& w, ModelFaceId face, const Vec3d& p, std::uint32_t near, double within) {
  return !w.reference.is_plane(face) && !w.reference.is_within(p, near, within);
}

// Is the middle of what would be an edge inside the face of a half-edge too far from that face?
bool edge_strays(const WorkingMesh& w, VertexId a, VertexId b, HalfEdge beside, double most) {
  return is_further(w, w.mesh.face(face_of(beside)), 0.5 * (at(w, a) + at(w, b)), near_of(w, a, b, beside),
                    most * std::min(w.sizes[a.index()], w.sizes[b.index()]));
}

// Is a vertex further than this from all triangles there would be without it?
bool is_left_out(const WorkingMesh& w, VertexId gone, VertexId stays, double within) {
  bool is_near = false;
  w.mesh.for_each_leaving(gone, [&](HalfEdge g) {
    const VertexId x = w.mesh.target(g), y = w.mesh.apex(g);
    if (is_near || x == stays || y == stays) return;
    const PlacedTriangle placed = place_triangle({at(w, stays), at(w, x), at(w, y)});
    const Vec3d away = in_space(placed, closest_in(placed, at(w, gone)).at) - at(w, gone);
    is_near = dot(away, away) <= within * within;
  });
  return !is_near;
}

}  // namespace

bool strays(const WorkingMesh& w, ModelFaceId face, const Vec3d& p, std::uint32_t near, double size) {
  return is_further(w, face, p, near, stray_of_collapse * size);
}

bool is_swap_fit(const WorkingMesh& w, HalfEdge h) {
  const HalfEdge t = w.mesh.opposite(h);
  if (!may_split(w, h)) return false;
  const VertexId c_id = w.mesh.apex(h), d_id = w.mesh.apex(t);
  const Vec3d &a = at(w, w.mesh.origin(h)), &b = at(w, w.mesh.target(h)), &c = at(w, c_id), &d = at(w, d_id);
  const Shape one = shape_of(w, h), other = shape_of(w, t);
  const bool is_noise = one.quality <= has_normal && other.quality <= has_normal;
  const Vec3d normal = is_noise ? reference_normal(w, h) + reference_normal(w, t) : one.area + other.area;
  for (const Shape& now : {shape_of(d, c, a), shape_of(c, d, b)}) {
    if (now.quality < flat_mean_ratio || !is_within_angle(now.area, normal, cosine_of_50)) return false;
    const double stray = std::max(stray_over(d - c, now.area, reference_normal(w, h)), stray_over(d - c, now.area, reference_normal(w, t)));
    if (stray > stray_of_swap * std::min(w.sizes[c_id.index()], w.sizes[d_id.index()])) return false;
  }
  return !w.mesh.are_neighbours(c_id, d_id) && !edge_strays(w, c_id, d_id, h, stray_of_swap);
}

bool swap_lowers_angle(const WorkingMesh& w, HalfEdge h) {
  if (w.mesh.is_on_model_edge(h)) return false;
  const VertexId c_id = w.mesh.apex(h), d_id = w.mesh.apex(w.mesh.opposite(h));
  if (c_id == d_id) return false;
  const Vec3d &a = at(w, w.mesh.origin(h)), &b = at(w, w.mesh.target(h)), &c = at(w, c_id), &d = at(w, d_id);
  const double before = std::min(least_cosine(a, b, c), least_cosine(b, a, d));
  if (least_cosine(d, c, a) <= before + least_gain || least_cosine(c, d, b) <= before + least_gain) return false;
  return is_swap_fit(w, h);
}

bool is_collapse_fit(const WorkingMesh& w, HalfEdge h, VertexId gone, double longest) {
  const VertexId a = gone, b = w.mesh.other_end(h, gone);
  if (!w.may_move(a) || !w.mesh.may_leave_along(h, a)) return false;
  bool is_fit = true;
  w.mesh.for_each_neighbour(a, [&](VertexId x) { is_fit = is_fit && (x == b || metric_length(w, b, x) <= longest); });
  if (!is_fit) return false;
  double before = 1, after = 1;
  w.mesh.for_each_leaving(a, [&](HalfEdge g) {
    if (!is_fit) return;
    const Shape old = shape_of(w, g);
    before = std::min(before, old.quality);
    const VertexId x = w.mesh.target(g), y = w.mesh.apex(g);
    if (x == b || y == b) return;
    const Shape now = shape_of(at(w, b), at(w, x), at(w, y));
    after = std::min(after, now.quality);
    const Vec3d &bx = at(w, x) - at(w, b), &by = at(w, y) - at(w, b);
    const Vec3d& longer = dot(bx, bx) < dot(by, by) ? by : bx;
    is_fit = faces_alike(now, old, reference_normal(w, g)) &&
             stray_over(longer, now.area, reference_normal(w, g)) <= stray_of_collapse * w.sizes[b.index()];
  });
  if (!is_fit || after < std::min(good_enough, before) || !w.mesh.can_collapse(h, a)) return false;
  w.mesh.for_each_leaving(a, [&](HalfEdge g) {
    const VertexId x = w.mesh.target(g);
    is_fit = is_fit && (x == b || !edge_strays(w, b, x, g, stray_of_collapse));
  });
  if (!is_fit || w.coarseness_beside(h) == 1) return is_fit;
  w.mesh.for_each_leaving(a, [&](HalfEdge g) {
    const VertexId x = w.mesh.target(g), y = w.mesh.apex(g);
    if (!is_fit || x == b || y == b) return;
    is_fit = !strays(w, w.mesh.face(face_of(g)), 1.0 / 3 * (at(w, b) + at(w, x) + at(w, y)), w.mesh.references[face_of(g).index()],
                     w.sizes[b.index()]);
  });
  return is_fit && !is_left_out(w, a, b, stray_of_collapse * w.sizes[b.index()]);
}

}  // namespace mortise
