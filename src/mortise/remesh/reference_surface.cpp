// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/reference_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mortise/geom/length.h"

namespace mortise {
namespace {

constexpr double flatness = 1e-10;  // of the size of a face
constexpr std::size_t deepest = 128;

double square_of(const Vec3d& v) { return dot(v, v); }

std::vector<HalfEdge> opposites_in_faces(const SurfaceMesh& mesh, const std::vector<ModelFaceId>& face_of_triangle) {
  std::vector<HalfEdge> opposite(3 * mesh.triangles.size());
  for (HalfEdge h = 0; h < opposite.size(); ++h) opposite[h] = h;
  const MeshTopology topology = build_topology(mesh);
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const std::span<const HalfEdge> uses = topology.uses_of(MeshEdgeId(e));
    if (uses.size() != 2 || face_of_triangle[uses[0] / 3] != face_of_triangle[uses[1] / 3]) continue;
    opposite[uses[0]] = uses[1];
    opposite[uses[1]] = uses[0];
  }
  return opposite;
}

}  // namespace

ReferenceSurface::ReferenceSurface(const SurfaceMesh& mesh, const ClassifiedBrep& model, const FaceNormals& normals)
    : points_(mesh.points),
      triangles_(mesh.triangles),
      normals_(normals.normals),
      opposite_(opposites_in_faces(mesh, model.classification.face_of_triangle)),
      faces_(model.brep.faces.size()),
      paths_(model.classification.path) {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t];
    placed_.push_back(place_triangle({points_[a.index()], points_[b.index()], points_[c.index()]}));
    faces_[model.classification.face_of_triangle[t]].triangles.push_back(t);
  }
  for (Face& face : faces_) {
    std::vector<Box3> boxes;
    for (const std::uint32_t t : face.triangles) {
      Box3 box;
      for (const VertexId v : triangles_[t]) box.extend(points_[v.index()]);
      boxes.push_back(box);
    }
    face.tree = BoxTree(boxes);
    face.is_plane = lies_in_plane(face);
  }
  for (std::size_t e = 0; e < paths_.size(); ++e) {
    double arc = 0;
    const std::span<const VertexId> path = paths_.of(ModelEdgeId(e));
    for (std::size_t k = 0; k < path.size(); ++k) {
      if (k > 0) arc += mortise::length(points_[path[k].index()] - points_[path[k - 1].index()]);
      arcs_.items.push_back(arc);
    }
    arcs_.close();
  }
}

bool ReferenceSurface::lies_in_plane(const Face& face) const {
  Vec3d sum;
  for (const std::uint32_t t : face.triangles) {
    const auto& [a, b, c] = triangles_[t];
    sum = sum + cross(points_[b.index()] - points_[a.index()], points_[c.index()] - points_[a.index()]);
  }
  const double size = mortise::length(sum);
  if (!(size > 0)) return false;
  const Vec3d normal{sum.x / size, sum.y / size, sum.z / size};
  const double within = flatness * mortise::length(face.tree.bounds().hi - face.tree.bounds().lo);
  const Vec3d& origin = points_[triangles_[face.triangles.front()][0].index()];
  return std::all_of(face.triangles.begin(), face.triangles.end(), [&](std::uint32_t t) {
    return dot(normals_[t], normal) > 1 - 1e-9 && std::all_of(triangles_[t].begin(), triangles_[t].end(), [&](VertexId v) {
             return std::fabs(dot(points_[v.index()] - origin, normal)) <= within;
           });
  });
}

ReferenceSurface::Foot ReferenceSurface::foot_on(std::uint32_t triangle, const Vec3d& p) const {
  const ClosestPlace closest = closest_in(placed_[triangle], p);
  const Vec3d point = in_space(placed_[triangle], closest.at);
  return {{point, triangle}, square_of(point - p), closest.is_inside, closest.edge};
}

// The other triangle of the edge it is on, when that is closer.
ReferenceSurface::Foot ReferenceSurface::closest_across_edge(const Foot& from, const Vec3d& p) const {
  const HalfEdge h = 3 * from.place.triangle + from.edge;
  if (opposite_[h] == h) return from;
  const Foot foot = foot_on(opposite_[h] / 3, p);
  return foot.square < from.square ? foot : from;
}

