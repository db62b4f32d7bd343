// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Expressions: what they mean, where they are wrong, and as booleans against folds of pairs and samples of space.
#include "mortise/boolean/expression.h"

#include <functional>
#include <memory>

#include "mortise/boolean/evaluate_expression.h"
#include "mortise/mesh/measures.h"
#include "support/boolean_checks.h"
#include "support/boolean_oracle.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/mesh_checks.h"
#include "support/random_solids.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

/// The value for every choice of operands: bit k of the index is operand k.
std::string truth_table(const std::string& text, std::size_t operands) {
  const Expression expression(text, operands);
  RunningExpression running(expression);
  RunningWinding winding(std::vector<int>(operands, 0));
  std::string table;
  for (std::size_t choice = 0; choice < std::size_t{1} << operands; ++choice) {
    std::vector<int> target;
    for (std::size_t k = 0; k < operands; ++k) target.push_back(static_cast<int>(choice >> k & 1U));
    winding.change_to(target);
    table += running.value_in(winding) ? '1' : '0';
    winding.forget_crossed();
  }
  return table;
}

std::string message_of(const std::string& text, std::size_t operands) {
  const auto error = error_of([&] { const Expression expression(text, operands); });
  if (!error) return "no error";
  CHECK(error->code == ErrorCode::InvalidArgument);
  return error->message;
}

}  // namespace

TEST_CASE("operators mean what sets mean by them", "[expression]") {
  CHECK(truth_table("a", 2) == "0101");
  CHECK(truth_table("a | b", 2) == "0111");
  CHECK(truth_table("a & b", 2) == "0001");
  CHECK(truth_table("a - b", 2) == "0100");
  CHECK(truth_table("a ^ b", 2) == "0110");
  CHECK(truth_table("!a", 2) == "1010");
  CHECK(truth_table("!!a", 1) == "01");
  CHECK(truth_table("a & a", 1) == "01");
  CHECK(truth_table("a ^ a", 1) == "00");
  CHECK(truth_table("B|#0", 2) == "0111");
}

TEST_CASE("without binds tighter than and, and tighter than either, either tighter than or", "[expression]") {
  CHECK(truth_table("a | b & c", 3) == truth_table("a | (b & c)", 3));
  CHECK(truth_table("a & b - c", 3) == truth_table("a & (b - c)", 3));
  CHECK(truth_table("a ^ b & c", 3) == truth_table("a ^ (b & c)", 3));
  CHECK(truth_table("a | b ^ c", 3) == truth_table("a | (b ^ c)", 3));
  CHECK(truth_table("a | b - c", 3) == truth_table("a | (b - c)", 3));
  CHECK(truth_table("a - b - c", 3) == truth_table("(a - b) - c", 3));
  CHECK(truth_table("!a & b", 2) == truth_table("(!a) & b", 2));
  CHECK(truth_table("a - (b - c)", 3) != truth_table("a - b - c", 3));
  CHECK(truth_table("(a|b)&!c", 3) == "01110000");
}

TEST_CASE("a wrong expression is refused with its column", "[expression]") {
  CHECK(message_of("", 2) == "column 1: an operand is missing");
  CHECK(message_of("a |", 2) == "column 4: an operand is missing");
  CHECK(message_of("a | | b", 2) == "column 5: an operand is expected, not '|'");
  CHECK(message_of("a b", 2) == "column 3: an operator is expected, not 'b'");
  CHECK(message_of("(a | b", 2) == "column 1: this '(' is not closed");
  CHECK(message_of("a | b)", 2) == "column 6: ')' without '('");
  CHECK(message_of("()", 2) == "column 2: an operand is expected, not ')'");
  CHECK(message_of("a | c", 2) == "column 5: there is no such operand, the call has 2");
  CHECK(message_of("a | #2", 2) == "column 5: there is no such operand, the call has 2");
  CHECK(message_of("#", 2) == "column 1: a number is expected after '#'");
  CHECK(message_of("#99999999999999999999", 2) == "column 1: no operand has this number");
  CHECK(message_of("hull | b", 2) == "column 1: operands are single letters, or # and a number");
  CHECK(message_of("a + b", 2) == "column 3: an operator is expected, not '+'");
  CHECK(message_of("a !b", 2) == "column 3: an operator is expected, not '!'");
}

