// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/size/model_sources.h"

#include <cmath>
#include <limits>
#include <string>

#include "mortise/base/error.h"
#include "mortise/base/numbers.h"
#include "mortise/base/sort_unique.h"
#include "mortise/size/placed_source.h"

namespace mortise {
namespace {

bool is_size(double x) { return x > 0 && x <= std::numeric_limits<double>::max(); }

std::array<Vec3d, 3> corners_of(const SurfaceMesh& mesh, FaceId t) {
  const Triangle& v = mesh.triangles[t.index()];
  return {mesh.points[v[0].index()], mesh.points[v[1].index()], mesh.points[v[2].index()]};
}

void check_vertex_sizes(const SurfaceMesh& mesh, std::span<const double> sizes) {
  if (sizes.size() != mesh.points.size())
    throw Error(ErrorCode::InvalidArgument, "sizing",
                "there are " + std::to_string(sizes.size()) + " sizes for " + std::to_string(mesh.points.size()) + " vertices");
  std::vector<std::uint32_t> bad;
  for (const Triangle& t : mesh.triangles) {
    for (const VertexId v : t) {
      if (!is_size(sizes[v.index()])) bad.push_back(v.value);
    }
  }
  if (bad.empty()) return;
  sort_unique(bad);
  throw Error(ErrorCode::InvalidArgument, "sizing", "vertex " + std::to_string(bad[0]) + " has a size that is not a positive number")
      .with_ids(IdKind::Vertices, std::move(bad));
}

SizeSource linear(SizeSource source, const std::array<double, 3>& sizes) {
  source.order = StrengthOrder::Linear;
  source.strengths = {sizes[0], sizes[1], sizes[2]};
  return source;
}

// c is across the longest edge a - b.
void add_thin_triangle(const std::array<Vec3d, 3>& corners, const std::array<double, 3>& sizes, double growth,
                       std::vector<SizeSource>& sources) {
  const std::size_t a = longest_edge_of(corners), b = (a + 1) % 3, c = (a + 2) % 3;
  for (const std::size_t end : {a, b}) {
    sources.push_back(linear(segment_source(corners[end], corners[c], sizes[end], growth), {sizes[end], sizes[c]}));
  }
}

double size_in(const Attribute& attribute) {
  const ParsedNumber<double> number = parse_double(attribute.value);
  if (number.error == NumberError::None && is_size(number.value)) return number.value;
  throw Error(ErrorCode::InvalidArgument, "sizing",
              "attribute '" + attribute.name + "' has the size " + attribute.value + ", which is not a positive number");
}

void check_target(const ModelView& view, const Attribute& attribute, const ModelEntity& target) {
  if (target.id >= entity_count(view.model.brep, target.dimension))
    throw Error(ErrorCode::InvalidArgument, "sizing",
                "attribute '" + attribute.name + "' is on " + entity_name(target) + ", which is not there");
}

}  // namespace

std::vector<SizeSource> sources_on(const ModelView& view, const ModelEntity& entity, double size, double growth) {
  const MeshEntities on = mesh_on(view, entity, entity.dimension == EntityDimension::Region ? Extent::Closure : Extent::Interior);
  const auto point = [&](VertexId v) { return view.mesh.points[v.index()]; };
  std::vector<SizeSource> sources;
  if (entity.dimension == EntityDimension::Vertex) sources.push_back(point_source(point(on.vertices[0]), size, growth));
  if (entity.dimension == EntityDimension::Edge) {
    for (const auto& [a, b] : on.edges) sources.push_back(segment_source(point(a), point(b), size, growth));
  }
  for (const FaceId t : on.triangles) {
    const auto& [a, b, c] = corners_of(view.mesh, t);
    sources.push_back(triangle_source(a, b, c, size, growth));
  }
  return sources;
}

std::vector<SizeSource> sources_for_edge_counts(const ModelView& view, std::uint32_t least_edges, double smallest, double growth) {
  if (least_edges == 0 || !(smallest == 0 || is_size(smallest)))
    throw Error(ErrorCode::InvalidArgument, "sizing", "an edge has at least 1 element, of a smallest size that is finite and not negative");
  std::vector<SizeSource> sources;
  for (std::uint32_t e = 0; e < view.model.brep.edges.size(); ++e) {
    const ModelEntity edge{EntityDimension::Edge, e};
    const double size = std::max(smallest, measure(view, edge) / least_edges);
    if (view.model.brep.edges[ModelEdgeId(e)].is_seam || !(size > 0)) continue;
    const std::vector<SizeSource> added = sources_on(view, edge, size, growth);
    sources.insert(sources.end(), added.begin(), added.end());
  }
  return sources;
}

std::vector<SizeSource> sources_of_vertex_sizes(const SurfaceMesh& mesh, std::span<const double> sizes, double growth) {
  check_vertex_sizes(mesh, sizes);
  std::vector<SizeSource> sources;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<Vec3d, 3> corners = corners_of(mesh, FaceId(t));
    const Triangle& v = mesh.triangles[t];
    const std::array<double, 3> strengths{sizes[v[0].index()], sizes[v[1].index()], sizes[v[2].index()]};
    const SizeSource triangle = linear(triangle_source(corners[0], corners[1], corners[2], strengths[0], growth), strengths);
    if (is_too_thin_to_vary(place_source(triangle))) {
      add_thin_triangle(corners, strengths, growth, sources);
    } else {
      sources.push_back(triangle);
    }
  }
  return sources;
}

std::vector<SizeSource> sources_of_attributes(const ModelView& view, std::span<const Attribute> attributes, double growth) {
  std::vector<SizeSource> sources;
  for (const Attribute& attribute : attributes) {
    if (attribute.kind != AttributeKind::Size) continue;
    const double size = size_in(attribute);
    for (const ModelEntity& target : attribute.targets) {
      check_target(view, attribute, target);
      const std::vector<SizeSource> added = sources_on(view, target, size, growth);
      sources.insert(sources.end(), added.begin(), added.end());
    }
  }
  return sources;
}

}  // namespace mortise
