// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A classified mesh that is changed by one edge at a time: split, collapse, swap (paper 7.4, Fig. 20). Geometry decides elsewhere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mortise/base/small_list.h"
#include "mortise/brep/brep.h"
#include "mortise/mesh/topology.h"

namespace mortise {

/// Triangles with their neighbours, cut along model edges: across these a ring joins all uses of one mesh edge, however many.
///
/// Every model face is a manifold with a boundary. The triangles round a vertex form fans: one closed fan inside a face; on a model edge
/// one open fan for every use of it; any number at a model vertex. Triangles and vertices that are gone leave holes in the numbering.
class EditMesh {
 public:
  /// @param model  of the mesh
  EditMesh(const SurfaceMesh& mesh, const ClassifiedBrep& model);

  std::vector<Vec3d> points;              ///< per vertex
  std::vector<std::uint32_t> references;  ///< per triangle: a triangle of the original mesh it lies near, at first itself

  [[nodiscard]] std::size_t vertex_count() const { return points.size(); }    ///< with holes
  [[nodiscard]] std::size_t triangle_count() const { return faces_.size(); }  ///< with holes
  [[nodiscard]] std::size_t live_triangle_count() const { return faces_.size() - free_triangles_.size(); }
  [[nodiscard]] std::size_t half_edge_count() const { return corners_.size(); }
  [[nodiscard]] bool has(VertexId v) const { return entities_[v.index()].dimension != EntityDimension::None; }
  [[nodiscard]] bool has(FaceId t) const { return corners_[3 * t.index()].is_valid(); }
  [[nodiscard]] bool has(HalfEdge h) const { return corners_[h].is_valid(); }

  [[nodiscard]] VertexId origin(HalfEdge h) const { return corners_[h]; }
  [[nodiscard]] VertexId target(HalfEdge h) const { return corners_[next_in_face(h)]; }
  [[nodiscard]] VertexId apex(HalfEdge h) const { return corners_[previous_in_face(h)]; }
  [[nodiscard]] Triangle triangle(FaceId t) const {
    return {corners_[3 * t.index()], corners_[3 * t.index() + 1], corners_[3 * t.index() + 2]};
  }
  [[nodiscard]] ModelFaceId face(FaceId t) const { return faces_[t.index()]; }
  /// The lowest entity it lies on; of dimension None when it is gone.
  [[nodiscard]] const ModelEntity& entity(VertexId v) const { return entities_[v.index()]; }

  /// Or where the mesh was cut out of a larger one.
  [[nodiscard]] bool is_on_model_edge(HalfEdge h) const { return (links_[h] & ring_bit) != 0; }
  /// The half-edge on the other side; of one inside a face.
  [[nodiscard]] HalfEdge opposite(HalfEdge h) const { return links_[h]; }
  /// The next half-edge of the same mesh edge, in a circle; of one on a model edge.
  [[nodiscard]] HalfEdge next_use(HalfEdge h) const { return links_[h] & ~ring_bit; }
  /// Of a half-edge on one; invalid where the mesh was cut.
  [[nodiscard]] ModelEdgeId model_edge(HalfEdge h) const { return model_edges_[h]; }

  /// One closed fan, free to move in its face?
  [[nodiscard]] bool is_inside_face(VertexId v) const { return fan_list_[v.index()] == no_list; }
  /// One open fan for every use of the model edge, free to move along it?
  [[nodiscard]] bool is_inside_edge(VertexId v) const { return entities_[v.index()].dimension == EntityDimension::Edge; }

  /// Does the edge lie on the entity this end of it is free to move in?
  [[nodiscard]] bool may_leave_along(HalfEdge h, VertexId v) const {
    return is_inside_face(v) || (is_inside_edge(v) && is_on_model_edge(h));
  }

  /// Calls visit(h) for every half-edge that leaves v, fan by fan, counterclockwise in each.
  template <class Visit>
  void for_each_leaving(VertexId v, Visit visit) const {
    for (const HalfEdge first : fans_of(v)) {
      HalfEdge h = first;
      do {
        visit(h);
        const HalfEdge back = previous_in_face(h);
        if (is_on_model_edge(back)) break;
        h = links_[back];
      } while (h != first);
    }
  }

  /// Calls visit(w) for every neighbour of v; those across edges of more triangles may come several times.
  template <class Visit>
  void for_each_neighbour(VertexId v, Visit visit) const {
    for_each_leaving(v, [&](HalfEdge h) {
      visit(target(h));
      if (is_on_model_edge(previous_in_face(h))) visit(apex(h));
    });
  }

