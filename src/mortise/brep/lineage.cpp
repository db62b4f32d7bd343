// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Links from facets and their sources; the rest follows from what lies on these.
#include "mortise/brep/lineage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "mortise/base/error.h"
#include "mortise/geom/length.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/ray_crossing.h"

namespace mortise {
namespace {

// Per half-edge of the mesh: its model edge, or none.
std::vector<ModelEdgeId> edges_of_half_edges(const ModelView& view) {
  std::vector<std::pair<std::array<VertexId, 2>, ModelEdgeId>> segments;
  const Classification& on = view.model.classification;
  for (std::size_t e = 0; e < on.path.size(); ++e) {
    const auto path = on.path.of(ModelEdgeId(e));
    for (std::size_t i = 0; i + 1 < path.size(); ++i) segments.emplace_back(sorted_ends(path[i], path[i + 1]), ModelEdgeId(e));
  }
  std::sort(segments.begin(), segments.end());
  std::vector<ModelEdgeId> edges(3 * view.mesh.triangles.size());
  const auto is_inside_face = [&](VertexId v) { return on.entity_of_vertex[v.index()].dimension == EntityDimension::Face; };
  for (std::size_t h = 0; h < edges.size(); ++h) {
    const Triangle& t = view.mesh.triangles[h / 3];
    const VertexId a = t[h % 3], b = t[(h + 1) % 3];
    if (is_inside_face(a) || is_inside_face(b)) continue;
    const auto key = std::pair(sorted_ends(a, b), ModelEdgeId(0));
    const auto found = std::lower_bound(segments.begin(), segments.end(), key);
    if (found != segments.end() && found->first == key.first) edges[h] = found->second;
  }
  return edges;
}

// Functions, not lambdas: one instance of the sort for both.
bool is_before_by_result(const LineageLink& a, const LineageLink& b) { return std::tie(a.result, a.source) < std::tie(b.result, b.source); }
bool is_before_by_source(const LineageLink& a, const LineageLink& b) { return std::tie(a.source, a.result) < std::tie(b.source, b.result); }

class LineageTracer {
 public:
  LineageTracer(const ModelView& result, const Provenance& provenance, std::span<const ModelView> operands)
      : result_(result), provenance_(provenance), operands_(operands) {}

  [[nodiscard]] Lineage trace() {
    refuse_unknown_sources();
    add_faces();
    add_vertices();
    add_edges();
    add_regions();
    return summed_links();
  }

 private:
  void refuse_unknown_sources() const {
    for (std::size_t t = 0; t < result_.mesh.triangles.size(); ++t) {
      for_each_source(provenance_, FaceId(t), [&](const FacetOrigin& s) {
        if (s.operand < operands_.size() && s.face < operands_[s.operand].mesh.triangles.size()) return;
        throw Error(ErrorCode::InvalidArgument, "trace_lineage",
                    "facet " + std::to_string(t) + " comes from a triangle that no operand has");
      });
    }
  }

  [[nodiscard]] const Vec3d& position(VertexId v) const { return result_.mesh.points[v.index()]; }
  [[nodiscard]] const Classification& on() const { return result_.model.classification; }

  void link(EntityDimension dimension, std::uint32_t result, std::uint32_t operand, std::uint32_t source, double measure) {
    links_.push_back({{dimension, result}, {operand, {dimension, source}}, measure});
  }

  void add_faces() {
    for (std::size_t t = 0; t < result_.mesh.triangles.size(); ++t) {
      const Triangle& corners = result_.mesh.triangles[t];
      const double area = triangle_area(position(corners[0]), position(corners[1]), position(corners[2]));
      for_each_source(provenance_, FaceId(t), [&](const FacetOrigin& s) {
        const ModelFaceId source = operands_[s.operand].model.classification.face_of_triangle[s.face];
        link(EntityDimension::Face, on().face_of_triangle[t].value, s.operand, source.value, area);
      });
    }
  }

  // Corners of sources at the place of a corner of their facet.
  void add_vertices() {
    for (std::size_t t = 0; t < result_.mesh.triangles.size(); ++t) {
      for (const VertexId v : result_.mesh.triangles[t]) {
        const ModelEntity entity = on().entity_of_vertex[v.index()];
        if (entity.dimension != EntityDimension::Vertex) continue;
        for_each_source(provenance_, FaceId(t), [&](const FacetOrigin& s) {
          const ModelView& operand = operands_[s.operand];
          for (const VertexId w : operand.mesh.triangles[s.face]) {
            const ModelEntity source = operand.model.classification.entity_of_vertex[w.index()];
            if (source.dimension == EntityDimension::Vertex && operand.mesh.points[w.index()] == position(v))
              link(EntityDimension::Vertex, entity.id, s.operand, source.id, 1);
          }
        });
      }
    }
  }

