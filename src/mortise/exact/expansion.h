// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Exact sums of doubles (Shewchuk 1997) in arrays whose size the type knows: nothing is allocated.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <span>

#include "mortise/exact/double_double.h"
#include "mortise/exact/sign.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// Terms of growing magnitude that do not overlap, none of them zero; their sum is the number.
using ExpansionTerms = std::span<const double>;

/// Writes the terms of a + b, at most a.size() + b.size(), and returns how many there are. Shewchuk's LINEAR-EXPANSION-SUM:
/// it asks no more of the terms than that they do not overlap.
[[nodiscard]] inline std::size_t add_expansions(ExpansionTerms a, ExpansionTerms b, double* result) {
  std::size_t i = 0, j = 0, size = 0;
  const auto take_smallest = [&] {
    const bool from_a = j == b.size() || (i < a.size() && std::fabs(a[i]) < std::fabs(b[j]));
    return from_a ? a[i++] : b[j++];
  };
  const auto push = [&](double term) {
    if (term != 0) result[size++] = term;
  };
  const std::size_t total = a.size() + b.size();
  if (total == 0) return 0;
  ExactSum sum{take_smallest(), 0};
  if (total > 1) sum = quick_two_sum(take_smallest(), sum.sum);
  for (std::size_t k = 2; k < total; ++k) {
    const ExactSum next = quick_two_sum(take_smallest(), sum.error);
    push(next.error);
    sum = two_sum(sum.sum, next.sum);
  }
  push(sum.error);
  push(sum.sum);
  return size;
}

/// Writes the terms of a * factor, at most 2 a.size(), and returns how many there are. Shewchuk's SCALE-EXPANSION.
[[nodiscard]] inline std::size_t scale_expansion(ExpansionTerms a, double factor, double* result) {
  std::size_t size = 0;
  const auto push = [&](double term) {
    if (term != 0) result[size++] = term;
  };
  if (a.empty()) return 0;
  ExactSum high = two_product(a[0], factor);
  push(high.error);
  for (std::size_t i = 1; i < a.size(); ++i) {
    const ExactSum product = two_product(a[i], factor);
    const ExactSum low = two_sum(high.sum, product.error);
    push(low.error);
    high = quick_two_sum(product.sum, low.sum);
    push(high.error);
  }
  push(high.sum);
  return size;
}

/// A number of at most Capacity terms; its sign is that of the last. Exact as long as no operation overflows or underflows:
/// whoever starts a computation checks the range of its input.
template <std::size_t Capacity>
struct Expansion {
  std::size_t size = 0;
  std::array<double, Capacity> terms;

  Expansion() {}  // NOLINT: terms beyond `size` are never read, and not zeroed

  /// a - b.
  [[nodiscard]] static Expansion difference(double a, double b) requires(Capacity == 2) {
    const ExactSum s = two_sum(a, -b);
    Expansion result;
    result.push(s.error);
    result.push(s.sum);
    return result;
  }

  [[nodiscard]] Sign sign() const { return size == 0 ? Sign::Zero : sign_of(terms[size - 1]); }
  void push(double term) {
    if (term != 0) terms[size++] = term;
  }
};

template <std::size_t N>
[[nodiscard]] Expansion<N> operator-(Expansion<N> a) {
  for (std::size_t i = 0; i < a.size; ++i) a.terms[i] = -a.terms[i];
  return a;
}

template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<N + M> result;
  result.size = add_expansions({a.terms.data(), a.size}, {b.terms.data(), b.size}, result.terms.data());
  return result;
}

template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
  return a + (-b);
}

template <std::size_t N>
[[nodiscard]] Expansion<2 * N> scaled(const Expansion<N>& a, double factor) {
  Expansion<2 * N> result;
  result.size = scale_expansion({a.terms.data(), a.size}, factor, result.terms.data());
  return result;
}

/// The product with a difference of two doubles.
template <std::size_t N>
[[nodiscard]] Expansion<4 * N> operator*(const Expansion<N>& a, const Expansion<2>& b) {
  if (b.size == 2) return scaled(a, b.terms[0]) + scaled(a, b.terms[1]);
  Expansion<4 * N> result;
  if (b.size == 1) result.size = scale_expansion({a.terms.data(), a.size}, b.terms[0], result.terms.data());
  return result;
}

/// Can differences of these coordinates be multiplied three at a time without overflow and underflow? Nonzero coordinates
/// are then multiples of 2^-358, their products multiples of 2^-1074, and no coordinate exceeds 2^300.
[[nodiscard]] inline bool is_in_expansion_range(std::initializer_list<Vec3d> points) {
  bool result = true;
  for (const Vec3d& p : points) {
    for (const double x : {p.x, p.y, p.z}) result = result && (x == 0 || (std::fabs(x) >= 0x1p-306 && std::fabs(x) <= 0x1p300));
  }
  return result;
}

}  // namespace mortise
