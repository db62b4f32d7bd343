// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What a boolean gives back: the mesh, where it comes from, where the operands met, and a report.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "mortise/mesh/provenance.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise {

/// Where boundaries of different operands meet. Polylines over graph points; a closed loop repeats its first point.
struct IntersectionGraph {
  std::vector<Vec3d> points;                        ///< nearest doubles
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< p < q, sorted
  std::vector<std::vector<std::uint32_t>> chains;   ///< closed loops first, then open chains; isolated points are in none
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

/// What a certificate speaks of (exact-core 5).
enum class CertificateLevel : std::uint8_t {
  Relative,  ///< rounding added no crossing to those of the operands
  Absolute,  ///< no two triangles of the result meet beyond what they share, and all have area
};

struct OperandVertex {
  std::uint32_t operand = 0, vertex = 0;

  auto operator<=>(const OperandVertex&) const = default;
};

/// Exact places of vertices, by points of operands. One point is the place itself; of four, the line through the first two meets
/// the line through the others there; of five, that line meets the plane through the others; of nine, three planes meet.
struct ExactPlaces {
  std::vector<std::uint32_t> vertices;  ///< of the result, ascending
  std::vector<std::uint32_t> begin{0};  ///< vertex i has points begin[i] .. begin[i + 1]
  std::vector<Vec3d> points;
};

struct Certificate {
  CertificateLevel level = CertificateLevel::Relative;
  CertificateStatus status = CertificateStatus::Certified;
  std::uint64_t triangles_tested = 0;               ///< with a vertex that was rounded; all of them for CertificateLevel::Absolute
  std::uint64_t pairs_tested = 0;                   ///< of a triangle with such a vertex and another
  std::uint64_t inherited_pairs = 0;                ///< that meet beyond what they share because their faces did so in one operand
  double largest_displacement = 0;                  ///< largest distance bound between an exact point and its doubles
  double repair_displacement = 0;                   ///< the part of it that repair added; 0: every made vertex is its nearest double
  std::uint32_t merge_rounds = 0;                   ///< of repair, in which vertices were merged
  std::uint32_t swap_rounds = 0;                    ///< of repair, in which slivers were swapped
  std::uint32_t snap_rounds = 0;                    ///< of repair, in which the rounded operands were arranged again
  std::vector<OperandVertex> moved_input_vertices;  ///< that had to move for this and are still in the result, ascending
  std::vector<std::uint32_t> failed_faces;          ///< of the result, ascending; empty when certified
  ExactPlaces exact_places;                         ///< of the corners of failed faces
};

struct OperandFace {
  std::uint32_t operand = 0, face = 0;

  auto operator<=>(const OperandFace&) const = default;
};

/// What it took to let operands share what lay within a tolerance.
struct ToleranceReport {
  std::uint64_t moved_vertices = 0;     ///< of operands, to the place of another one
  std::uint64_t made_vertices = 0;      ///< where edges passed one another
  double largest_move = 0;              ///< of a vertex; at most the tolerance
  std::vector<OperandFace> collapsed;   ///< ascending: faces whose corners became two or one
  std::vector<OperandFace> unresolved;  ///< ascending: faces that could not share all that is near, or that sharing let cross others
};

struct StageTime {
  std::string stage;
  double milliseconds = 0;
};

/// An operand that bounds no volume.
struct SheetOperand {
  std::uint32_t operand = 0;
  std::vector<std::uint32_t> open_edges;  ///< two vertices of the operand each: where an odd number of its faces meets
};

struct BooleanReport {
  std::vector<StageTime> stages;
  Certificate certificate;
  ContactMeasure contact;
  ToleranceReport tolerance;
  std::vector<std::uint32_t> self_contacts;  ///< operands whose crossings with themselves had to be resolved
  std::vector<SheetOperand> sheets;          ///< ascending
  std::vector<std::string> notes;
};

struct BooleanResult {
  SurfaceMesh mesh;  ///< labels and data: those of the source face (the first source), at corners; equal names of operands are one
  Provenance provenance;
  IntersectionGraph graph;
  BooleanReport report;
};

}  // namespace mortise
