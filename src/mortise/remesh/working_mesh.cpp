// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/working_mesh.h"

#include <algorithm>
#include <cmath>

#include "mortise/geom/length.h"
#include "mortise/remesh/triangle_shape.h"

namespace mortise {
namespace {

constexpr double cosine_of_30 = 0.8660254037844386, cosine_of_45 = 0.7071067811865476, cosine_of_25 = 0.9063077870366499;
constexpr double good_enough = 0.3;  // a collapse may leave triangles of this mean ratio
constexpr double is_flat = 1e-9;     // a triangle of a lower mean ratio must not be made: which way it faces is chance
constexpr double has_normal = 1e-3;  // below this mean ratio the normal of a triangle is noise
constexpr double stray_of_swap = 0.1, stray_of_collapse = 0.25;  // from the reference, in units of the size
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

// Does a triangle that takes the place of another face the same way?
bool faces_alike(const Shape& now, const Shape& before, const Vec3d& reference) {
  if (now.quality < is_flat) return false;
  if (before.quality > has_normal && !is_within_angle(now.area, before.area, cosine_of_30)) return false;
  return is_within_angle(now.area, reference, cosine_of_45) || reference == Vec3d{};
}

}  // namespace

WorkingMesh::WorkingMesh(const SurfaceMesh& given, const ClassifiedBrep& model, const FaceNormals& normals, const SizingProxy& sizing,
                         const std::vector<std::uint8_t>& zone)
    : mesh(given, model),
      reference(given, model, normals),
      brep(model.brep),
      proxy(sizing),
      sizes(sizing.sizes_at(given.points)),
      arcs(given.points.size()) {
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    for (std::size_t k = 1; k + 1 < path.size(); ++k) arcs[path[k].index()] = reference.arcs(ModelEdgeId(e))[k];
  }
  if (zone.empty()) return;
  is_frozen.assign(given.triangles.size(), 0);
  is_fixed.assign(given.points.size(), 0);
  for (std::size_t t = 0; t < zone.size(); ++t) {
    if (zone[t] != 0) continue;
    is_frozen[t] = 1;
    for (const VertexId v : given.triangles[t]) is_fixed[v.index()] = 1;
  }
}

bool may_split(const WorkingMesh& w, HalfEdge h) {
  bool may = true;
  w.mesh.for_each_use(h, [&](HalfEdge u) { may = may && w.may_change(face_of(u)); });
  return may;
}

double metric_length(const WorkingMesh& w, VertexId a, VertexId b) {
  const double h0 = w.sizes[a.index()], h1 = w.sizes[b.index()];
  return length(at(w, b) - at(w, a)) * (1 / h0 + 8 / (h0 + h1) + 1 / h1) / 6;
}

bool stands_for_edge(const EditMesh& mesh, HalfEdge h) {
  bool is_lowest = true;
  mesh.for_each_use(h, [&](HalfEdge u) { is_lowest = is_lowest && h <= u; });
  return is_lowest;
}

namespace {

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

VertexId split(WorkingMesh& w, HalfEdge h, const Vec3d& point, double arc) {
  const VertexId m = w.mesh.split_edge(h, point);
  w.sizes.resize(w.mesh.vertex_count());
  w.arcs.resize(w.mesh.vertex_count());
  w.sizes[m.index()] = w.proxy.size_at(point);
  w.arcs[m.index()] = arc;
  return m;
}

}  // namespace

VertexId split_at_middle(WorkingMesh& w, HalfEdge h) {
  const Vec3d middle = 0.5 * (at(w, w.mesh.origin(h)) + at(w, w.mesh.target(h)));
  const Vec3d point = w.reference.project(w.mesh.face(face_of(h)), middle, w.mesh.references[face_of(h).index()]).point;
  return split(w, h, turns_over(w, h, point) ? middle : point, 0);
}

VertexId split_at_arc(WorkingMesh& w, HalfEdge h, double arc) { return split(w, h, w.reference.point_at(w.mesh.model_edge(h), arc), arc); }

bool is_swap_fit(const WorkingMesh& w, HalfEdge h) {
  const HalfEdge t = w.mesh.opposite(h);
  if (!may_split(w, h)) return false;
  const VertexId c_id = w.mesh.apex(h), d_id = w.mesh.apex(t);
  const Vec3d &a = at(w, w.mesh.origin(h)), &b = at(w, w.mesh.target(h)), &c = at(w, c_id), &d = at(w, d_id);
  const Shape one = shape_of(w, h), other = shape_of(w, t);
  const bool is_noise = one.quality <= has_normal && other.quality <= has_normal;
  const Vec3d normal = is_noise ? reference_normal(w, h) + reference_normal(w, t) : one.area + other.area;
  for (const Shape& now : {shape_of(d, c, a), shape_of(c, d, b)}) {
    if (now.quality < is_flat || !is_within_angle(now.area, normal, cosine_of_25)) return false;
    const double stray = std::max(stray_over(d - c, now.area, reference_normal(w, h)), stray_over(d - c, now.area, reference_normal(w, t)));
    if (stray > stray_of_swap * std::min(w.sizes[c_id.index()], w.sizes[d_id.index()])) return false;
  }
  return !w.mesh.are_neighbours(c_id, d_id);
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
  if (!w.may_move(gone) || !w.mesh.can_collapse(h, gone)) return false;
  const VertexId a = gone, b = w.mesh.other_end(h, gone);
  bool is_fit = true;
  w.mesh.for_each_neighbour(a, [&](VertexId x) { is_fit = is_fit && (x == b || metric_length(w, b, x) <= longest); });
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
  return is_fit && after >= std::min(good_enough, before);
}

double ball_quality(const WorkingMesh& w, VertexId v, const Vec3d& p) {
  double least = 1;
  w.mesh.for_each_leaving(v, [&](HalfEdge h) {
    if (least < 0) return;
    const Shape now = shape_of(p, at(w, w.mesh.target(h)), at(w, w.mesh.apex(h)));
    least = faces_alike(now, Shape{}, reference_normal(w, h)) ? std::min(least, now.quality) : -1;
  });
  return least;
}

}  // namespace mortise