  // Mesh edges on model edges, against the sides of the sources of the facets at them; each counts once.
  void add_edges() {
    const std::vector<ModelEdgeId> edges = edges_of_half_edges(result_);
    std::vector<std::vector<ModelEdgeId>> operand_edges;
    for (const ModelView& operand : operands_) operand_edges.push_back(edges_of_half_edges(operand));
    struct EdgeLink {
      VertexId low, high;  // of the mesh edge
      std::uint32_t result, operand, source;
      auto operator<=>(const EdgeLink&) const = default;
    };
    std::vector<EdgeLink> found;
    for (std::size_t h = 0; h < edges.size(); ++h) {
      if (!edges[h].is_valid()) continue;
      const Triangle& corners = result_.mesh.triangles[h / 3];
      const VertexId a = corners[h % 3], b = corners[(h + 1) % 3];
      for_each_source(provenance_, FaceId(h / 3), [&](const FacetOrigin& s) {
        for (std::size_t k = 0; k < 3; ++k) {
          const ModelEdgeId source = operand_edges[s.operand][3 * std::size_t{s.face} + k];
          if (source.is_valid() && lies_on_side(a, b, operands_[s.operand].mesh, s.face, k))
            found.push_back({std::min(a, b), std::max(a, b), edges[h].value, s.operand, source.value});
        }
      });
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const EdgeLink& f : found) {
      link(EntityDimension::Edge, f.result, f.operand, f.source, length(position(f.high) - position(f.low)));
    }
  }

  [[nodiscard]] bool lies_on_side(VertexId a, VertexId b, const SurfaceMesh& operand, std::uint32_t face, std::size_t k) const {
    const Triangle& t = operand.triangles[face];
    const Vec3d &p = operand.points[t[k].index()], &q = operand.points[t[(k + 1) % 3].index()];
    return is_near_line(position(a), p, q) && is_near_line(position(b), p, q);
  }

  static bool is_near_line(const Vec3d& at, const Vec3d& p, const Vec3d& q) {
    if (at == p || at == q) return true;
    constexpr double roundings = 0x1p-49;
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) largest = std::max({largest, std::fabs(at[i]), std::fabs(p[i]), std::fabs(q[i])});
    return height_over(p, q, at) <= roundings * largest;
  }

  // Faces know the regions of their own operand on both sides; of other operands they know whether they contain these.
  void add_regions() {
    for (std::uint32_t k = 0; k < operands_.size(); ++k) voids_.push_back(find_voids(operands_[k].mesh, operands_[k].model));
    std::map<std::uint32_t, RegionSigns> signs;
    for (std::size_t t = 0; t < result_.mesh.triangles.size(); ++t) {
      const ModelFace& face = result_.model.brep.faces[on().face_of_triangle[t]];
      look_at_side(FaceId(t), false, signs[face.region_behind.value]);
      look_at_side(FaceId(t), true, signs[face.region_in_front.value]);
    }
    const std::vector<std::uint8_t> is_void = find_voids(result_.mesh, result_.model);
    for (auto& [region, seen] : signs) {
      if (region != 0 && is_void[region] == 0) link_region(region, seen);
    }
  }

  struct RegionSigns {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;  // operand and region of it, next to faces
    std::vector<std::uint32_t> covering;                        // operands that contain it
    FaceId facet;                                               // one of its boundary
  };

  void look_at_side(FaceId t, bool is_front, RegionSigns& signs) const {
    signs.facet = t;
    for_each_source(provenance_, t, [&](const FacetOrigin& s) {
      const ModelView& operand = operands_[s.operand];
      const ModelFace& source = operand.model.brep.faces[operand.model.classification.face_of_triangle[s.face]];
      const ModelRegionId region = is_front != s.is_flipped ? source.region_in_front : source.region_behind;
      const std::pair<std::uint32_t, std::uint32_t> sign(s.operand, region.value);
      if (signs.seen.empty() || signs.seen.back() != sign) signs.seen.push_back(sign);
    });
    const std::vector<std::uint32_t>& sets = is_front ? provenance_.covering_front : provenance_.covering;
    if (sets.empty()) return;
    const std::vector<std::uint32_t>& covering = provenance_.covering_sets[sets[t.index()]];
    if (signs.covering != covering) signs.covering.insert(signs.covering.end(), covering.begin(), covering.end());
  }

