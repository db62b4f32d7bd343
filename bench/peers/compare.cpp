// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Compares figures, and finds out who contradicts himself where they differ.
#include "compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mortise::peers {
namespace {

struct Both {
  const Answers &ours, &theirs;
  const Volumes& operands;
};

std::string figures_of(const Shape& s) {
  char text[160];
  std::snprintf(text, sizeof text, "volume %.15g area %.15g euler %lld shells %lld open edges %llu", s.volume, s.area,
                static_cast<long long>(s.euler), static_cast<long long>(s.shells), static_cast<unsigned long long>(s.boundary_edges));
  return text;
}

// Written so that NaN differs.
bool is_apart(double x, double y, double tolerance) { return !(std::fabs(x - y) <= tolerance); }

/// Which figures other than the volume differ; empty: none.
std::string differing_figures(const Shape& ours, const Shape& theirs, const Tolerance& tolerance) {
  std::string names;
  if (is_apart(ours.area, theirs.area, tolerance.area)) names += " area";
  if (ours.euler != theirs.euler) names += " euler";
  if (ours.shells != theirs.shells) names += " shells";
  return names;
}

std::string fault_text(const Shape& shape) {
  return std::string(shape.is_uncertified ? ", uncertified" : "") + (shape.fault.empty() ? "" : ", " + shape.fault);
}

double largest_tolerance(const Answers& answers, const Volumes& operands) {
  double largest = 0;
  for (const auto& shape : answers.shapes) {
    if (shape) largest = std::max(largest, tolerance_of(*shape, *shape, answers.displacement, operands).volume);
  }
  return largest;
}

/// The identities of the volumes that are broken; empty: none that could be checked.
std::vector<std::string> contradictions(const std::string& who, const Answers& answers, const Volumes& operands) {
  const double tolerance = 2 * largest_tolerance(answers, operands);
  const auto volume = [&](Question q) { return answers.shapes[q] ? answers.shapes[q]->volume : std::nan(""); };
  std::vector<std::string> lines;
  const auto check = [&](const char* identity, double left, double right) {
    if (!(std::fabs(left - right) > tolerance)) return;
    char text[200];
    std::snprintf(text, sizeof text, "%s: %s is broken by %.3g (tolerance %.3g)", who.c_str(), identity, left - right, tolerance);
    lines.emplace_back(text);
  };
  check("V(A) + V(B) = V(union) + V(intersection)", operands.a + operands.b, volume(United) + volume(Common));
  check("V(A) = V(A - B) + V(intersection)", operands.a, volume(ALessB) + volume(Common));
  check("V(B) = V(B - A) + V(intersection)", operands.b, volume(BLessA) + volume(Common));
  check("V(union) = V(A - B) + V(B)", volume(United), volume(ALessB) + operands.b);
  return lines;
}

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) { lines.insert(lines.end(), more.begin(), more.end()); }

/// Verdict on one question; adds what there is to say.
Verdict judge_question(std::size_t question, const Both& answers, bool peer_contradicts_itself, std::vector<std::string>& lines) {
  const std::string name = question_names[question];
  if (!answers.theirs.shapes[question]) {
    lines.push_back(name + ": CGAL cannot make it manifold");
    return Verdict::PeerRefused;
  }
  const Shape &ours = *answers.ours.shapes[question], &theirs = *answers.theirs.shapes[question];
  const Tolerance tolerance = tolerance_of(ours, theirs, answers.ours.displacement + answers.theirs.displacement, answers.operands);
  const bool is_open = ours.boundary_edges != 0 || theirs.boundary_edges != 0;
  const bool is_volume_apart = is_apart(ours.volume, theirs.volume, tolerance.volume);
  const std::string names = differing_figures(ours, theirs, tolerance);
  if (!is_open && !is_volume_apart && names.empty()) return Verdict::Agree;
  lines.push_back(name + ":" + (is_open ? " open" : "") + (is_volume_apart ? " volume" : "") + names);
  lines.push_back("  ours " + figures_of(ours) + fault_text(ours));
  lines.push_back("  CGAL " + figures_of(theirs) + fault_text(theirs));
  if (is_open) return Verdict::Differ;
  if (is_volume_apart) return peer_contradicts_itself ? Verdict::PeerWrong : Verdict::Differ;
  if (theirs.fault.empty()) return Verdict::Differ;
  if (ours.is_uncertified) return Verdict::BeyondDoubles;
  return ours.fault.empty() ? Verdict::PeerWrong : Verdict::Differ;
}

}  // namespace

Tolerance tolerance_of(const Shape& ours, const Shape& theirs, double displacement, const Volumes& operands) {
  constexpr double of_sums = 1e-12;
  return {of_sums * (operands.a + operands.b) + displacement * (ours.area + theirs.area),
          of_sums * (ours.area + theirs.area) + displacement * (ours.perimeters + theirs.perimeters)};
}

Judgement judge(const Answers& ours, const Answers& theirs, const Volumes& operands) {
  if (!ours.refusal.empty()) return {Verdict::Differ, 0, {"we refuse: " + ours.refusal}};
  if (!theirs.refusal.empty()) return {Verdict::PeerRefused, 0, {theirs.refusal}};
  Judgement judgement;
  const std::vector<std::string> our_faults = contradictions("ours", ours, operands);
  const std::vector<std::string> their_faults = contradictions("CGAL", theirs, operands);
  const bool contradicts_itself = our_faults.empty() && !their_faults.empty();
  for (std::size_t i = 0; i < question_names.size(); ++i) {
    const Verdict verdict = judge_question(i, {ours, theirs, operands}, contradicts_itself, judgement.lines);
    judgement.verdict = std::max(judgement.verdict, verdict);
    judgement.compared += theirs.shapes[i] ? 1 : 0;
  }
  append(judgement.lines, our_faults);
  append(judgement.lines, their_faults);
  return judgement;
}

}  // namespace mortise::peers
