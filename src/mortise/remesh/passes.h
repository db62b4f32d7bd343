// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What the remesher does again and again, each over the whole mesh (paper 7.4, Figs. 20-22). Order and results depend on numbering only.
// Lengths are in units of the size wanted, times the coarseness of the face.
#pragma once

#include <limits>
#include <vector>

#include "mortise/base/progress.h"
#include "mortise/remesh/working_mesh.h"

namespace mortise {

/// Gives every model edge its number of mesh edges, n with L / h in [sqrt(n (n - 1)), sqrt(n (n + 1))), of equal length in units of the
/// size, as far as the triangles beside it allow.
void resample_model_edges(WorkingMesh& w);

/// Splits edges inside faces that are longer than this, the longest first; after each split, edges opposite to the
/// new vertex are swapped where that lowers the largest angle.
/// @param most_new  triangles made before it stops: needles too thin for any swap would be cut into pieces as short as they are wide
void split_long_edges(WorkingMesh& w, double longest, double most_new);

/// Collapses edges inside faces shorter than this, the shortest first, where that makes none longer than `longest`.
/// @param most_gone  triangles removed before it stops
void collapse_short_edges(WorkingMesh& w, double shortest, double longest, double most_gone = std::numeric_limits<double>::infinity());

/// Swaps edges until no swap lowers a largest angle (Fig. 21).
void swap_edges(WorkingMesh& w);

/// Marks model faces in planes all of whose triangles may change.
void await_front(WorkingMesh& w);
/// Meshes them anew between model edges, edges as long as the size: a front of new vertices runs inwards. Then they are done, but those
/// with a triangle that turns the wrong way round: these stay as they were. Differs from the paper, whose frontal meshes (Figs. 26d, 27h)
/// are those of another program.
void mesh_planar_faces(WorkingMesh& w);

/// Those that may move.
[[nodiscard]] std::vector<VertexId> vertices_inside_faces(const WorkingMesh& w);

/// Moves vertices inside faces once, in the tangent plane, to where their triangles are more alike (CVT of the paper: the mean of the
/// circumcentres weighted with areas in units of the size), then back onto the face.
/// @param good_enough  a least mean ratio that may fall as far as this for the sake of other triangles; 0: as far as no triangle turns
///                     over, 1: not at all
void smooth_vertices(WorkingMesh& w, const std::vector<VertexId>& vertices, double good_enough);

/// Works on triangles with an angle below this and on what is round them: swap, collapse, move.
void improve_worst_triangles(WorkingMesh& w, double least_angle_deg, double longest, std::uint32_t rounds);

/// Looks up the triangle of the reference every triangle lies on.
void settle_on_reference(WorkingMesh& w);

}  // namespace mortise
