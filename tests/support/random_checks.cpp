// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Checks of the random campaign: the general ones of results, and volumes of several results against one another.
#include "support/random_checks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <sstream>

#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/brep/build_brep.h"
#include "mortise/brep/model_queries.h"
#include "mortise/brep/validate_brep.h"
#include "mortise/mesh/measures.h"
#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/mesh_checks.h"
#include "support/self_crossing_oracle.h"

namespace mortise::test {
namespace {

constexpr double slow_seconds = 20;                     // of one operation: counted
constexpr double most_seconds = 300;                    // a fault
constexpr std::size_t most_faces_for_crossings = 1500;  // of a result
constexpr std::size_t most_faces_for_provenance = 60;   // of all operands
constexpr std::size_t most_products_for_volume = 150;   // of the numbers of faces

using Operands = std::vector<const SurfaceMesh*>;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A volume and how far rounding may have moved it.
struct Measure {
  double volume = 0;
  double tolerance = 0;
};

Measure operator+(const Measure& a, const Measure& b) { return {a.volume + b.volume, a.tolerance + b.tolerance}; }
Measure operator-(const Measure& a, const Measure& b) { return {a.volume - b.volume, a.tolerance + b.tolerance}; }

/// What an uncertified result may have and still be honest.
bool is_allowed_uncertified(const std::string& fault) {
  for (const char* allowed : {"not certified", "face without area", "face given twice", "two vertices at one place"}) {
    if (fault.rfind(allowed, 0) == 0) return true;
  }
  return false;
}

std::string without_allowed(const std::string& faults) {
  std::istringstream lines(faults);
  std::string rest;
  for (std::string line; std::getline(lines, line);) {
    if (!is_allowed_uncertified(line)) rest += line + '\n';
  }
  return rest;
}

/// Does a mesh that is not too large for the oracle meet itself beyond what its faces share?
bool is_small_and_crosses(const SurfaceMesh& mesh) {
  return mesh.triangles.size() <= most_faces_for_crossings && !oracle::self_crossings(mesh).empty();
}

/// Volumes of booleans by the oracle, from common volumes that are found once each.
class OracleVolumes {
 public:
  explicit OracleVolumes(const Operands& operands) : operands_(operands) {}

  oracle::Rational of(Operation operation, const Operands& operands) {
    const std::uint32_t all = mask_of(operands), first = mask_of({operands[0]});
    if (operation == Operation::Intersect) return common(all);
    oracle::Rational sum = operation == Operation::Subtract ? common(first) : 0;
    const std::uint32_t always = operation == Operation::Subtract ? first : 0, others = all & ~always;
    for (std::uint32_t subset = others; subset != 0; subset = (subset - 1) & others) {
      const int count = std::popcount(subset);
      const int times = operation == Operation::SymmetricDifference ? 1 << (count - 1) : 1;  // (-2)^(count - 1)
      const bool adds = (count % 2 == 1) != (operation == Operation::Subtract);
      sum += (adds ? times : -times) * common(subset | always);
    }
    return sum;
  }

 private:
  [[nodiscard]] std::uint32_t mask_of(const Operands& operands) const {
    std::uint32_t mask = 0;
    for (const SurfaceMesh* operand : operands) {
      mask |= 1U << static_cast<unsigned>(std::find(operands_.begin(), operands_.end(), operand) - operands_.begin());
    }
    return mask;
  }

  const oracle::Rational& common(std::uint32_t mask) {
    const auto known = known_.find(mask);
    if (known != known_.end()) return known->second;
    Operands chosen;
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      if ((mask >> i & 1U) != 0) chosen.push_back(operands_[i]);
    }
    return known_[mask] = chosen.size() == 1 ? oracle::volume(*chosen[0]) : oracle::common_volume(chosen);
  }

  Operands operands_;
  std::map<std::uint32_t, oracle::Rational> known_;
};

double smallest_coordinate(const SurfaceMesh& mesh) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Vec3d& p : mesh.points) {
    for (std::size_t i = 0; i < 3; ++i) smallest = p[i] == 0 ? smallest : std::min(smallest, std::fabs(p[i]));
  }
  return smallest;
}

