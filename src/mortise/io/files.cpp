// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Meshes in files of the machine.
#include "mortise/io/files.h"

#include <array>
#include <cstdio>
#include <memory>

#include "mortise/base/error.h"
#include "mortise/io/formats.h"

namespace mortise {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(std::string_view stage, const std::string& path, std::string_view what) {
  throw Error(ErrorCode::FileFailed, stage, "'" + path + "' cannot be " + std::string(what));
}

}  // namespace

std::string read_file(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail("read_file", path, "opened");
  std::string bytes;
  std::array<char, 1 << 16> block;
  for (std::size_t count = block.size(); count == block.size();) {
    count = std::fread(block.data(), 1, block.size(), file.get());
    bytes.append(block.data(), count);
  }
  if (std::ferror(file.get()) != 0) fail("read_file", path, "read");
  return bytes;
}

void write_file(const std::string& path, const std::string& bytes) {
  File file(std::fopen(path.c_str(), "wb"));
  if (!file) fail("write_file", path, "opened for writing");
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  if (std::fclose(file.release()) != 0 || !is_written) fail("write_file", path, "written");
}

SurfaceMesh read_mesh_file(const std::string& path) { return read_mesh(read_file(path), path); }

void write_mesh_file(const std::string& path, const SurfaceMesh& mesh) { write_file(path, write_mesh(mesh, format_from_path(path))); }

}  // namespace mortise
