// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The public door of the booleans: any number of solids, one exact arrangement, one rule.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/base/progress.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

enum class Operation { Union, Intersect, Subtract };

/// "union", "intersect", "subtract".
[[nodiscard]] std::string_view operation_name(Operation operation);

struct BooleanOptions {
  ProgressCallback progress;
  std::uint64_t contact_memory = std::uint64_t{1} << 31;  ///< bytes the candidate pairs may take
};

/// Where every facet and vertex of a result comes from.
struct Provenance {
  std::vector<std::uint32_t> source_operand;  ///< per facet; the lowest operand where several coincide
  std::vector<std::uint32_t> source_face;     ///< per facet: triangle of that operand
  std::vector<std::uint8_t> flipped;          ///< per facet: 1 when it runs against its source
  std::vector<std::uint32_t> other_source_begin;    ///< CSR: facet count + 1 offsets into the two arrays below
  std::vector<std::uint32_t> other_source_operand;  ///< further sources that coincide with a facet
  std::vector<std::uint32_t> other_source_face;
  std::vector<std::uint32_t> vertex_operand;  ///< per vertex: operand of its source vertex, or none
  std::vector<std::uint32_t> vertex_source;   ///< per vertex: vertex of that operand, or none for a made vertex
  static constexpr std::uint32_t none = 0xffffffffU;
};

/// Where boundaries of different operands meet. Polylines over graph points; a closed loop repeats its first point.
struct IntersectionGraph {
  std::vector<Vec3d> points;                          ///< nearest doubles
  std::vector<std::array<std::uint32_t, 2>> edges;    ///< p < q, sorted
  std::vector<std::vector<std::uint32_t>> chains;     ///< closed loops first, then open chains; isolated points are in none
  std::uint32_t closed_loops = 0;
  std::uint32_t open_chains = 0;
};

/// Measure of what operands share without sharing volume.
struct ContactMeasure {
  std::uint64_t points = 0;  ///< isolated points of contact
  double length = 0;         ///< of the intersection graph
  double area = 0;           ///< of coincident faces
};

enum class CertificateStatus { Certified, Uncertified };

struct Certificate {
  CertificateStatus status = CertificateStatus::Certified;
  std::uint64_t triangles_tested = 0;  ///< with a vertex that was rounded
  std::uint64_t pairs_tested = 0;
  double largest_displacement = 0;            ///< largest distance bound between an exact point and its doubles
  std::vector<std::uint32_t> failed_faces;    ///< of the result, ascending; empty when certified
};

struct StageTime {
  std::string stage;
  double milliseconds = 0;
};

struct BooleanReport {
  std::vector<StageTime> stages;
  Certificate certificate;
  ContactMeasure contact;
  std::vector<std::uint32_t> self_contacts;  ///< operands whose crossings with themselves had to be resolved
  std::vector<std::string> notes;
};

struct BooleanResult {
  SurfaceMesh mesh;  ///< labels: the label of the source face; names of all operands, equal names merged
  Provenance provenance;
  IntersectionGraph graph;
  BooleanReport report;
};

/// The union, the intersection, or the first operand minus all others.
///
/// Operands are solids: closed, oriented outwards, in any number (one resolves itself); vertices need not be shared. They
/// may touch, coincide, contain one another, have cavities and cross themselves. A point is inside an operand where its
/// winding is positive. An empty result is a mesh without triangles.
/// @throws Error{NotFinite, BadIndex, NotClosed, NotOriented, InsideOut, OutOfRange, ResultTooLarge, Cancelled}
/// Near-linear in the operands, plus time in proportion to the contact. Exact until the vertices are rounded, once.
[[nodiscard]] BooleanResult evaluate_boolean(Operation operation, std::span<const SurfaceMesh* const> operands, const BooleanOptions& options = {});

[[nodiscard]] BooleanResult unite(const SurfaceMesh& a, const SurfaceMesh& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult intersect(const SurfaceMesh& a, const SurfaceMesh& b, const BooleanOptions& options = {});
[[nodiscard]] BooleanResult subtract(const SurfaceMesh& a, const SurfaceMesh& b, const BooleanOptions& options = {});

}  // namespace mortise
