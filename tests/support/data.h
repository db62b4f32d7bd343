// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Real meshes kept outside the repository: where they are, and how tests read them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mortise/mesh/surface_mesh.h"

namespace mortise::test {

/// The folder of MORTISE_DATA, or `../shared/data` of the repository (the first folder upwards from the current one that has
/// it beside it); nothing where there is none.
[[nodiscard]] std::optional<std::string> data_folder();

/// A file of this repository: in the current folder, or the first folder above it that has it.
[[nodiscard]] std::string repository_path(const std::string& file);

/// Is there no such folder? Then it says so on a line beginning with `skipped: `, which counts the test as skipped.
[[nodiscard]] bool is_data_missing();

/// Names of the files directly in a folder of the data, sorted.
[[nodiscard]] std::vector<std::string> data_files(const std::string& folder);

/// The mesh moved. Moves are done in the order written, separated by blanks: `s=2` scale, `rx=90` `ry=90` `rz=45` rotation in
/// degrees, `mx` `my` `mz` mirror, `t=1,2,3` translation.
[[nodiscard]] SurfaceMesh moved_by(SurfaceMesh mesh, const std::string& moves);

/// A mesh of the data, moved.
[[nodiscard]] SurfaceMesh read_data(const std::string& file, const std::string& moves = "");

}  // namespace mortise::test