// Of the triangles of the face round the corner it is closest to.
ReferenceSurface::Foot ReferenceSurface::closest_round_corner(const Foot& from, const Vec3d& p) const {
  const std::uint32_t t = from.place.triangle;
  HalfEdge corner = 3 * t;
  for (HalfEdge h = 3 * t + 1; h < 3 * t + 3; ++h) {
    const auto square_to = [&](HalfEdge c) { return square_of(points_[triangles_[t][c % 3].index()] - from.place.point); };
    if (square_to(h) < square_to(corner)) corner = h;
  }
  Foot best = from;
  const auto go_round = [&](auto step) {
    for (HalfEdge h = step(corner); h != no_half_edge && h != corner; h = step(h)) {
      const Foot foot = foot_on(h / 3, p);
      if (foot.square < best.square) best = foot;
    }
  };
  go_round([&](HalfEdge h) {
    const HalfEdge back = previous_in_face(h);
    return opposite_[back] == back ? no_half_edge : opposite_[back];
  });
  go_round([&](HalfEdge h) { return opposite_[h] == h ? no_half_edge : next_in_face(opposite_[h]); });
  return best;
}

ReferenceSurface::Foot ReferenceSurface::walk(const Vec3d& p, std::uint32_t from, double enough_square) const {
  Foot here = foot_on(from, p);
  while (!here.is_inside && here.square > enough_square) {
    Foot next = closest_across_edge(here, p);
    if (next.place.triangle == here.place.triangle) next = closest_round_corner(here, p);
    if (next.place.triangle == here.place.triangle) break;
    here = next;
  }
  return here;
}

ReferenceSurface::Foot ReferenceSurface::closest_of(const Face& face, const Vec3d& p, const Foot& start) const {
  const std::span<const BoxTree::Node> nodes = face.tree.nodes();
  // A little more than at the start: of several equally close triangles the lowest is found, wherever the walk ended.
  Foot best = start;
  best.square = start.square * (1 + 1e-9) + std::numeric_limits<double>::min();
  bool is_found = false;
  struct Entry {
    std::uint32_t node = 0;
    double square = 0;
  };
  std::array<Entry, deepest> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.square > best.square) continue;
    const BoxTree::Node& node = nodes[entry.node];
    if (node.is_leaf()) {
      for (const BoxTree::Item& item : face.tree.items_of(node)) {
        if (square_distance(item.box, p) > best.square) continue;
        const Foot foot = foot_on(face.triangles[item.id], p);
        const bool is_later = foot.square == best.square && is_found && foot.place.triangle > best.place.triangle;
        if (foot.square > best.square || is_later) continue;
        best = foot;
        is_found = true;
      }
      continue;
    }
    Entry closer{node.first, square_distance(nodes[node.first].box, p)},
        other{node.first + 1, square_distance(nodes[node.first + 1].box, p)};
    if (other.square < closer.square) std::swap(closer, other);
    if (other.square <= best.square) stack[depth++] = other;
    if (closer.square <= best.square) stack[depth++] = closer;
  }
  return best;
}

SurfacePlace ReferenceSurface::locate(ModelFaceId face, const Vec3d& p, std::uint32_t near, double within) const {
  const Foot foot = walk(p, near);
  return foot.square <= within * within ? foot.place : closest_of(faces_[face], p, foot).place;
}

bool ReferenceSurface::is_within(const Vec3d& p, std::uint32_t near, double distance) const {
  return walk(p, near, distance * distance).square <= distance * distance;
}

Vec3d ReferenceSurface::point_at(ModelEdgeId edge, double arc) const {
  const std::span<const double> arcs = arcs_.of(edge);
  const std::span<const VertexId> path = paths_.of(edge);
  const auto after = static_cast<std::size_t>(std::upper_bound(arcs.begin(), arcs.end(), arc) - arcs.begin());
  if (after == 0) return points_[path.front().index()];
  if (after == arcs.size()) return points_[path.back().index()];
  const Vec3d &a = points_[path[after - 1].index()], &b = points_[path[after].index()];
  const double t = (arc - arcs[after - 1]) / (arcs[after] - arcs[after - 1]);
  return t == 0 ? a : a + t * (b - a);
}

}  // namespace mortise
