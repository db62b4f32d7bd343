// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Faces, groups, objects and materials of an OBJ text, by tinyobjloader.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mortise {

/// Faces in the order of the text, with the vertex indices as they are written: from 1, or negative and relative.
struct ObjFaces {
  std::vector<int> corners;                ///< face after face
  std::vector<int> textures, normals;      ///< per corner the same of `vt` and `vn`, 0 where there is none
  std::vector<std::uint32_t> face_ends;    ///< per face: end of its corners
  std::vector<std::uint32_t> face_labels;  ///< one per face when any face has a name, else empty
  std::vector<std::string> label_names;
};

/// The faces of an OBJ text whose `f` statements are known to be sound: tinyobjloader takes what is no integer for 0, and does not join
/// continued lines. It is not asked to triangulate (its ear clipping fails on concave polygons) nor to read numbers (wrong in the last
/// bits).
[[nodiscard]] ObjFaces load_obj_faces(std::string_view text);

}  // namespace mortise