bool is_uncertified(const BooleanResult& result) { return result.report.certificate.status == CertificateStatus::Uncertified; }

class CaseCheck {
 public:
  explicit CaseCheck(const RandomCase& drawn) : family_(drawn.family), operands_(pointers_to(drawn.operands)), oracle_(operands_) {
    double largest = 0, smallest = std::numeric_limits<double>::infinity();
    std::size_t products = 1;
    for (const SurfaceMesh* operand : operands_) {
      largest = std::max(largest, largest_coordinate(*operand));
      faces_ += operand->triangles.size();
      products *= operand->triangles.size();
      smallest = std::min(smallest, smallest_coordinate(*operand));
    }
    coordinate_ = largest;
    has_quick_volumes_ = products <= most_products_for_volume && smallest > 0x1p-100 * largest;
    int exponent = 0;
    std::frexp(largest, &exponent);
    unit_ = std::ldexp(1.0, -exponent);
  }

  CaseOutcome run() {
    try {
      check();
    } catch (const Error& error) {
      const bool hangs = error.code == ErrorCode::Cancelled;
      add_fault(hangs ? "an operation took more than 300 seconds"
                      : std::string(error_code_name(error.code)) + " in " + error.stage + ": " + error.message);
    } catch (const std::exception& error) {
      add_fault(std::string("exception: ") + error.what());
    }
    outcome_.seconds = processor_seconds() - start_;
    return outcome_;
  }

 private:
  void check() {
    // What an operand has of its own may stay in the result.
    crosses_itself_ =
        std::any_of(operands_.begin(), operands_.end(), [](const SurfaceMesh* operand) { return is_small_and_crosses(*operand); });
    const Operands backwards(operands_.rbegin(), operands_.rend()), rest(operands_.begin() + 1, operands_.end());
    const BooleanResult all = checked(Operation::Union, operands_), common = checked(Operation::Intersect, operands_);
    expect_same(all, evaluated(Operation::Union, backwards), "union");
    expect_same(common, evaluated(Operation::Intersect, backwards), "intersection");
    const Measure either = measure(all), both = measure(common);
    const Measure first_less = measure(checked(Operation::Subtract, operands_));
    const Measure last_less = measure(checked(Operation::Subtract, backwards));
    expect_equal(either, first_less + volume_of_union(rest), "union = first less others + union of others");
    expect_equal(either, last_less + volume_of_union({backwards.begin() + 1, backwards.end()}),
                 "union = last less others + union of others");
    if (operands_.size() == 2) {
      expect_equal(either + both, input(0) + input(1), "union + intersection = sum");
      expect_equal(measure(checked(Operation::SymmetricDifference, operands_)), either - both,
                   "symmetric difference = union - intersection");
    } else if (operands_.size() == 3) {
      expect_equal(either - both, input(0) + input(1) + input(2) - common_volumes_of_pairs(), "union - intersection = sum - pairs");
    }
    check_simplified(all, either, first_less);
    check_partition(either);
    check_imprint();
    if (!takes_seconds(all)) check_other_words(all);
    if (!takes_seconds(all)) check_prepared(all);
    if (!takes_seconds(all)) check_absolute();
    check_float32(either);
    check_tolerance(either);
  }

  // The same facets, asked for in other words.
  void check_other_words(const BooleanResult& all) {
    std::string letters = "a";
    for (std::size_t k = 1; k < operands_.size(); ++k) letters += std::string("|") + static_cast<char>('a' + k);
    expect_bits(evaluate_expression(letters, operands_, guarded()), all, "an expression");
    expect_bits(implant(operands_, ImplantContact::Drop, guarded()), all, "an implant without contact faces");
    const auto outside = static_cast<KeepMask>(KeepTag::FirstOutside), others = static_cast<KeepMask>(KeepTag::OtherOutside);
    const auto same = static_cast<KeepMask>(KeepTag::OnSame);
    const BooleanResult kept = keep_faces(static_cast<KeepMask>(outside | others | same), operands_, guarded());
    const bool is_as_rounded = !is_uncertified(kept) && kept.report.certificate.repair_displacement == 0 && !is_uncertified(all) &&
                               all.report.certificate.repair_displacement == 0;
    if (is_as_rounded && operands_.size() == 2 && !crosses_itself_ && kept.mesh.triangles.size() != all.mesh.triangles.size())
      add_fault("faces kept by tags are not those of the union");
    const BooleanResult implanted = implant(operands_, ImplantContact::Keep, guarded());
    if (!is_uncertified(implanted) && !crosses_itself_ && is_small_and_crosses(implanted.mesh))
      add_fault("certified implant crosses itself");
  }

