// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A mesh of the size wanted on the same model: model edges first, then faces, by splits, collapses, swaps and moves (paper 7.4, step 16).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "mortise/base/progress.h"
#include "mortise/brep/brep.h"
#include "mortise/brep/face_normals.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/size/sizing_proxy.h"

namespace mortise {

/// How model faces in planes are meshed; all others are by local changes.
enum class Mesher : std::uint8_t {
  Local,   ///< splits, collapses, swaps and moves
  Frontal  ///< anew between model edges, by a front that runs inwards, in the last round, where all of the face may change
};

struct RemeshRules {
  Mesher mesher = Mesher::Local;
  double shortest = 0.92;                           ///< edges inside faces shorter than this in units of the size are collapsed
  double longest = 1.42;                            ///< longer ones are split
  std::vector<double> rounds{8, 8, 4, 4, 2, 2, 1};  ///< of collapses, swaps, splits and moves, each for the size taken so many times
  std::uint32_t last_rounds = 10;                   ///< on the worst triangles
  double worst_angle_deg = 34;                      ///< those with an angle below this
  std::uint32_t audits = 6;                         ///< how often it may begin anew when faces came to cross; 0: nobody looks
  double most_deviation = std::numeric_limits<double>::infinity();  ///< a length: no point of either mesh is farther from the other's
                                                                    ///< triangles of its model face
  double most_triangles = 2e7;                                      ///< a size that asks for more is refused
  std::vector<std::uint8_t> zone;  ///< empty, or per triangle: 1 when it may change; all others stay as they are, byte for byte
  ProgressCallback progress;
};

/// Those of the paper: an edge is collapsed when it is shorter than the size and split when it is longer than twice that (Fig. 20); no
/// coarse rounds. Edges come out 1.4 sizes long.
[[nodiscard]] RemeshRules paper_rules();

/// The same model with another mesh: equal entity numbers.
struct RemeshResult {
  SurfaceMesh mesh;  ///< labels and walls are those of the triangles it lies on; values at vertices and corners are left out
  Classification classification;
  std::vector<FaceId> sources;              ///< per triangle: the triangle of the given mesh its middle is closest to
  std::vector<FaceId> kept;                 ///< triangles of the given mesh that stayed because faces came to cross or to deviate there
  std::vector<SizeSource> refinement;       ///< that the bound on the deviation needed beside the sizes wanted
  std::vector<SelfCrossing> new_crossings;  ///< that are left after the last audit
};

/// Triangles in so many layers round mesh edges: those that touch one, those that touch one of these, and so on; a zone for RemeshRules.
/// @throws Error{InvalidArgument} for an edge with an end that is no vertex
[[nodiscard]] std::vector<std::uint8_t> layers_round(const SurfaceMesh& mesh, const std::vector<std::array<VertexId, 2>>& edges,
                                                     std::uint32_t layers);

/// How many triangles of these sizes the mesh takes: the integral of 2.31 / h^2 over the surface, to a few per cent;
/// where sizes grow fast up to a seventh more come out.
[[nodiscard]] double predict_triangle_count(const SurfaceMesh& mesh, const SizingProxy& sizes);

/// Every vertex stays on its model entity, every new one lies on one; model vertices stay as they are. Angles come out above 30 degrees but
/// where model edges meet at small angles or lie closer together than the size. Where faces come to cross that did not, model faces are
/// remeshed without coarse rounds; where they cross still, triangles stay as they were. Where the deviation is beyond its bound, triangles
/// become smaller; where that does not help, it is as with crossings, and at last whole model faces stay as they were.
///
/// @param model  of the mesh; seams are edges like others, so without them there is more to change
/// @param normals  as in build_brep
/// @throws Error{InvalidArgument} for rules that mean nothing, Error{ResultTooLarge} naming the count predicted,
///         Error{Cancelled}
[[nodiscard]] RemeshResult remesh(const SurfaceMesh& mesh, const ClassifiedBrep& model, const FaceNormals& normals,
                                  const SizingProxy& sizes, const RemeshRules& rules = {});

}  // namespace mortise
