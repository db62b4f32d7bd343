// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Finds the data folder; reads and moves its meshes.
#include "support/data.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "mortise/io/files.h"
#include "mortise/mesh/transform.h"

namespace mortise::test {
namespace {

namespace fs = std::filesystem;

bool is_data_folder(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / "SOURCES.md", ignored);
}

std::vector<double> numbers_in(const std::string& list) {
  std::vector<double> numbers;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}

Axis axis_named(char name) {
  if (name != 'x' && name != 'y' && name != 'z') throw std::invalid_argument("a move without an axis");
  return static_cast<Axis>(name - 'x');
}

AffineMap map_of(const std::string& move) {
  const std::size_t equals = std::min(move.find('='), move.size());
  const std::string name = move.substr(0, equals);
  const std::vector<double> numbers = numbers_in(move.substr(std::min(equals + 1, move.size())));
  if (name == "s" && numbers.size() == 1) return scaling({numbers[0], numbers[0], numbers[0]});
  if (name == "t" && numbers.size() == 3) return translation({numbers[0], numbers[1], numbers[2]});
  if (name.size() == 2 && name[0] == 'r' && numbers.size() == 1) return rotation(axis_named(name[1]), numbers[0]);
  if (name.size() == 2 && name[0] == 'm' && numbers.empty()) return mirroring(axis_named(name[1]));
  throw std::invalid_argument("not a move: " + move);
}

}  // namespace

std::optional<std::string> data_folder() {
  if (const char* chosen = std::getenv("MORTISE_DATA"); chosen != nullptr && *chosen != '\0') {
    return is_data_folder(chosen) ? std::optional<std::string>(chosen) : std::nullopt;
  }
  for (fs::path folder = fs::current_path();; folder = folder.parent_path()) {
    const fs::path data = folder.parent_path() / "shared" / "data";
    if (is_data_folder(data)) return data.string();
    if (folder == folder.parent_path()) return std::nullopt;
  }
}

std::string repository_path(const std::string& file) {
  fs::path folder = fs::current_path();
  while (!fs::is_regular_file(folder / file) && folder != folder.parent_path()) folder = folder.parent_path();
  return (folder / file).string();
}

bool is_data_missing() {
  if (data_folder()) return false;
  std::printf("skipped: the meshes of MORTISE_DATA (default: ../shared/data) are not there\n");
  return true;
}

std::vector<std::string> data_files(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(data_folder().value()) / folder)) {
    if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

SurfaceMesh moved_by(SurfaceMesh mesh, const std::string& moves) {
  std::istringstream stream(moves);
  for (std::string move; stream >> move;) mesh = transform(mesh, map_of(move));
  return mesh;
}

SurfaceMesh read_data(const std::string& file, const std::string& moves) {
  return moved_by(read_mesh_file((fs::path(data_folder().value()) / file).string()), moves);
}

}  // namespace mortise::test
