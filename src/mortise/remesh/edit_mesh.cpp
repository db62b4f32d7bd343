// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/edit_mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mortise/base/error.h"

namespace mortise {
namespace {

constexpr std::size_t most_checked = 256;  // triangles, after every change, where there are assertions

// Per mesh edge: the model edge it is on, if any.
std::vector<ModelEdgeId> model_edges_of(const MeshTopology& topology, const ClassifiedBrep& model) {
  std::vector<ModelEdgeId> on(topology.edges.size());
  for (std::size_t e = 0; e < model.brep.edges.size(); ++e) {
    const std::span<const VertexId> path = model.classification.path.of(ModelEdgeId(e));
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      const MeshEdgeId step = find_edge(topology, path[k], path[k + 1]);
      MORTISE_CHECK(step.is_valid(), "step of a model edge from vertex " + std::to_string(path[k].value));
      on[step.index()] = ModelEdgeId(e);
    }
  }
  return on;
}

Lists<VertexId, HalfEdge> leaving_half_edges(const SurfaceMesh& mesh) {
  std::vector<HalfEdge> all(3 * mesh.triangles.size());
  for (HalfEdge h = 0; h < all.size(); ++h) all[h] = h;
  return lists_of<VertexId, HalfEdge>(
      all, mesh.points.size(), [&](HalfEdge h) { return origin_of(mesh, h); }, [](HalfEdge h) { return h; });
}

}  // namespace

EditMesh::EditMesh(const SurfaceMesh& mesh, const ClassifiedBrep& model)
    : points(mesh.points), faces_(model.classification.face_of_triangle), entities_(model.classification.entity_of_vertex) {
  for (const Triangle& t : mesh.triangles) corners_.insert(corners_.end(), t.begin(), t.end());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) references.push_back(t);
  link_uses(mesh, build_topology(mesh), model);
  fan_list_.assign(points.size(), no_list);
  leaving_.assign(points.size(), 0);
  const Lists<VertexId, HalfEdge> leaving = leaving_half_edges(mesh);
  for (std::size_t v = 0; v < points.size(); ++v) add_fans(VertexId(v), leaving.of(VertexId(v)));
}

void EditMesh::link_uses(const SurfaceMesh& mesh, const MeshTopology& topology, const ClassifiedBrep& model) {
  links_.resize(3 * mesh.triangles.size());
  model_edges_.resize(links_.size());
  const std::vector<ModelEdgeId> on = model_edges_of(topology, model);
  for (std::size_t e = 0; e < on.size(); ++e) {
    const std::span<const HalfEdge> uses = topology.uses_of(MeshEdgeId(e));
    const bool is_border = uses.size() == 1;  // of a model face, or where the mesh was cut
    if (!on[e].is_valid() && !is_border) {
      MORTISE_CHECK(uses.size() == 2, "edge inside a model face " + std::to_string(e));
      set_opposite(uses[0], uses[1]);
      continue;
    }
    for (std::size_t k = 0; k < uses.size(); ++k) {
      links_[uses[k]] = ring_bit | uses[(k + 1) % uses.size()];
      model_edges_[uses[k]] = on[e];
    }
  }
}

void EditMesh::add_fans(VertexId v, std::span<const HalfEdge> leaving) {
  if (leaving.empty()) return;
  std::vector<HalfEdge> open(leaving.begin(), leaving.end()), fans;
  // Open fans first: from the half-edges that leave along model edges.
  const auto take_fan = [&](HalfEdge first) {
    fans.push_back(first);
    HalfEdge h = first;
    do {
      open.erase(std::find(open.begin(), open.end(), h));
      const HalfEdge back = previous_in_face(h);
      if (is_on_model_edge(back)) return;
      h = links_[back];
    } while (h != first);
  };
  for (const HalfEdge h : leaving) {
    if (is_on_model_edge(h)) take_fan(h);
  }
  while (!open.empty()) take_fan(open.front());
  const bool is_open = is_on_model_edge(fans.front());
  if (entities_[v.index()].dimension == EntityDimension::Face && fans.size() == 1 && !is_open)
    leaving_[v.index()] = fans.front();
  else
    set_new_fans(v, std::move(fans));
}

void EditMesh::set_new_fans(VertexId v, std::vector<HalfEdge> fans) {
  if (free_lists_.empty()) {
    free_lists_.push_back(static_cast<std::uint32_t>(fan_lists_.size()));
    fan_lists_.emplace_back();
  }
  fan_list_[v.index()] = free_lists_.back();
  free_lists_.pop_back();
  fan_lists_[fan_list_[v.index()]] = std::move(fans);
}

