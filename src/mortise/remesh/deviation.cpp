// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "mortise/base/error.h"
#include "mortise/mesh/topology.h"
#include "mortise/remesh/closest_pieces.h"

namespace mortise {
namespace {

constexpr std::uint32_t no_group = std::numeric_limits<std::uint32_t>::max();

/// What distances are measured from and to; only what is of one group is measured against each other.
struct Sample {
  Vec3d at;
  std::uint32_t group = 0;
};

struct Piece {
  std::array<Vec3d, 3> corners;
  std::uint32_t group = 0;
};

std::vector<ClosestPieces> grouped(const std::vector<Piece>& pieces, std::size_t count, std::uint8_t corners) {
  std::vector<ClosestPieces> groups(count);
  for (const Piece& piece : pieces) {
    groups[piece.group].add(piece.corners, corners);
  }
  for (ClosestPieces& group : groups) group.close();
  return groups;
}

/// A mesh as samples and pieces.
struct Side {
  const SurfaceMesh& mesh;
  const ClassifiedBrep& model;
  Matching matching;

  [[nodiscard]] const Vec3d& at(VertexId v) const { return mesh.points[v.index()]; }
  [[nodiscard]] std::uint32_t group_of(FaceId t) const {
    return matching == Matching::None ? 0 : model.classification.face_of_triangle[t.index()].value;
  }
  [[nodiscard]] std::uint32_t group_of(ModelEdgeId e) const { return matching == Matching::Entities ? e.value : 0; }
};

std::vector<Piece> triangles_of(const Side& side) {
  std::vector<Piece> pieces;
  for (std::size_t t = 0; t < side.mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = side.mesh.triangles[t];
    pieces.push_back({{side.at(a), side.at(b), side.at(c)}, side.group_of(FaceId(t))});
  }
  return pieces;
}

// Centroids, vertices and middles of edges, triangle by triangle: points near one another follow one another. What triangles of several
// groups share is there for each of them, now and then twice.
std::vector<Sample> samples_of_surface(const Side& side) {
  const MeshTopology topology = build_topology(side.mesh);
  std::vector<Sample> samples;
  std::vector<std::uint32_t> group_of_vertex(side.mesh.points.size(), no_group), group_of_edge(topology.edges.size(), no_group);
  const auto is_new = [](std::uint32_t& last, std::uint32_t group) { return std::exchange(last, group) != group; };
  for (std::size_t t = 0; t < side.mesh.triangles.size(); ++t) {
    const Triangle& corners = side.mesh.triangles[t];
    const std::uint32_t group = side.group_of(FaceId(t));
    samples.push_back({1.0 / 3 * (side.at(corners[0]) + side.at(corners[1]) + side.at(corners[2])), group});
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = corners[k];
      const MeshEdgeId e = topology.edge_of[3 * t + k];
      if (is_new(group_of_vertex[v.index()], group)) samples.push_back({side.at(v), group});
      if (e.is_valid() && is_new(group_of_edge[e.index()], group))
        samples.push_back({0.5 * (side.at(v) + side.at(corners[(k + 1) % 3])), group});
    }
  }
  return samples;
}

template <class Visit>
void for_each_path(const Side& side, Visit visit) {
  for (std::size_t e = 0; e < side.model.brep.edges.size(); ++e) {
    if (!side.model.brep.edges[ModelEdgeId(e)].is_seam)
      visit(side.model.classification.path.of(ModelEdgeId(e)), side.group_of(ModelEdgeId(e)));
  }
}

std::vector<Piece> segments_of(const Side& side) {
  std::vector<Piece> pieces;
  for_each_path(side, [&](std::span<const VertexId> path, std::uint32_t group) {
    for (std::size_t k = 0; k + 1 < path.size(); ++k) pieces.push_back({{side.at(path[k]), side.at(path[k + 1]), {}}, group});
  });
  return pieces;
}

std::vector<Sample> samples_of_curves(const Side& side, bool with_middles) {
  std::vector<Sample> samples;
  for_each_path(side, [&](std::span<const VertexId> path, std::uint32_t group) {
    for (std::size_t k = 0; k < path.size(); ++k) {
      if (with_middles && k > 0) samples.push_back({0.5 * (side.at(path[k - 1]) + side.at(path[k])), group});
      samples.push_back({side.at(path[k]), group});
    }
  });
  return samples;
}

OneWayDistance measure(const std::vector<Sample>& samples, std::vector<ClosestPieces> groups, const SizingProxy& sizes,
                       std::vector<double>& of_groups) {
  OneWayDistance found;
  of_groups.assign(groups.size(), 0);
  for (const Sample& sample : samples) {
    const double distance = groups[sample.group].closest(sample.at).distance;
    if (distance == 0) continue;
    const double in_sizes = distance / sizes.size_at(sample.at);
    found.greatest = std::max(found.greatest, distance);
    of_groups[sample.group] = std::max(of_groups[sample.group], in_sizes);
    if (in_sizes <= found.in_sizes) continue;
    found.in_sizes = in_sizes;
    found.at = sample.at;
  }
  return found;
}

void check_matching(const ClassifiedBrep& a, const ClassifiedBrep& b, Matching matching) {
  const auto need_equal = [](std::size_t one, std::size_t other, const std::string& what) {
    if (one == other) return;
    throw Error(ErrorCode::InvalidArgument, "deviation",
                "one model has " + std::to_string(one) + " " + what + ", the reference " + std::to_string(other));
  };
  if (matching != Matching::None) need_equal(a.brep.faces.size(), b.brep.faces.size(), "faces");
  if (matching == Matching::Entities) need_equal(a.brep.edges.size(), b.brep.edges.size(), "edges");
}

}  // namespace

Deviation measure_deviation(const SurfaceMesh& mesh, const ClassifiedBrep& model, const SurfaceMesh& reference,
                            const ClassifiedBrep& reference_model, const SizingProxy& sizes, Matching matching) {
  check_matching(model, reference_model, matching);
  const Side here{mesh, model, matching}, there{reference, reference_model, matching};
  const std::size_t faces = matching == Matching::None ? 1 : model.brep.faces.size();
  const std::size_t edges = matching == Matching::Entities ? model.brep.edges.size() : 1;
  std::vector<double> to, from, unused;
  Deviation d;
  d.to_reference = measure(samples_of_surface(here), grouped(triangles_of(there), faces, 3), sizes, to);
  d.from_reference = measure(samples_of_surface(there), grouped(triangles_of(here), faces, 3), sizes, from);
  d.curves_to_reference = measure(samples_of_curves(here, false), grouped(segments_of(there), edges, 2), sizes, unused);
  d.curves_from_reference = measure(samples_of_curves(there, true), grouped(segments_of(here), edges, 2), sizes, unused);
  if (matching != Matching::None) {
    for (std::size_t f = 0; f < faces; ++f) d.of_faces.push_back({to[f], from[f]});
  }
  return d;
}

}  // namespace mortise
