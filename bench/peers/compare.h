// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Judges two answers to the same four questions.
#pragma once

#include <string>
#include <vector>

#include "shape.h"

namespace mortise::peers {

/// Volumes of the operands.
struct Volumes {
  double a = 0, b = 0;
};

/// How far figures may be apart: 1e-12 for the sums, and what vertices off by the displacements of both sides can make.
struct Tolerance {
  double volume = 0, area = 0;
};
[[nodiscard]] Tolerance tolerance_of(const Shape& ours, const Shape& theirs, double displacement, const Volumes& operands);

/// From best to worst.
enum class Verdict : std::uint8_t {
  Agree,
  PeerRefused,    ///< at least one question
  BeyondDoubles,  ///< volumes agree, the rest differs: our report says that doubles cannot hold a result, the peer's are faulty
  PeerWrong,      ///< where figures differ, the peer's are shown to be wrong and ours are not
  Differ,
};

struct Judgement {
  Verdict verdict = Verdict::Agree;
  std::size_t compared = 0;        ///< questions both answered
  std::vector<std::string> lines;  ///< refusals, differences, contradictions
};

/// The worst verdict on the four questions.
///
/// Where volumes differ the peer is wrong if its volumes contradict each other (V(A) + V(B) = V(union) + V(intersection) and
/// so on) and ours do not. Where volumes agree and areas, shells or Euler numbers differ, it is wrong if its doubles are
/// faulty and ours are not: solids thinner than rounding have no other meaning.
[[nodiscard]] Judgement judge(const Answers& ours, const Answers& theirs, const Volumes& operands);

}  // namespace mortise::peers
