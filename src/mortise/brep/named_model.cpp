// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Elements of the file are on entities of the model; what the file says of the ones holds for the others.
#include "mortise/brep/named_model.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mortise/base/sort_unique.h"
#include "mortise/mesh/weld.h"

namespace mortise {
namespace {

using MeshEdge = std::array<VertexId, 2>;

std::vector<MeshEdge> welded_lines(const EntityMesh& file, const std::vector<VertexId>& new_vertex) {
  std::vector<MeshEdge> lines;
  for (const auto& [a, b] : file.lines) lines.push_back(sorted_ends(new_vertex[a.index()], new_vertex[b.index()]));
  return lines;
}

// Those that are sides of triangles, ascending, each once.
std::vector<MeshEdge> sides_among(std::vector<MeshEdge> lines, const SurfaceMesh& mesh) {
  sort_unique(lines);
  std::vector<bool> is_side(lines.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3 && !lines.empty(); ++k) {
      const MeshEdge side = sorted_ends(t[k], t[(k + 1) % 3]);
      const auto found = std::lower_bound(lines.begin(), lines.end(), side);
      if (found != lines.end() && *found == side) is_side[static_cast<std::size_t>(found - lines.begin())] = true;
    }
  }
  std::vector<MeshEdge> sides;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_side[i]) sides.push_back(lines[i]);
  }
  return sides;
}

// The side of a model face that is towards a region.
struct Side {
  std::uint32_t face = 0;
  bool is_front = false;

  auto operator<=>(const Side&) const = default;
};

class NameReader {
 public:
  NameReader(const EntityMesh& file, const SurfaceMesh& mesh, const ClassifiedBrep& model)
      : file_(file), mesh_(mesh), brep_(model.brep), on_(model.classification), voids_(find_voids(mesh, model)) {
    for (std::size_t d = 0; d < 4; ++d) targets_[d].resize(file.entities[d].size());
  }

  [[nodiscard]] std::vector<Attribute> read(const std::vector<VertexId>& new_vertex) {
    place_vertices(new_vertex);
    place_edges(welded_lines(file_, new_vertex));
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      targets_[2][file_.triangle_entities[t]].insert({EntityDimension::Face, on_.face_of_triangle[t].value});
    }
    place_regions();
    return gathered();
  }

 private:
  void place_vertices(const std::vector<VertexId>& new_vertex) {
    for (std::size_t i = 0; i < file_.point_elements.size(); ++i) {
      const ModelEntity entity = on_.entity_of_vertex[new_vertex[file_.point_elements[i].index()].index()];
      if (entity.dimension == EntityDimension::Vertex) targets_[0][file_.point_entities[i]].insert(entity);
    }
  }

  void place_edges(const std::vector<MeshEdge>& lines) {
    std::map<MeshEdge, std::uint32_t> edge_of;
    for (std::uint32_t e = 0; e < brep_.edges.size(); ++e) {
      const auto path = on_.path.of(ModelEdgeId(e));
      for (std::size_t i = 0; i + 1 < path.size(); ++i) edge_of.emplace(sorted_ends(path[i], path[i + 1]), e);
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto found = edge_of.find(lines[i]);
      if (found != edge_of.end()) targets_[1][file_.line_entities[i]].insert({EntityDimension::Edge, found->second});
    }
  }

  // What bounds a region of the model; sheets inside it do not.
  [[nodiscard]] std::set<Side> sides_round(std::uint32_t region) const {
    std::set<Side> sides;
    for (const ShellId shell : brep_.shells_of_region.of(ModelRegionId(region))) {
      for (const FaceSide& side : brep_.sides_of_shell.of(shell)) {
        const ModelFace& face = brep_.faces[side.face];
        if (face.region_behind != face.region_in_front) sides.insert({side.face.value, side.is_front});
      }
    }
    return sides;
  }

  // What the file says bounds one of its regions.
  [[nodiscard]] std::set<Side> sides_of(const MeshEntity& region) const {
    std::set<Side> sides;
    for (const std::int64_t tag : region.boundary) {
      const auto place = face_of_tag_.find(tag < 0 ? -tag : tag);
      if (place == face_of_tag_.end()) continue;
      for (const ModelEntity& face : targets_[2][place->second]) sides.insert({face.id, tag < 0});
    }
    return sides;
  }

  void place_regions() {
    for (std::uint32_t f = 0; f < file_.entities[2].size(); ++f) face_of_tag_.emplace(file_.entities[2][f].tag, f);
    for (std::uint32_t r = 0; r < brep_.region_count; ++r) {
      if (r != 0 && voids_[r] == 0) sides_round_.emplace_back(r, sides_round(r));
    }
    for (std::size_t i = 0; i < file_.entities[3].size(); ++i) {
      if (file_.entities[3][i].names.empty()) continue;
      const std::set<Side> given = sides_of(file_.entities[3][i]);
      place_region(i, [&](const std::set<Side>& sides) { return std::includes(given.begin(), given.end(), sides.begin(), sides.end()); });
      if (!targets_[3][i].empty()) continue;
      const std::set<std::uint32_t> faces = faces_of(given);
      place_region(i, [&](const std::set<Side>& sides) { return faces_of(sides) == faces; });
    }
  }

  template <class IsIt>
  void place_region(std::size_t i, IsIt is_it) {
    for (const auto& [region, sides] : sides_round_) {
      if (is_it(sides)) targets_[3][i].insert({EntityDimension::Region, region});
    }
  }

  static std::set<std::uint32_t> faces_of(const std::set<Side>& sides) {
    std::set<std::uint32_t> faces;
    for (const Side& side : sides) faces.insert(side.face);
    return faces;
  }

  [[nodiscard]] std::vector<Attribute> gathered() const {
    std::map<std::string, std::set<ModelEntity>> named;
    for (std::size_t d = 0; d < 4; ++d) {
      for (std::size_t i = 0; i < targets_[d].size(); ++i) {
        for (const std::uint32_t n : file_.entities[d][i].names)
          named[spoken_name(file_.names[n])].insert(targets_[d][i].begin(), targets_[d][i].end());
      }
    }
    std::vector<Attribute> attributes;
    for (const auto& [name, targets] : named) {
      if (!targets.empty()) attributes.push_back({name, AttributeKind::User, "null", {targets.begin(), targets.end()}, {}});
    }
    return attributes;
  }

  const EntityMesh& file_;
  const SurfaceMesh& mesh_;
  const Brep& brep_;
  const Classification& on_;
  std::vector<std::uint8_t> voids_;
  std::map<std::int64_t, std::uint32_t> face_of_tag_;                  // of the file
  std::vector<std::pair<std::uint32_t, std::set<Side>>> sides_round_;  // per region of the model that is one
  std::array<std::vector<std::set<ModelEntity>>, 4> targets_;          // per dimension and entity of the file
};

}  // namespace

NamedModel named_model_of(const EntityMesh& file, BrepRules rules) {
  WeldedMesh welded = weld(surface_mesh_of(file));
  rules.features.groups = file.triangle_entities;
  for (const MeshEdge& edge : sides_among(welded_lines(file, welded.new_vertex), welded.mesh)) rules.features.user_edges.push_back(edge);
  NamedModel named{std::move(welded.mesh), std::move(rules), {}, {}};
  named.model = build_brep(named.mesh, named.rules);
  named.attributes = NameReader(file, named.mesh, named.model).read(welded.new_vertex);
  return named;
}

}  // namespace mortise