  void check_prepared(const BooleanResult& all) {
    std::vector<PreparedOperand> prepared;
    for (const SurfaceMesh* operand : operands_) prepared.emplace_back(*operand);
    const std::vector<Operand> operands(prepared.begin(), prepared.end());
    expect_bits(evaluate_boolean(Operation::Union, operands, guarded()), all, "prepared operands");
  }

  // The level says more, the mesh is the same.
  void check_absolute() {
    BooleanOptions options = guarded();
    options.certify = CertificateLevel::Absolute;
    const BooleanResult result = evaluate_boolean(Operation::Subtract, operands_, options);
    if (!is_uncertified(result) && is_small_and_crosses(result.mesh)) add_fault("absolutely certified, but crosses itself");
  }

  void check_float32(const Measure& either) {
    BooleanOptions options = guarded();
    options.coordinates = Coordinates::Float32;
    try {
      const BooleanResult result = evaluate_boolean(Operation::Union, operands_, options);
      if (is_uncertified(result)) return;
      if (!is_balanced(result.mesh)) add_fault("a float32 union is not closed");
      if (!crosses_itself_ && is_small_and_crosses(result.mesh)) add_fault("certified float32 union crosses itself");
      expect_equal(measure(result), either, "float32 union = union");
    } catch (const Error& error) {
      if (error.code != ErrorCode::OutOfRange || coordinate_ < 0x1p127) throw;
    }
  }

  // Points of faces move by twice the tolerance at most.
  void check_tolerance(const Measure& either) {
    BooleanOptions options = guarded();
    options.tolerance = std::ldexp(coordinate_, -18);
    const BooleanResult result = evaluate_boolean(Operation::Union, operands_, options);
    if (!is_balanced(result.mesh)) add_fault("a union with a tolerance is not closed");
    if (result.report.tolerance.largest_move > options.tolerance) add_fault("a vertex moved farther than the tolerance");
    if (is_uncertified(result) || crosses_itself_) return;
    if (is_small_and_crosses(result.mesh)) add_fault("certified union with a tolerance crosses itself");
    Measure measured = measure(result);
    double area = surface_area(scaled(result.mesh, unit_));
    for (const SurfaceMesh* operand : operands_) area += surface_area(scaled(*operand, unit_));
    measured.tolerance += 2 * area * unit_ * options.tolerance;
    expect_equal(measured, either, "union with a tolerance = union");
  }

  // The same solid on no more triangles; under Simplify::Coplanar all operands are alike.
  void check_simplified(const BooleanResult& all, const Measure& either, const Measure& first_less) {
    const Operands backwards(operands_.rbegin(), operands_.rend());
    for (const Simplify level : {Simplify::Cut, Simplify::Coplanar}) {
      const BooleanResult result = evaluated(Operation::Union, operands_, level);
      expect_equal(measure(result), either, "simplified union = union");
      if (!is_uncertified(result) && !is_uncertified(all) && all.report.certificate.repair_displacement == 0 &&
          result.mesh.triangles.size() > all.mesh.triangles.size())
        add_fault("a simplified union has more triangles");
      if (!is_uncertified(result) && !crosses_itself_ && is_small_and_crosses(result.mesh))
        add_fault("certified when simplified, but crosses itself");
      if (level == Simplify::Coplanar) expect_same(result, evaluated(Operation::Union, backwards, level), "simplified union");
      expect_equal(measure(evaluated(Operation::Subtract, operands_, level)), first_less, "simplified difference = difference");
    }
  }