TEST_CASE("an expression that is true outside all operands is refused", "[expression]") {
  const SurfaceMesh unit = box({0, 0, 0}, {1, 1, 1});
  const auto error = error_of([&] { (void)evaluate_expression("a | !a", std::array{&unit}); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InvalidArgument);
  const auto always = error_of([&] { (void)evaluate_where([](const RunningWinding&) { return true; }, std::array{&unit}); });
  REQUIRE(always);
  CHECK(always->code == ErrorCode::InvalidArgument);
}

TEST_CASE("a thousand operands by number, nested and in a row", "[expression]") {
  constexpr std::size_t count = 1000;
  std::vector<SurfaceMesh> pairs;
  for (std::size_t i = 0; i < count; i += 2) {
    const double x = 3 * static_cast<double>(i);
    pairs.push_back(box({x, 0, 0}, {x + 1, 1, 1}));
    pairs.push_back(box({x + 0.5, 0.5, 0.5}, {x + 1.5, 1.5, 1.5}));
  }
  std::string odd_without_even = "(#1", nested = "#0";
  for (std::size_t i = 3; i < count; i += 2) odd_without_even += " | #" + std::to_string(i);
  odd_without_even += ")";
  for (std::size_t i = 0; i < count; i += 2) odd_without_even += " - #" + std::to_string(i);
  for (std::size_t i = 1; i < count; ++i) nested = "#" + std::to_string(i) + " ^ (" + nested + ")";
  CHECK(exact_volume(evaluate_expression(odd_without_even, pointers_to(pairs)).mesh) == 500 * 0.875);
  CHECK(exact_volume(evaluate_expression(nested, pointers_to(pairs)).mesh) == 500 * 1.75);
}

TEST_CASE("a rule of the caller sees which operands contain a region", "[expression]") {
  const std::vector<SurfaceMesh> row{box({0, 0, 0}, {4, 1, 1}), box({1, 0, 0}, {5, 1, 1}), box({2, 0, 0}, {3, 1, 1})};
  const BooleanResult twice = evaluate_where([](const RunningWinding& w) { return w.inside_count() == 2; }, pointers_to(row));
  CHECK(exact_volume(twice.mesh) == 2);
  CHECK(faults_of(pointers_to(row), twice) == "");
  const auto last = [](const RunningWinding& w) {
    return w.is_inside(OperandId(std::size_t{1})) && !w.is_inside(OperandId(std::size_t{0}));
  };
  CHECK(exact_volume(evaluate_where(last, pointers_to(row)).mesh) == 1);
}

TEST_CASE("the symmetric difference is the union less the intersection, bit for bit", "[expression]") {
  for (std::size_t seed = 1; seed <= scaled_count(50, 1000); ++seed) {
    INFO("seed " << seed);
    const std::vector<SurfaceMesh> pair = RandomSolids(seed).next(2);
    const SurfaceMesh odd = evaluate(Operation::SymmetricDifference, pair).mesh;
    CHECK(has_same_bits(evaluate_expression("a ^ b", pointers_to(pair)).mesh, odd));
    CHECK(has_same_bits(evaluate_expression("(a | b) - (a & b)", pointers_to(pair)).mesh, odd));
  }
}

namespace {

using Bits = std::vector<bool>;

/// An expression without complements but in differences: as text, as a function of operands, and as booleans of pairs.
struct RandomExpression {
  std::string text;
  std::function<bool(const Bits&)> holds;
  SurfaceMesh folded;
};

RandomExpression random_leaf(const std::vector<SurfaceMesh>& solids, RandomSource& random) {
  const std::size_t k = random.below(solids.size());
  const std::string name = random.once_in(3) ? "#" + std::to_string(k)
                                             : std::string(1, static_cast<char>((random.once_in(2) ? 'a' : 'A') + static_cast<int>(k)));
  return {name, [k](const Bits& bits) { return bits[k]; }, solids[k]};
}

RandomExpression joined_by(std::size_t choice, const RandomExpression& a, const RandomExpression& b) {
  const auto text = [&](const char* symbol) { return "(" + a.text + symbol + b.text + ")"; };
  const auto fold = [&](Operation operation) { return evaluate(operation, {a.folded, b.folded}).mesh; };
  const auto p = a.holds, q = b.holds;
  switch (choice) {
    case 0:
      return {text(" | "), [p, q](const Bits& bits) { return p(bits) || q(bits); }, fold(Operation::Union)};
    case 1:
      return {text("&"), [p, q](const Bits& bits) { return p(bits) && q(bits); }, fold(Operation::Intersect)};
    case 2:
      return {text(" - "), [p, q](const Bits& bits) { return p(bits) && !q(bits); }, fold(Operation::Subtract)};
    case 3:
      return {text(" & !"), [p, q](const Bits& bits) { return p(bits) && !q(bits); }, fold(Operation::Subtract)};
    default:
      return {text("^"), [p, q](const Bits& bits) { return p(bits) != q(bits); }, fold(Operation::SymmetricDifference)};
  }
}

RandomExpression random_expression(const std::vector<SurfaceMesh>& solids, RandomSource& random) {
  std::vector<RandomExpression> terms;
  const std::size_t leaves = solids.size() + random.below(3);
  for (std::size_t i = 0; i < leaves; ++i) terms.push_back(random_leaf(solids, random));
  while (terms.size() > 1) {
    const std::size_t i = random.below(terms.size() - 1);
    terms[i] = joined_by(random.below(5), terms[i], terms[i + 1]);
    terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return terms[0];
}

/// Is the point inside a closed mesh? A slanted ray in doubles where that is certain, else in rationals.
bool contains(const SurfaceMesh& mesh, const Vec3d& p) {
  const Vec3d ray{1, 0.3183, 0.1415};
  int winding = 0;
  const auto exactly = [&] { return oracle::winding_number(mesh, oracle::exact(p)).value() > 0; };
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const oracle::Corners c = oracle::corners_of(mesh, f);
    std::array<int, 3> side{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d a = c[i] - p, b = c[(i + 1) % 3] - p;
      const double turn = dot(ray, cross(a, b));
      if (std::abs(turn) < 1e-9) return exactly();
      side[i] = turn > 0 ? 1 : -1;
    }
    if (side[0] != side[1] || side[1] != side[2]) continue;
    const double ahead = dot(c[0] - p, cross(c[1] - p, c[2] - p)) * side[0];
    if (std::abs(ahead) < 1e-9) return exactly();
    if (ahead > 0) winding += side[0];
  }
  return winding > 0;
}

}  // namespace

TEST_CASE("random expressions are the folds of their pairs, and hold at samples of space as their operands say", "[expression]") {
  std::size_t inside = 0;
  for (std::size_t seed = 1; seed <= scaled_count(200, 2000); ++seed) {
    RandomSolids random(seed);
    const std::vector<SurfaceMesh> solids = random.next(3 + random.below(3));
    const RandomExpression expression = random_expression(solids, random);
    INFO("seed " << seed << ": " << expression.text);
    const BooleanResult result = evaluate_expression(expression.text, pointers_to(solids));
    CHECK(faults_of_mesh(result) == "");
    CHECK(enclosed_volume(result.mesh) == Approx(enclosed_volume(expression.folded)).epsilon(1e-9).margin(1e-9));
    for (int sample = 0; sample < 500; ++sample) {
      const Vec3d p = random.point(0, 5);
      Bits bits;
      for (const SurfaceMesh& solid : solids) bits.push_back(contains(solid, p));
      const bool is_inside = contains(result.mesh, p);
      inside += is_inside ? 1 : 0;
      if (is_inside != expression.holds(bits)) FAIL_CHECK("at " << p.x << ", " << p.y << ", " << p.z);
    }
  }
  CHECK(inside > 5 * scaled_count(200, 2000));
}
