// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What must hold for vertex and corner data of results.
#include "support/data_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"

namespace mortise::test {
namespace {

using oracle::Rational;
using oracle::RationalPoint;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::array<double, 2> chart_at(const Vec3d& p) { return {0.75 * p.x - 0.5 * p.y + 0.25 * p.z, 0.5 * p.x + 0.25 * p.y - 1 * p.z}; }

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

RationalPoint cross_product(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot_product(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Barycentric coordinates in space: areas of the parts over the area of the whole, seen along its normal.
std::array<Rational, 3> weights_of(const RationalPoint& p, const std::array<RationalPoint, 3>& face) {
  const RationalPoint normal = cross_product(minus(face[1], face[0]), minus(face[2], face[0]));
  const Rational whole = dot_product(normal, normal);
  std::array<Rational, 3> weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint part = cross_product(minus(face[(i + 1) % 3], p), minus(face[(i + 2) % 3], p));
    weights[i] = dot_product(part, normal) / whole;
  }
  return weights;
}

/// Where a mesh has a channel.
struct Found {
  const DataChannel* channel = nullptr;
  bool is_at_corners = false;
};

Found find_in(const SurfaceMesh& mesh, const std::string& name) {
  for (const DataChannel& c : mesh.vertex_data) {
    if (c.name == name) return {&c, false};
  }
  for (const DataChannel& c : mesh.corner_data) {
    if (c.name == name) return {&c, true};
  }
  return {};
}

double value_at(const SurfaceMesh& mesh, const Found& found, std::size_t face, std::size_t corner, std::size_t component) {
  const std::size_t place = found.is_at_corners ? 3 * face + corner : mesh.triangles[face][corner].index();
  return found.channel->values[place * found.channel->components + component];
}

/// The nearest double of the linear function at a point; NaN where a corner that counts has no value.
double expected_value(const std::array<Rational, 3>& weights, const std::array<double, 3>& values) {
  Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (weights[i] == 0) continue;
    if (std::isnan(values[i])) return none;
    sum += weights[i] * oracle::exact(values[i]);
  }
  return oracle::nearest_double(sum);
}

/// A mesh, the face behind each of its triangles, and where its vertices are exactly.
struct TracedMesh {
  const SurfaceMesh& mesh;
  std::vector<std::uint32_t> operand, face;
  std::vector<std::uint8_t> flipped;
  std::vector<RationalPoint> positions;
};

class DataFaults {
 public:
  DataFaults(std::span<const SurfaceMesh* const> operands, const TracedMesh& traced) : operands_(operands), traced_(traced) {}

  std::string find() {
    for (const SurfaceMesh* mesh : operands_) {
      for (const auto* list : {&mesh->vertex_data, &mesh->corner_data}) {
        for (const DataChannel& c : *list) look_for(c);
      }
    }
    if (!traced_.mesh.vertex_data.empty()) note("the result has vertex data");
    for (const DataChannel& c : traced_.mesh.corner_data) look_at(c);
    return faults_;
  }

 private:
  void note(const std::string& fault) { faults_ += fault + "\n"; }

  void look_for(const DataChannel& c) {
    const Found found = find_in(traced_.mesh, c.name);
    if (found.channel == nullptr || found.channel->components != c.components || found.channel->kind != c.kind)
      note("no channel " + c.name);
  }

  void look_at(const DataChannel& c) {
    if (c.values.size() != 3 * traced_.mesh.triangles.size() * c.components) return note("number of values of " + c.name);
    for (std::size_t t = 0; t < traced_.mesh.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) look_at_corner(c, t, i);
    }
  }

  void look_at_corner(const DataChannel& c, std::size_t t, std::size_t i) {
    const SurfaceMesh& operand = *operands_[traced_.operand[t]];
    const std::size_t face = traced_.face[t];
    const Found source = find_in(operand, c.name);
    std::array<RationalPoint, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = oracle::exact(operand.points[operand.triangles[face][k].index()]);
    const RationalPoint& p = traced_.positions[traced_.mesh.triangles[t][i].index()];
    const std::array<Rational, 3> weights = weights_of(p, corners);
    const bool turns = c.kind == DataKind::Normal && traced_.flipped[t] != 0;
    for (std::size_t k = 0; k < c.components; ++k) {
      double expected = none;
      if (source.channel != nullptr) {
        const auto value = [&](std::size_t corner) { return value_at(operand, source, face, corner, k); };
        expected = expected_value(weights, {value(0), value(1), value(2)});
      }
      if (turns) expected = -expected;
      const double found = c.values[(3 * t + i) * c.components + k];
      if (std::isnan(expected) ? !std::isnan(found) : found != expected) {
        note("channel " + c.name + " of facet " + std::to_string(t) + ": " + std::to_string(found) + " for " + std::to_string(expected));
      }
    }
  }

