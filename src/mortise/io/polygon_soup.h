// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What every reader collects: polygons over points, as the file lists them; and the mesh made of them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Polygons of any number of corners over points, some of which may be equal.
struct PolygonSoup {
  std::vector<Vec3d> points;
  std::vector<std::uint32_t> corners;      ///< indices of points, face after face
  std::vector<std::uint32_t> face_ends;    ///< per face: end of its corners
  std::vector<std::uint32_t> face_labels;  ///< empty, or one per face
  std::vector<std::string> label_names;
  std::vector<std::uint8_t> walls;       ///< empty, or one per face: SurfaceMesh::walls
  std::vector<DataChannel> point_data;   ///< values per point
  std::vector<DataChannel> corner_data;  ///< values per corner

  void end_face() { face_ends.push_back(static_cast<std::uint32_t>(corners.size())); }
};

/// Numbers names in the order of their first use.
class LabelTable {
 public:
  /// The number of a name, new or known.
  [[nodiscard]] std::uint32_t label_of(std::string_view name);
  [[nodiscard]] std::vector<std::string> names() const { return names_; }
  /// Is there a name that is not empty?
  [[nodiscard]] bool has_names() const;

 private:
  std::map<std::string, std::uint32_t, std::less<>> label_of_;
  std::vector<std::string> names_;
};

/// The mesh of a soup: equal positions welded in order of first appearance, polygons triangulated in place.
/// A corner equal to the one before it is dropped, from polygons of more than three corners only: no face vanishes, a polygon that
/// is left with fewer than three corners becomes one degenerate triangle, and a degenerate triangle stays as it is. Polygons leave
/// their diagonals in the mesh (find_polygons). All data become corner data.
/// Every face has at least three corners and every corner names a point. O(n log n).
[[nodiscard]] SurfaceMesh build_mesh(PolygonSoup soup);

}  // namespace mortise
