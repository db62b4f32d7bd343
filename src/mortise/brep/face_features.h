// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The model edges round a model face, and which parts of them are close to one another.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mortise/brep/brep.h"
#include "mortise/geom/box_tree.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// The model edges round every model face, ascending; no seams.
[[nodiscard]] std::vector<std::vector<ModelEdgeId>> edges_of_faces(const ClassifiedBrep& model);

/// A place on model edges.
struct FeaturePlace {
  Vec3d at;
  std::vector<std::pair<VertexId, double>> ends;  ///< vertices to set out from, with the way to them
  std::uint32_t piece;                            ///< it is on; 0xffffffff for a vertex
};

/// Another part of the model edges round the face, close to a place.
struct ClosePart {
  Vec3d at;
  double gap = 0, way = 0;     ///< straight, and along model edges; infinite beyond what was asked for
  std::uint32_t vertices = 0;  ///< model vertices on that way, 0 without one
};

/// Model edges round one model face in straight pieces, each once.
class FaceFeatures {
 public:
  FaceFeatures(const SurfaceMesh& mesh, const ClassifiedBrep& model, std::span<const ModelEdgeId> edges);

  [[nodiscard]] const std::vector<std::array<VertexId, 2>>& pieces() const { return pieces_; }
  [[nodiscard]] const std::vector<VertexId>& vertices() const { return vertices_; }  ///< ascending

  [[nodiscard]] FeaturePlace at_vertex(VertexId v) const;
  /// @param fraction  of the way from the first end to the second
  [[nodiscard]] FeaturePlace on_piece(std::uint32_t piece, double fraction) const;

  /// The closest points of all pieces nearer than `reach`, but of the one the place is on.
  /// @param towards  empty, or directions: only what lies within 75 degrees of one of them
  [[nodiscard]] std::vector<ClosePart> parts_close_to(const FeaturePlace& place, double reach, double farthest_way,
                                                      std::span<const Vec3d> towards = {});

 private:
  struct Way {
    double length;
    std::uint32_t vertices;
  };

  [[nodiscard]] const Vec3d& at(VertexId v) const { return mesh_.points[v.index()]; }
  [[nodiscard]] std::size_t number_of(VertexId v) const;
  void find_ways(const FeaturePlace& from, double farthest);
  void reach(std::size_t v, const Way& way);
  [[nodiscard]] Way way_through(VertexId v) const;

  const SurfaceMesh& mesh_;
  const ClassifiedBrep& model_;
  std::vector<std::array<VertexId, 2>> pieces_;
  BoxTree tree_;
  std::vector<VertexId> vertices_;
  std::vector<std::vector<std::uint32_t>> pieces_at_;  ///< per vertex
  std::vector<Way> ways_;                              ///< per vertex
  std::vector<std::size_t> reached_;
  std::vector<std::pair<double, std::size_t>> next_;  ///< a heap
};

}  // namespace mortise
