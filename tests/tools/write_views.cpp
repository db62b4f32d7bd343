// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Writes a square and a box for Gmsh to mesh with sizes of ours, and what they ask for, for scripts/check-formats.
// usage: write_views OUT_FOLDER   (NAME.pos, NAME.geo, NAME.json for each)
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "mortise/base/numbers.h"
#include "mortise/io/files.h"
#include "mortise/size/background_view.h"

using namespace mortise;

namespace {

std::string list_of(const Vec3d& p) { return "[" + format_double(p.x) + ", " + format_double(p.y) + ", " + format_double(p.z) + "]"; }

std::string json_of(const std::vector<SizeSource>& sources, double global) {
  std::string text;
  for (const SizeSource& s : sources) {
    text += std::string(text.empty() ? "" : ", ") + "{\"from\": " + list_of(s.corners[0]) +
            ", \"to\": " + list_of(s.corners[s.corner_count - 1U]) + ", \"size\": " + format_double(s.strengths[0]) +
            ", \"growth\": " + format_double(s.growth) + "}";
  }
  return "{\"global\": " + format_double(global) + ", \"sources\": [" + text + "]}\n";
}

/// @param shape  lines of a script that makes what is meshed
void write_view(const std::string& stem, const std::string& name, const std::string& shape, const Box3& box) {
  const std::vector<SizeSource> sources{segment_source({0.2, 0.3, 0}, {0.6, 0.7, 0}, 0.02, 1.2), point_source({0.8, 0.2, 0}, 0.01, 1.3)};
  const double global = 0.15;
  write_file(stem + name + ".pos", background_view(SizingProxy(sources, {.global = global}), box));
  write_file(stem + name + ".json", json_of(sources, global));
  write_file(stem + name + ".geo", shape + "Merge \"" + name +
                                       ".pos\";\nBackground Mesh View[0];\nMesh.CharacteristicLengthExtendFromBoundary = 0;\n"
                                       "Mesh.CharacteristicLengthFromPoints = 0;\nMesh.CharacteristicLengthFromCurvature = 0;\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: write_views OUT_FOLDER\n", stderr);
    return 2;
  }
  try {
    const std::string folder = std::string(argv[1]) + "/";
    const std::string kernel = "SetFactory(\"OpenCASCADE\");\n";
    write_view(folder, "square", kernel + "Rectangle(1) = {0, 0, 0, 1, 1};\n", {{0, 0, 0}, {1, 1, 0}});
    write_view(folder, "block", kernel + "Box(1) = {0, 0, 0, 1, 1, 1};\n", {{0, 0, 0}, {1, 1, 1}});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_views: %s\n", error.what());
    return 1;
  }
  return 0;
}