  [[nodiscard]] bool are_neighbours(VertexId a, VertexId b) const;
  /// Calls visit(u) for every half-edge of the same mesh edge, h among them.
  template <class Visit>
  void for_each_use(HalfEdge h, Visit visit) const {
    if (!is_on_model_edge(h)) {
      visit(h);
      visit(links_[h]);
      return;
    }
    HalfEdge u = h;
    do {
      const HalfEdge next = next_use(u);
      visit(u);
      u = next;
    } while (u != h);
  }

  ///      c              c
  ///     / \            /|\      every triangle
  ///    a---b    ->    a-m-b     of the edge in two,
  ///     \ /            \|/      any number of them
  ///      d              d
  /// @return m, on the entity the edge is on
  VertexId split_edge(HalfEdge h, const Vec3d& point);

  ///        c              c
  ///       / \            /|\     a triangle
  ///      /   \    ->    / m \    in three
  ///     a-----b        a-----b
  /// @return m, inside the face
  VertexId split_in_three(FaceId t, const Vec3d& point);

  ///      c              c
  ///     / \            /|\      the edge of two triangles
  ///    a---b    ->    a | b     inside a face;
  ///     \ /            \|/      h runs from d to c
  ///      d              d
  void swap_edge(HalfEdge h);

  ///      c              c
  ///     / \             |
  ///    a---b    ->      b       a goes, all that ended there ends at b
  ///     \ /             |
  ///      d              d
  /// @param gone  a: either end; can_collapse(h, gone)
  void collapse_edge(HalfEdge h, VertexId gone);

  /// Does the surface, and every entity, stay what it is when this end goes to the other?
  [[nodiscard]] bool can_collapse(HalfEdge h, VertexId gone) const;

  [[nodiscard]] VertexId other_end(HalfEdge h, VertexId v) const { return origin(h) == v ? target(h) : origin(h); }

  /// @throws Error{InternalError} naming what does not fit. O(n); for tests.
  void check() const;

 private:
  static constexpr std::uint32_t ring_bit = 0x80000000U;
  static constexpr std::uint32_t no_list = 0xffffffffU;

  [[nodiscard]] std::span<const HalfEdge> fans_of(VertexId v) const {
    const std::uint32_t list = fan_list_[v.index()];
    return list == no_list ? std::span<const HalfEdge>(&leaving_[v.index()], 1) : std::span<const HalfEdge>(fan_lists_[list]);
  }

  using Uses = SmallList<HalfEdge, 4>;

  void link_uses(const SurfaceMesh& mesh, const MeshTopology& topology, const ClassifiedBrep& model);
  void find_fans();
  void add_fans(VertexId v, std::span<const HalfEdge> leaving);

  FaceId add_triangle(const Triangle& corners, FaceId like);
  [[nodiscard]] bool is_sound_if_small() const;
  VertexId add_vertex(const Vec3d& point, const ModelEntity& entity);
  void remove_triangle(FaceId t);
  void remove_vertex(VertexId v);

  /// `to` takes the place of `from` beside its neighbours.
  void move_link(HalfEdge from, HalfEdge to);
  void set_opposite(HalfEdge a, HalfEdge b);
  void replace_start(VertexId v, HalfEdge from, HalfEdge to);
  void set_new_fans(VertexId v, std::vector<HalfEdge> fans);
  HalfEdge split_triangle(HalfEdge u, VertexId m);
  void close_gap(HalfEdge from_a, HalfEdge from_b);

  std::vector<VertexId> corners_;                 // per half-edge
  std::vector<std::uint32_t> links_;              // per half-edge: the opposite one, or ring_bit and the next use
  std::vector<ModelEdgeId> model_edges_;          // per half-edge
  std::vector<ModelFaceId> faces_;                // per triangle
  std::vector<ModelEntity> entities_;             // per vertex
  std::vector<HalfEdge> leaving_;                 // per vertex inside a face: any half-edge that leaves it
  std::vector<std::uint32_t> fan_list_;           // per vertex: its list of fans, or no_list
  std::vector<std::vector<HalfEdge>> fan_lists_;  // the first half-edge of every fan: that on a model edge, if one is
  std::vector<VertexId> free_vertices_;
  std::vector<FaceId> free_triangles_;
  std::vector<std::uint32_t> free_lists_;
};

}  // namespace mortise
