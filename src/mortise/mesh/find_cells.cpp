// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The cells of shells whose pieces are single faces, measured.
#include "mortise/mesh/find_cells.h"

#include <numeric>

#include "mortise/mesh/find_shells.h"
#include "mortise/mesh/measures.h"

namespace mortise {
namespace {

SurfacePieces single_faces(const SurfaceMesh& mesh, const MeshTopology& topology) {
  SurfacePieces pieces;
  pieces.of_face.count = static_cast<std::uint32_t>(mesh.triangles.size());
  pieces.of_face.component_of.resize(mesh.triangles.size());
  std::iota(pieces.of_face.component_of.begin(), pieces.of_face.component_of.end(), 0U);
  for (std::size_t e = 0; e < topology.edges.size(); ++e) add_joint(mesh, topology.uses_of(MeshEdgeId(e)), pieces);
  return pieces;
}

void measure(const SurfaceMesh& mesh, MeshCells& cells) {
  std::vector<SurfaceMesh> boundary(cells.cells.size());
  const auto add = [&](std::uint32_t cell, const Triangle& t) {
    SurfaceMesh& part = boundary[cell];
    const std::size_t first = part.points.size();
    for (const VertexId v : t) part.points.push_back(mesh.points[v.index()]);
    part.triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
  };
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (cells.behind[f] == cells.in_front[f]) continue;
    const Triangle& t = mesh.triangles[f];
    add(cells.behind[f], t);
    add(cells.in_front[f], {t[0], t[2], t[1]});
  }
  for (std::size_t c = 0; c < boundary.size(); ++c) {
    cells.cells[c].area = surface_area(boundary[c]);
    if (c != MeshCells::unbounded) cells.cells[c].volume = enclosed_volume(boundary[c]);
  }
}

}  // namespace

MeshCells find_cells(const SurfaceMesh& mesh) {
  const SurfaceShells shells = find_shells(mesh, single_faces(mesh, build_topology(mesh)));
  MeshCells cells;
  for (const std::uint32_t shell : shells.behind) cells.behind.push_back(shells.cell_of_shell[shell]);
  for (const std::uint32_t shell : shells.in_front) cells.in_front.push_back(shells.cell_of_shell[shell]);
  cells.cells.resize(shells.cell_count);
  measure(mesh, cells);
  return cells;
}

}  // namespace mortise