  std::span<const SurfaceMesh* const> operands_;
  const TracedMesh& traced_;
  std::string faults_;
};

DataChannel random_channel(const std::string& name, DataKind kind, std::size_t components, std::size_t places, RandomSource& random) {
  DataChannel channel{name, static_cast<std::uint32_t>(components), kind, {}};
  for (std::size_t i = 0; i < places * components; ++i) {
    // Few different numbers, so that equal ones and zero occur, and full mantissas.
    channel.values.push_back(random.once_in(2) ? static_cast<double>(random.below(3)) : random.between(-1, 1) * random.octaves(-20, 20));
  }
  return channel;
}

}  // namespace

SurfaceMesh with_chart(SurfaceMesh mesh) {
  DataChannel uv{"uv", 2, DataKind::Value, {}};
  for (const Vec3d& p : mesh.points) {
    for (const double x : chart_at(p)) uv.values.push_back(x);
  }
  mesh.vertex_data.push_back(std::move(uv));
  return mesh;
}

double deviation_from_chart(const SurfaceMesh& mesh, double size) {
  const Found uv = find_in(mesh, "uv");
  double largest = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<double, 2> expected = chart_at(mesh.points[mesh.triangles[t][i].index()]);
      for (std::size_t k = 0; k < 2; ++k) {
        const double difference = std::abs(value_at(mesh, uv, t, i, k) - expected[k]);
        largest = std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::max(largest, difference);
      }
    }
  }
  return largest / size;
}

SurfaceMesh with_random_data(SurfaceMesh mesh, RandomSource& random, std::size_t number) {
  const std::size_t corners = 3 * mesh.triangles.size();
  mesh.vertex_data.push_back(random_channel("t", DataKind::Value, 1, mesh.points.size(), random));
  mesh.vertex_data.push_back(random_channel("n", DataKind::Normal, 3, mesh.points.size(), random));
  mesh.corner_data.push_back(random_channel("w", DataKind::Vector, 3, corners, random));
  if (number % 2 != 0) return mesh;
  mesh.corner_data.push_back(random_channel("c", DataKind::Value, 2, corners, random));
  for (double& x : mesh.corner_data.back().values) {
    if (random.once_in(10)) x = none;
  }
  return mesh;
}

std::string faults_of_data(std::span<const SurfaceMesh* const> operands, const BooleanResult& result) {
  const Provenance& p = result.provenance;
  return DataFaults(operands, {result.mesh, p.source_operand, p.source_face, p.flipped, exact_positions(operands, result)}).find();
}

std::string faults_of_data(std::span<const SurfaceMesh* const> operands, const ImprintResult& result) {
  std::string faults = faults_of_data(operands, result.whole);
  const std::vector<RationalPoint> positions = exact_positions(operands, result.whole);
  for (std::size_t k = 0; k < operands.size(); ++k) {
    const ImprintedOperand& own = result.operands[k];
    const std::size_t count = own.mesh.triangles.size();
    TracedMesh traced{own.mesh, std::vector<std::uint32_t>(count, 0), own.source_face, std::vector<std::uint8_t>(count, 0), {}};
    for (const std::uint32_t id : own.vertex_ids) traced.positions.push_back(positions[id]);
    const std::string found = DataFaults(operands.subspan(k, 1), traced).find();
    if (!found.empty()) faults += "operand " + std::to_string(k) + ":\n" + found;
  }
  return faults;
}

std::string faults_of_groups(std::span<const SurfaceMesh* const> operands, const BooleanResult& result) {
  std::string faults;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const SurfaceMesh& operand = *operands[result.provenance.source_operand[t]];
    const std::string expected =
        operand.face_labels.empty() ? "" : operand.label_names[operand.face_labels[result.provenance.source_face[t]]];
    const std::string found = result.mesh.face_labels.empty() ? "" : result.mesh.label_names[result.mesh.face_labels[t]];
    if (found != expected) faults += "facet " + std::to_string(t) + " is in group '" + found + "', not '" + expected + "'\n";
  }
  return faults;
}

}  // namespace mortise::test
