// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every bad file of the data through every operation, with a box and with itself: a result that is what it says, or an error that
// names the place.
#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <optional>

#include "mortise/base/stopwatch.h"
#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/resolve.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/mesh/measures.h"
#include "support/boolean_checks.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/data.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Operands = std::span<const SurfaceMesh* const>;
using NamedOperation = std::pair<std::string, std::function<BooleanResult(Operands)>>;

std::vector<NamedOperation> all_operations() {
  std::vector<NamedOperation> operations;
  for (const char* name : {"union", "intersect", "subtract", "symmetric_difference", "partition"}) {
    operations.emplace_back(name, [name](Operands o) { return evaluate_boolean(operation_from_name(name), o); });
  }
  operations.emplace_back("imprint", [](Operands o) { return imprint(o).whole; });
  operations.emplace_back("implant", [](Operands o) { return implant(o); });
  operations.emplace_back("keep", [](Operands o) { return keep_faces(0b101101, o); });
  operations.emplace_back("combine", [](Operands o) { return evaluate_expression("!a & b | a - b", o); });
  operations.emplace_back("resolve", [](Operands o) { return resolve(*o.front()); });
  return operations;
}

SurfaceMesh box_over(const SurfaceMesh& mesh) {
  const Box3 bounds = bounding_box(mesh);
  if (bounds.is_empty()) return box({0, 0, 0}, {1, 1, 1});
  const Vec3d size = bounds.hi - bounds.lo;
  const double least = 0.01 * std::max({size.x, size.y, size.z});
  Vec3d lo, hi;
  for (std::size_t i = 0; i < 3; ++i) {
    lo[i] = bounds.lo[i] + 0.4 * size[i] - least;
    hi[i] = bounds.hi[i] + 0.1 * size[i] + least;
  }
  return box(lo, hi);
}

std::optional<SurfaceMesh> readable(const std::string& path) {
  try {
    return read_data(path);
  } catch (const Error&) {
    return std::nullopt;  // bad_input_test knows which
  }
}

/// Certified regions are closed; who is not certified names the faces.
void check_honest(const BooleanResult& result) {
  const Certificate& certificate = result.report.certificate;
  const bool is_certified = certificate.status == CertificateStatus::Certified;
  CHECK(is_certified == certificate.failed_faces.empty());
  const bool is_open = result.provenance.covering_front.empty() && !result.report.sheets.empty();
  if (is_certified && !is_open) CHECK(find_result_regions(result).total_volume() >= 0);
}

double slowest = 0;

void try_operation(const NamedOperation& operation, Operands operands) {
  INFO(operation.first);
  const Stopwatch watch;
  try {
    check_honest(operation.second(operands));
  } catch (const Error& error) {
    CHECK(error.code != ErrorCode::InternalError);
    CHECK((error.id_kind != IdKind::None && !error.ids.empty()));
    CHECK(error.operand >= 0);
  }
  slowest = std::max(slowest, watch.milliseconds());
}

}  // namespace

TEST_CASE("every bad file goes through every operation with a box and with itself", "[large]") {
  if (is_data_missing()) return;
  for (const std::string folder : {"nasty", "nasty/synthetic"}) {
    for (const std::string& file : data_files(folder)) {
      const std::optional<SurfaceMesh> mesh = readable(folder + "/" + file);
      if (!mesh) continue;
      INFO(file);
      const SurfaceMesh cube = box_over(*mesh), copy = *mesh;
      for (const NamedOperation& operation : all_operations()) {
        try_operation(operation, std::array{&*mesh, &cube});
        try_operation(operation, std::array{&cube, &*mesh});
        try_operation(operation, std::array{&*mesh, &copy});
      }
    }
  }
  std::printf("bad files: the longest operation took %.0f ms\n", slowest);
}