  // Regions are closed only where the result is certified.
  void check_partition(const Measure& either) {
    BooleanResult result = evaluate_boolean(Operation::Partition, operands_, guarded());
    if (is_uncertified(result)) {
      outcome_.is_uncertified = true;
      return;
    }
    const Operands backwards(operands_.rbegin(), operands_.rend());
    if (!takes_seconds(result)) expect_same(result, evaluate_boolean(Operation::Partition, backwards, guarded()), "partition");
    const std::vector<ResultRegion> regions = find_result_regions(result).regions;
    if (!crosses_itself_) check_model(result.mesh, regions.size());
    Measure sum;
    for (const ResultRegion& region : regions) sum.volume += region.volume * unit_ * unit_ * unit_;
    sum.tolerance = measure_tolerance(result);
    expect_equal(sum, either, "regions of the partition = union");
    if (!crosses_itself_ && is_small_and_crosses(result.mesh)) add_fault("certified partition crosses itself");
  }

  void check_model(const SurfaceMesh& mesh, std::size_t regions) {
    const ClassifiedBrep model = build_brep(mesh);
    for (const std::string& fault : find_faults(mesh, model)) add_fault("model of the partition: " + fault);
    const std::vector<std::uint8_t> voids = find_voids(mesh, model);
    const auto solids = static_cast<std::size_t>(std::count(voids.begin() + 1, voids.end(), 0));
    if (solids != regions) add_fault("a partition of " + std::to_string(regions) + " regions has a model of " + std::to_string(solids));
  }

  void check_imprint() {
    const ImprintResult result = imprint(operands_, guarded());
    if (is_uncertified(result.whole)) outcome_.is_uncertified = true;
    for (std::size_t k = 0; k < operands_.size(); ++k) {
      const SurfaceMesh& mesh = result.operands[k].mesh;
      if (!is_balanced(mesh)) add_fault("an imprinted operand is not closed");
      const Measure volume{exact_volume(scaled(mesh, unit_)), measure_tolerance(result.whole)};
      expect_equal(volume, input(k), "imprinted operand = operand");
    }
  }

  [[nodiscard]] bool takes_seconds(const BooleanResult& result) const { return result.report.certificate.snap_rounds > 0 && faces_ > 1000; }

  [[nodiscard]] bool is_exact() const { return family_ == Family::Grid; }

  void add_fault(const std::string& text) { outcome_.faults += text.back() == '\n' ? text : text + '\n'; }

  // Cancelled when it takes too long.
  [[nodiscard]] BooleanOptions guarded() {
    BooleanOptions options;
    options.progress = [this, start = processor_seconds()](std::string_view, double) {
      const double seconds = processor_seconds() - start;
      outcome_.is_slow = outcome_.is_slow || seconds > slow_seconds;
      return seconds <= most_seconds;
    };
    return options;
  }

  /// Checked without looking at every face and vertex in rationals.
  BooleanResult evaluated(Operation operation, const Operands& operands, Simplify level = Simplify::Off) {
    BooleanOptions options = guarded();
    options.simplify = level;
    BooleanResult result = evaluate_boolean(operation, operands, options);
    std::string faults = faults_of_mesh(result);
    if (is_uncertified(result)) {
      outcome_.is_uncertified = true;
      faults = without_allowed(faults);
      if (!is_balanced(result.mesh)) faults += "edge not balanced\n";
    }
    add_faults(operation, operands, faults);
    const double displacement = result.report.certificate.largest_displacement;
    outcome_.displacement = std::max(outcome_.displacement, displacement / std::ldexp(coordinate_, -52));
    return result;
  }

  BooleanResult checked(Operation operation, const Operands& operands) {
    BooleanResult result = evaluated(operation, operands);
    if (is_uncertified(result)) return result;
    std::string faults;
    if (!crosses_itself_ && is_small_and_crosses(result.mesh)) faults += "certified, but crosses itself\n";
    if (faces_ <= most_faces_for_provenance) {
      faults += faults_of_provenance(operands, result, is_exact() ? Repairs::None : Repairs::Allowed);
    }
    add_faults(operation, operands, faults + faults_of_volume(operation, operands, result));
    return result;
  }

