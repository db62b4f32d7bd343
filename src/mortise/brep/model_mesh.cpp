// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Entities with their elements, dimension by dimension; names last.
#include "mortise/brep/model_mesh.h"

#include <algorithm>
#include <map>
#include <string>

namespace mortise {
namespace {

constexpr std::uint32_t none = 0xffffffffU;

class ModelMesh {
 public:
  explicit ModelMesh(const ModelView& view)
      : view_(view), brep_(view.model.brep), on_(view.model.classification), is_void_(find_voids(view.mesh, view.model)) {}

  [[nodiscard]] EntityMesh make(std::span<const Attribute> attributes) {
    result_.points = view_.mesh.points;
    add_vertices();
    add_edges();
    add_faces();
    add_regions();
    for (const Attribute& a : attributes) {
      for (const ModelEntity& target : a.targets) add_name(target, a.name);
    }
    name_by_labels();
    if (!result_.names.empty()) name_the_rest();
    return std::move(result_);
  }

 private:
  static std::int32_t tag_of(std::uint32_t id) { return static_cast<std::int32_t>(id) + 1; }

  std::vector<MeshEntity>& entities(EntityDimension d) { return result_.entities[static_cast<std::size_t>(d)]; }

  void add_vertices() {
    for (std::uint32_t v = 0; v < brep_.vertex_count; ++v) {
      place_[0].push_back(v);
      entities(EntityDimension::Vertex).push_back({tag_of(v)});
      result_.point_elements.push_back(on_.mesh_vertex[ModelVertexId(v)]);
      result_.point_entities.push_back(v);
    }
  }

  void add_edges() {
    for (std::uint32_t e = 0; e < brep_.edges.size(); ++e) {
      const ModelEdge& edge = brep_.edges[ModelEdgeId(e)];
      place_[1].push_back(edge.is_seam ? none : static_cast<std::uint32_t>(entities(EntityDimension::Edge).size()));
      if (edge.is_seam) continue;
      MeshEntity entity{tag_of(e)};
      entity.boundary = {tag_of(edge.start.value), tag_of(edge.end.value)};
      entities(EntityDimension::Edge).push_back(std::move(entity));
      const auto path = on_.path.of(ModelEdgeId(e));
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        result_.lines.push_back({path[i], path[i + 1]});
        result_.line_entities.push_back(place_[1][e]);
      }
    }
  }

  void add_faces() {
    for (std::uint32_t f = 0; f < brep_.faces.size(); ++f) {
      place_[2].push_back(f);
      MeshEntity entity{tag_of(f)};
      for (const LoopId l : brep_.loops_of_face.of(ModelFaceId(f))) {
        for (const EdgeUse& use : brep_.uses_of_loop.of(l)) {
          if (!brep_.edges[use.edge].is_seam) entity.boundary.push_back(use.is_reversed ? -tag_of(use.edge.value) : tag_of(use.edge.value));
        }
      }
      entities(EntityDimension::Face).push_back(std::move(entity));
    }
    result_.triangles = view_.mesh.triangles;
    for (const ModelFaceId f : on_.face_of_triangle) result_.triangle_entities.push_back(f.value);
  }

  // Sheets inside a region do not bound it.
  void add_regions() {
    for (std::uint32_t r = 0; r < brep_.region_count; ++r) {
      const bool is_left_out = r == 0 || is_void_[r] != 0;
      place_[3].push_back(is_left_out ? none : static_cast<std::uint32_t>(entities(EntityDimension::Region).size()));
      if (is_left_out) continue;
      MeshEntity entity{static_cast<std::int32_t>(r)};
      for (const ShellId s : brep_.shells_of_region.of(ModelRegionId(r))) {
        for (const FaceSide& side : brep_.sides_of_shell.of(s)) {
          const ModelFace& face = brep_.faces[side.face];
          if (face.region_behind != face.region_in_front)
            entity.boundary.push_back(side.is_front ? -tag_of(side.face.value) : tag_of(side.face.value));
        }
      }
      entities(EntityDimension::Region).push_back(std::move(entity));
    }
  }

  void add_name(const ModelEntity& target, const std::string& name) {
    const auto dimension = static_cast<std::uint8_t>(target.dimension);
    const std::uint32_t place = place_[dimension].at(target.id);
    if (place == none) return;
    const auto [entry, is_new] = name_numbers_.try_emplace({dimension, name}, static_cast<std::uint32_t>(result_.names.size()));
    if (is_new) result_.names.push_back({dimension, ++last_tag_[dimension], name});
    std::vector<std::uint32_t>& names = entities(target.dimension)[place].names;
    if (std::find(names.begin(), names.end(), entry->second) == names.end()) names.push_back(entry->second);
  }

  void name_by_labels() {
    const SurfaceMesh& mesh = view_.mesh;
    for (std::size_t t = 0; t < mesh.face_labels.size(); ++t) {
      const std::string& label = mesh.label_names[mesh.face_labels[t]];
      if (!label.empty()) add_name({EntityDimension::Face, on_.face_of_triangle[t].value}, label);
    }
  }

  void name_the_rest() {
    for (const EntityDimension d : {EntityDimension::Face, EntityDimension::Region}) {
      const std::vector<std::uint32_t>& places = place_[static_cast<std::size_t>(d)];
      for (std::uint32_t id = 0; id < places.size(); ++id) {
        if (places[id] == none || !entities(d)[places[id]].names.empty()) continue;
        const std::int32_t tag = entities(d)[places[id]].tag;
        add_name({d, id}, free_name(d, (d == EntityDimension::Face ? "face " : "region ") + std::to_string(tag)));
      }
    }
  }

  // What was read from a file may have such names already.
  [[nodiscard]] std::string free_name(EntityDimension d, const std::string& name) const {
    const auto is_taken = [&](const std::string& text) { return name_numbers_.count({static_cast<std::uint8_t>(d), text}) != 0; };
    std::string free = name;
    for (std::size_t k = 2; is_taken(free); ++k) free = name + "_" + std::to_string(k);
    return free;
  }

  const ModelView& view_;
  const Brep& brep_;
  const Classification& on_;
  std::vector<std::uint8_t> is_void_;
  EntityMesh result_;
  std::array<std::vector<std::uint32_t>, 4> place_;  // per dimension and id: index into the entities, or none
  std::map<std::pair<std::uint8_t, std::string>, std::uint32_t> name_numbers_;
  std::array<std::int32_t, 4> last_tag_{};
};

}  // namespace

EntityMesh entity_mesh_of(const ModelView& view, std::span<const Attribute> attributes) { return ModelMesh(view).make(attributes); }

}  // namespace mortise