FaceId EditMesh::add_triangle(const Triangle& corners, FaceId like) {
  if (free_triangles_.empty()) {
    free_triangles_.emplace_back(faces_.size());
    corners_.resize(corners_.size() + 3);
    links_.resize(links_.size() + 3);
    model_edges_.resize(model_edges_.size() + 3);
    faces_.emplace_back();
    references.emplace_back();
  }
  const FaceId t = free_triangles_.back();
  free_triangles_.pop_back();
  for (std::size_t k = 0; k < 3; ++k) corners_[3 * t.index() + k] = corners[k];
  faces_[t.index()] = faces_[like.index()];
  references[t.index()] = references[like.index()];
  return t;
}

VertexId EditMesh::add_vertex(const Vec3d& point, const ModelEntity& entity) {
  if (free_vertices_.empty()) {
    free_vertices_.emplace_back(points.size());
    points.emplace_back();
    entities_.emplace_back();
    leaving_.push_back(0);
    fan_list_.push_back(no_list);
  }
  const VertexId v = free_vertices_.back();
  free_vertices_.pop_back();
  points[v.index()] = point;
  entities_[v.index()] = entity;
  return v;
}

void EditMesh::remove_triangle(FaceId t) {
  for (std::size_t k = 0; k < 3; ++k) corners_[3 * t.index() + k] = VertexId();
  free_triangles_.push_back(t);
}

void EditMesh::remove_vertex(VertexId v) {
  if (fan_list_[v.index()] != no_list) free_lists_.push_back(fan_list_[v.index()]);
  fan_list_[v.index()] = no_list;
  entities_[v.index()] = {};
  free_vertices_.push_back(v);
}

void EditMesh::set_opposite(HalfEdge a, HalfEdge b) {
  links_[a] = b;
  links_[b] = a;
}

void EditMesh::move_link(HalfEdge from, HalfEdge to) {
  model_edges_[to] = model_edges_[from];
  if (!is_on_model_edge(from)) {
    set_opposite(links_[from], to);
    return;
  }
  HalfEdge before = from;
  while (next_use(before) != from) before = next_use(before);
  links_[to] = before == from ? ring_bit | to : links_[from];
  if (before != from) links_[before] = ring_bit | to;
}

void EditMesh::replace_start(VertexId v, HalfEdge from, HalfEdge to) {
  const std::uint32_t list = fan_list_[v.index()];
  if (list != no_list)
    std::replace(fan_lists_[list].begin(), fan_lists_[list].end(), from, to);
  else if (leaving_[v.index()] == from)
    leaving_[v.index()] = to;
}

bool EditMesh::are_neighbours(VertexId a, VertexId b) const {
  bool found = false;
  for_each_neighbour(a, [&](VertexId w) { found = found || w == b; });
  return found;
}

// Cuts m -> q -> apex off the triangle of u: p -> q; m lies on u. Returns m -> q, which has no link yet.
HalfEdge EditMesh::split_triangle(HalfEdge u, VertexId m) {
  const HalfEdge along = next_in_face(u);
  const VertexId q = target(u);
  const FaceId t = add_triangle({m, q, apex(u)}, face_of(u));
  const auto part = static_cast<HalfEdge>(3 * t.index());
  move_link(along, part + 1);
  replace_start(q, along, part + 1);
  corners_[along] = m;
  set_opposite(along, part + 2);
  model_edges_[part] = model_edges_[u];
  return part;
}

VertexId EditMesh::split_edge(HalfEdge h, const Vec3d& point) {
  const bool on_edge = is_on_model_edge(h);
  const VertexId a = origin(h);
  const ModelEntity entity =
      on_edge ? ModelEntity{EntityDimension::Edge, model_edge(h).value} : ModelEntity{EntityDimension::Face, face(face_of(h)).value};
  Uses uses, parts;
  for_each_use(h, [&](HalfEdge u) { uses.push_back(u); });
  const VertexId m = add_vertex(point, entity);
  for (const HalfEdge u : uses) parts.push_back(split_triangle(u, m));
  if (!on_edge) {
    set_opposite(uses[0], parts[1]);
    set_opposite(uses[1], parts[0]);
    leaving_[m.index()] = parts[0];
    MORTISE_ASSERT(is_sound_if_small());
    return m;
  }
  for (std::size_t k = 0; k < uses.size(); ++k) {
    const std::size_t next = (k + 1) % uses.size();
    const bool from_a = origin(uses[k]) == a, next_from_a = origin(uses[next]) == a;
    // Each half of the edge has a ring: one of it starts at a use, or at the part of it.
    links_[from_a ? uses[k] : parts[k]] = ring_bit | (next_from_a ? uses[next] : parts[next]);
    links_[from_a ? parts[k] : uses[k]] = ring_bit | (next_from_a ? parts[next] : uses[next]);
  }
  set_new_fans(m, {parts.begin(), parts.end()});
  MORTISE_ASSERT(is_sound_if_small());
  return m;
}