  void add_faults(Operation operation, const Operands& operands, const std::string& faults) {
    if (faults.empty()) return;
    add_fault(std::string(operation_name(operation)) + " of " + std::to_string(operands.size()) + ":\n" + faults);
  }

  std::string faults_of_volume(Operation operation, const Operands& operands, const BooleanResult& result) {
    if (is_exact()) {
      const bool agrees = oracle::volume(result.mesh, exact_positions(operands, result)) == oracle_.of(operation, operands);
      return agrees ? "" : "volume before rounding is not the oracle's\n";
    }
    if (!has_quick_volumes_ || crosses_itself_) return "";
    const Measure measured = measure(result);
    const double cubic_unit = unit_ * unit_ * unit_;
    const double expected = cubic_unit * oracle::nearest_double(oracle_.of(operation, operands));
    return std::fabs(measured.volume - expected) <= measured.tolerance ? "" : "volume is not the oracle's\n";
  }

  /// In units in which the largest coordinate is between 1/2 and 1.
  [[nodiscard]] Measure measure(const BooleanResult& result) const {
    return {shape_of(scaled(result.mesh, unit_)).volume, measure_tolerance(result)};
  }

  [[nodiscard]] double measure_tolerance(const BooleanResult& result) const {
    BooleanReport report;
    report.certificate.largest_displacement = unit_ * result.report.certificate.largest_displacement;
    double volumes = 0;
    for (std::size_t i = 0; i < operands_.size(); ++i) volumes += input(i).volume;
    return identity_tolerance(volumes, surface_area(scaled(result.mesh, unit_)), report, unit_ * coordinate_);
  }

  [[nodiscard]] Measure input(std::size_t i) const { return {exact_volume(scaled(*operands_[i], unit_)), 0}; }

  Measure volume_of_union(const Operands& operands) {
    if (operands.size() == 1) return {exact_volume(scaled(*operands[0], unit_)), 0};
    return measure(evaluated(Operation::Union, operands));
  }

  Measure common_volumes_of_pairs() {
    Measure sum;
    for (const auto& [i, j] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}}) {
      sum = sum + measure(evaluated(Operation::Intersect, {operands_[i], operands_[j]}));
    }
    return sum;
  }

  void expect_equal(const Measure& a, const Measure& b, const std::string& identity) {
    const Measure difference = a - b;
    if (std::fabs(difference.volume) <= difference.tolerance) return;
    std::ostringstream text;
    text << identity << " is off by " << difference.volume << ", allowed " << difference.tolerance;
    add_fault(text.str());
  }

  void expect_bits(const BooleanResult& result, const BooleanResult& expected, const std::string& name) {
    if (result.mesh.points != expected.mesh.points || result.mesh.triangles != expected.mesh.triangles)
      add_fault(name + " has not the bits of the union");
  }

  void expect_same(const BooleanResult& forwards, const BooleanResult& backwards, const std::string& name) {
    if (sorted_points(forwards.mesh) != sorted_points(backwards.mesh)) add_fault("the order of operands changes points of the " + name);
    if (forwards.mesh.triangles.size() != backwards.mesh.triangles.size()) add_fault("the order of operands changes faces of the " + name);
    if (forwards.graph.edges.size() != backwards.graph.edges.size()) add_fault("the order of operands changes the graph of the " + name);
  }

  Family family_;
  Operands operands_;
  OracleVolumes oracle_;
  double start_ = processor_seconds();
  std::size_t faces_ = 0;
  double coordinate_ = 0, unit_ = 1;
  bool crosses_itself_ = false, has_quick_volumes_ = false;
  CaseOutcome outcome_;
};

}  // namespace

CaseOutcome check_case(const RandomCase& random_case) { return CaseCheck(random_case).run(); }

}  // namespace mortise::test
