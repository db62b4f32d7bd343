// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Unites a box with two pipes, drills a hole along one of them, and writes the part.
#include <cstdio>

#include "mortise/mortise.h"

int main() {
  using namespace mortise;
  try {
    const SurfaceMesh block = make_box({-1, -1, -1}, {1, 1, 1});
    const SurfaceMesh upright = transform(make_cylinder(0.5, 4, 64), translation({0, 0, -2}));
    const SurfaceMesh lying = transform(upright, rotation(Axis::Y, 90));
    const SurfaceMesh bore = transform(make_cylinder(0.25, 6, 64), translation({0, 0, -3}));

    const SurfaceMesh* const parts[] = {&block, &upright, &lying};
    const BooleanResult cross = evaluate_boolean(Operation::Union, parts);
    const BooleanResult drilled = subtract(cross.mesh, bore);
    write_mesh_file("drilled.ply", drilled.mesh);

    const MeshReport report = inspect(drilled.mesh);
    std::printf("%llu triangles, volume %.6f, genus %lld, %u loops in the graph, %s\n", static_cast<unsigned long long>(report.triangles),
                report.volume.value_or(0), static_cast<long long>(report.genus.value_or(-1)), drilled.graph.closed_loops,
                drilled.report.certificate.status == CertificateStatus::Certified ? "certified" : "not certified");
    return report.closed && report.genus == 1 ? 0 : 1;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s in %s: %s\n", std::string(error_code_name(error.code)).c_str(), error.stage.c_str(), error.what());
    return 1;
  }
}
