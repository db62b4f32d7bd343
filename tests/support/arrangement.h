// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The stages up to the facets, run over a scene written in a test, and checks of what they make.
#pragma once

#include <string>
#include <vector>

#include "mortise/arrange/triangulate_faces.h"
#include "support/boolean_scenes.h"

namespace mortise::test {

/// What every stage before the booleans makes of a scene. The stages refer to one another: it stays where it is.
struct Arrangement {
  /// `self`: search the self contacts of these operands even where the library sees no need to.
  explicit Arrangement(std::vector<SurfaceMesh> meshes, const std::vector<std::size_t>& self = {});
  Arrangement(const Arrangement&) = delete;
  Arrangement& operator=(const Arrangement&) = delete;

  const std::vector<SurfaceMesh> operands;
  OperandFaces faces;
  const Contacts contacts;
  const Overlays overlays;
  FaceIntersectionMap map;
  const LineSubdivision lines;
  const Facets facets;

  /// The point at this position, which is its nearest double; invalid when there is none.
  [[nodiscard]] PointId point_at(const Vec3d& position) const;
  /// Face f of operand k.
  [[nodiscard]] SourceId face(std::size_t k, std::size_t f) const { return SourceId(faces.first[OperandId(k)] + f); }
  /// Facets that have this face among their sources, ascending.
  [[nodiscard]] std::vector<FacetId> facets_of(SourceId f) const;
};

/// The small scenes, in a reduced run every fourth: for checks in rationals, which take their time.
[[nodiscard]] std::vector<Scene> scenes_for_rationals();

/// Every operand's self contacts set as `self` asks for.
[[nodiscard]] OperandFaces gather(const std::vector<SurfaceMesh>& operands, const std::vector<std::size_t>& self = {});

/// Faults of the facets, judged in rationals: each face is tiled by its facets, which run as their sources say, and any two
/// facets meet in a shared corner, a whole shared edge or not at all. One line each; empty when right.
[[nodiscard]] std::string faults_of_facets(const Arrangement& arrangement);

}  // namespace mortise::test