VertexId EditMesh::split_in_three(FaceId t, const Vec3d& point) {
  const VertexId m = add_vertex(point, {EntityDimension::Face, face(t).value});
  const auto ab = static_cast<HalfEdge>(3 * t.index()), bm = ab + 1, ma = ab + 2;  // as they are afterwards
  const auto cut_off = [&](HalfEdge side) {
    const auto part = static_cast<HalfEdge>(3 * add_triangle({origin(side), target(side), m}, t).index());
    move_link(side, part);
    replace_start(origin(side), side, part);
    return part;
  };
  const HalfEdge bc = cut_off(bm), ca = cut_off(ma);
  corners_[ma] = m;
  set_opposite(bm, bc + 2);
  set_opposite(bc + 1, ca + 2);
  set_opposite(ca + 1, ma);
  leaving_[m.index()] = ma;
  MORTISE_ASSERT(is_sound_if_small());
  return m;
}

void EditMesh::swap_edge(HalfEdge h) {
  const HalfEdge t = links_[h], hn = next_in_face(h), hp = previous_in_face(h), tn = next_in_face(t), tp = previous_in_face(t);
  const VertexId a = origin(h), b = origin(t), c = origin(hp), d = origin(tp);
  // Half-edges of the four sides move round by one place.
  const std::array<std::array<HalfEdge, 2>, 4> moves{{{hp, hn}, {tn, hp}, {tp, tn}, {hn, tp}}};  // from, to
  std::array<std::uint32_t, 4> links{};
  std::array<ModelEdgeId, 4> edges{};
  std::array<HalfEdge, 4> before{};
  for (std::size_t k = 0; k < 4; ++k) {
    const HalfEdge from = moves[k][0];
    links[k] = links_[from];
    edges[k] = model_edges_[from];
    before[k] = from;
    while (is_on_model_edge(from) && next_use(before[k]) != from) before[k] = next_use(before[k]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [from, to] = moves[k];
    model_edges_[to] = edges[k];
    if ((links[k] & ring_bit) == 0) {
      set_opposite(links[k], to);
    } else {
      links_[to] = before[k] == from ? ring_bit | to : links[k];
      if (before[k] != from) links_[before[k]] = ring_bit | to;
    }
  }
  replace_start(a, h, hp);
  replace_start(a, tn, hp);
  replace_start(b, t, tp);
  replace_start(b, hn, tp);
  replace_start(c, hp, hn);
  replace_start(d, tp, tn);
  corners_[h] = d;
  corners_[hn] = c;
  corners_[hp] = a;
  corners_[t] = c;
  corners_[tn] = d;
  corners_[tp] = b;
  MORTISE_ASSERT(is_sound_if_small());
}

bool EditMesh::can_collapse(HalfEdge h, VertexId gone) const {
  const VertexId a = gone, b = other_end(h, gone);
  if (!may_leave_along(h, a)) return false;
  SmallList<VertexId, 4> apexes;
  SmallList<VertexId, 16> of_b;
  bool is_fine = true;
  for_each_use(h, [&](HalfEdge u) {
    const HalfEdge n = next_in_face(u), p = previous_in_face(u);
    is_fine = is_fine && !(is_on_model_edge(n) && is_on_model_edge(p));
    apexes.push_back(apex(u));
  });
  if (!is_fine) return false;
  const auto valence = [&](VertexId v) {
    std::size_t count = 0;
    for_each_leaving(v, [&](HalfEdge) { ++count; });
    return count;
  };
  for (const VertexId x : apexes) {
    if (is_inside_face(x) && valence(x) < 4) return false;
  }
  if (is_inside_face(b) && valence(a) + valence(b) < 7) return false;
  const auto is_apex = [&](VertexId w) { return std::find(apexes.begin(), apexes.end(), w) != apexes.end(); };
  for_each_neighbour(b, [&](VertexId w) { of_b.push_back(w); });
  for_each_neighbour(a, [&](VertexId w) {
    const bool is_common = std::find(of_b.begin(), of_b.end(), w) != of_b.end();
    is_fine = is_fine && (!is_common || is_apex(w));
  });
  // Nor may a triangle of a come to lie on one of b, as in a tetrahedron.
  for_each_leaving(a, [&](HalfEdge g) {
    if (!is_fine || !is_apex(target(g)) || !is_apex(apex(g))) return;
    for_each_use(next_in_face(g), [&](HalfEdge u) { is_fine = is_fine && apex(u) != b; });
  });
  return is_fine;
}

// The triangle on an edge that is gone goes: its neighbours across the other two sides become neighbours. One of these may be a model edge.
void EditMesh::close_gap(HalfEdge u, HalfEdge from_a) {
  const HalfEdge n = next_in_face(u), p = previous_in_face(u);
  const HalfEdge from_b = from_a == n ? p : n;
  const VertexId b = origin(u), x = origin(p);
  if (is_on_model_edge(from_a) || is_on_model_edge(from_b)) {
    const HalfEdge on_edge = is_on_model_edge(from_a) ? from_a : from_b;
    const HalfEdge stays = links_[on_edge == from_a ? from_b : from_a];
    move_link(on_edge, stays);
    replace_start(origin(on_edge), on_edge, stays);
  } else {
    const HalfEdge beyond_n = links_[n], beyond_p = links_[p];
    set_opposite(beyond_n, beyond_p);
    replace_start(b, u, beyond_p);
    replace_start(b, n, beyond_p);
    replace_start(x, p, beyond_n);
  }
  remove_triangle(face_of(u));
}

void EditMesh::collapse_edge(HalfEdge h, VertexId gone) {
  const VertexId a = gone, b = other_end(h, gone);
  Uses uses, from_a;
  SmallList<HalfEdge, 16> leaving;
  for_each_use(h, [&](HalfEdge u) { uses.push_back(u); });
  for_each_leaving(a, [&](HalfEdge g) { leaving.push_back(g); });
  for (const HalfEdge u : uses) {
    const bool is_from_b = origin(u) == b;
    from_a.push_back(is_from_b ? next_in_face(u) : previous_in_face(u));
    if (!is_from_b || !is_on_model_edge(u)) continue;
    // The fan of b on this side starts with u; now it starts where that of a does.
    HalfEdge first = next_in_face(u);
    while (!is_on_model_edge(first)) first = next_in_face(links_[first]);
    replace_start(b, u, first);
  }
  for (const HalfEdge g : leaving) corners_[g] = b;
  for (std::size_t k = 0; k < uses.size(); ++k) close_gap(uses[k], from_a[k]);
  remove_vertex(a);
  MORTISE_ASSERT(is_sound_if_small());
}

bool EditMesh::is_sound_if_small() const {
  if (triangle_count() <= most_checked) check();
  return true;
}

void EditMesh::check() const {
  const auto require = [](bool holds, const char* what, std::size_t id) {
    if (!holds) throw Error(ErrorCode::InternalError, "edit_mesh", std::string(what) + " " + std::to_string(id));
  };
  std::vector<std::uint32_t> seen(points.size(), 0), used(points.size(), 0);
  for (HalfEdge h = 0; h < corners_.size(); ++h) {
    if (!has(h)) continue;
    require(has(origin(h)), "a corner of no vertex", h);
    require(origin(h) != target(h), "a triangle that repeats a vertex, half-edge", h);
    ++used[origin(h).index()];
    if (!is_on_model_edge(h)) {
      const HalfEdge t = links_[h];
      require(links_[t] == h && origin(t) == target(h) && target(t) == origin(h), "no opposite of half-edge", h);
      require(faces_[t / 3] == faces_[h / 3], "two model faces beside half-edge", h);
      continue;
    }
    const HalfEdge u = next_use(h);
    require(model_edges_[h].is_valid() || u == h, "no model edge under half-edge", h);
    require(has(u) && is_on_model_edge(u) && model_edges_[u] == model_edges_[h] &&
                sorted_ends(origin(u), target(u)) == sorted_ends(origin(h), target(h)),
            "a ring of different edges at half-edge", h);
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!has(VertexId(v)) || used[v] == 0) continue;
    for_each_leaving(VertexId(v), [&](HalfEdge h) {
      require(has(h) && origin(h) == VertexId(v), "a fan of another vertex at vertex", v);
      ++seen[v];
      require(seen[v] <= used[v], "a fan too long at vertex", v);
    });
    require(seen[v] == used[v], "a triangle in no fan at vertex", v);
    for (const HalfEdge first : fans_of(VertexId(v)))
      require(is_on_model_edge(first) || entities_[v].dimension != EntityDimension::Edge, "a fan that starts inside a face at vertex", v);
  }
}

}  // namespace mortise