  void link_region(std::uint32_t region, RegionSigns& signs) {
    std::sort(signs.seen.begin(), signs.seen.end());
    signs.seen.erase(std::unique(signs.seen.begin(), signs.seen.end()), signs.seen.end());
    std::sort(signs.covering.begin(), signs.covering.end());
    signs.covering.erase(std::unique(signs.covering.begin(), signs.covering.end()), signs.covering.end());
    const double volume = measure(result_, {EntityDimension::Region, region});
    for (const auto& [operand, source] : signs.seen) {
      if (is_material(operand, source)) link(EntityDimension::Region, region, operand, source, volume);
    }
    for (const std::uint32_t k : signs.covering) {
      const auto is_of_k = [k](const auto& sign) { return sign.first == k; };
      if (std::any_of(signs.seen.begin(), signs.seen.end(), is_of_k)) continue;
      if (const auto source = region_round(k, signs.facet)) link(EntityDimension::Region, region, k, *source, volume);
    }
  }

  [[nodiscard]] bool is_material(std::uint32_t operand, std::uint32_t region) const { return region != 0 && voids_[operand][region] == 0; }

  // The region of an operand that contains a facet none of its faces touches.
  [[nodiscard]] std::optional<std::uint32_t> region_round(std::uint32_t k, FaceId facet) const {
    const Brep& brep = operands_[k].model.brep;
    std::optional<std::uint32_t> only;
    std::size_t count = 0;
    for (std::uint32_t r = 1; r < brep.region_count; ++r) {
      if (!is_material(k, r)) continue;
      only = r;
      ++count;
    }
    if (count <= 1) return only;
    for (std::uint32_t r = 1; r < brep.region_count; ++r) {
      if (is_material(k, r) && winds_round(operands_[k], r, facet)) return r;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool winds_round(const ModelView& operand, std::uint32_t region, FaceId facet) const {
    const Triangle& corners = result_.mesh.triangles[facet.index()];
    const RayStart start{position(corners[0]), position(corners[1]), position(corners[2])};
    const Box3 ray = ray_box(start);
    int winding = 0;
    for (std::size_t t = 0; t < operand.mesh.triangles.size(); ++t) {
      const ModelFace& face = operand.model.brep.faces[operand.model.classification.face_of_triangle[t]];
      const bool is_behind = face.region_behind.value == region, is_in_front = face.region_in_front.value == region;
      if (is_behind == is_in_front) continue;
      std::array<Vec3d, 3> p;
      Box3 box;
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = operand.mesh.points[operand.mesh.triangles[t][i].index()];
        box.extend(p[i]);
      }
      if (boxes_meet(box, ray)) winding += (is_behind ? 1 : -1) * winding_step(p[0], p[1], p[2], start);
    }
    return winding != 0;
  }

  // Links between the same two become one, measures added in the order they were found.
  [[nodiscard]] Lineage summed_links() {
    std::stable_sort(links_.begin(), links_.end(), is_before_by_result);
    Lineage lineage;
    for (const LineageLink& l : links_) {
      if (lineage.by_result.empty() || is_before_by_result(lineage.by_result.back(), l)) {
        lineage.by_result.push_back(l);
      } else if (l.result.dimension == EntityDimension::Face || l.result.dimension == EntityDimension::Edge) {
        lineage.by_result.back().measure += l.measure;
      }
    }
    lineage.by_source = lineage.by_result;
    std::stable_sort(lineage.by_source.begin(), lineage.by_source.end(), is_before_by_source);
    return lineage;
  }

  const ModelView& result_;
  const Provenance& provenance_;
  std::span<const ModelView> operands_;
  std::vector<std::vector<std::uint8_t>> voids_;  // per operand and region
  std::vector<LineageLink> links_;
};

template <class IsBefore>
std::span<const LineageLink> equal_links(const std::vector<LineageLink>& links, const LineageLink& link, IsBefore is_before) {
  const auto [first, last] = std::equal_range(links.begin(), links.end(), link, is_before);
  return std::span(links).subspan(static_cast<std::size_t>(first - links.begin()), static_cast<std::size_t>(last - first));
}

}  // namespace

std::span<const LineageLink> Lineage::sources_of(const ModelEntity& result) const {
  return equal_links(by_result, {result, {}, 0}, [](const LineageLink& a, const LineageLink& b) { return a.result < b.result; });
}

std::span<const LineageLink> Lineage::results_of(const OperandEntity& source) const {
  return equal_links(by_source, {{}, source, 0}, [](const LineageLink& a, const LineageLink& b) { return a.source < b.source; });
}

Lineage trace_lineage(const ModelView& result, const Provenance& provenance, std::span<const ModelView> operands) {
  return LineageTracer(result, provenance, operands).trace();
}

}  // namespace mortise
