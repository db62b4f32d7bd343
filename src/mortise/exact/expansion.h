// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Exact sums of doubles (Shewchuk 1997) in arrays whose size the type knows: nothing is allocated.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>

#include "mortise/exact/double_double.h"
#include "mortise/exact/sign.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// The sum of `size` terms, none zero, of growing magnitude and nonoverlapping: the sign is that of the last one. Exact as
/// long as no operation overflows or underflows; whoever starts a computation checks the range of its input.
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

/// Shewchuk's LINEAR-EXPANSION-SUM: asks no more of its terms than that they do not overlap.
template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
  Expansion<N + M> result;
  std::size_t i = 0, j = 0;
  const auto smallest = [&] {
    if (j == b.size || (i < a.size && std::fabs(a.terms[i]) < std::fabs(b.terms[j]))) return a.terms[i++];
    return b.terms[j++];
  };
  const std::size_t total = a.size + b.size;
  if (total == 0) return result;
  double high = smallest(), low = 0;
  for (std::size_t k = 1; k < total; ++k) {
    const double term = smallest();
    const ExactSum r = k == 1 ? ExactSum{term, 0} : quick_two_sum(term, low);
    if (k > 1) result.push(r.error);
    const ExactSum q = k == 1 ? quick_two_sum(term, high) : two_sum(high, r.sum);
    high = q.sum;
    low = q.error;
  }
  result.push(low);
  result.push(high);
  return result;
}

template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
  return a + (-b);
}

/// Shewchuk's SCALE-EXPANSION.
template <std::size_t N>
[[nodiscard]] Expansion<2 * N> scaled(const Expansion<N>& a, double factor) {
  Expansion<2 * N> result;
  if (a.size == 0) return result;
  ExactSum q = two_product(a.terms[0], factor);
  result.push(q.error);
  for (std::size_t i = 1; i < a.size; ++i) {
    const ExactSum product = two_product(a.terms[i], factor);
    const ExactSum s = two_sum(q.sum, product.error);
    result.push(s.error);
    q = quick_two_sum(product.sum, s.sum);
    result.push(q.error);
  }
  result.push(q.sum);
  return result;
}

/// The product with a difference of two doubles.
template <std::size_t N>
[[nodiscard]] Expansion<4 * N> operator*(const Expansion<N>& a, const Expansion<2>& b) {
  if (b.size == 2) return scaled(a, b.terms[0]) + scaled(a, b.terms[1]);
  Expansion<4 * N> result;
  if (b.size == 0) return result;
  const Expansion<2 * N> only = scaled(a, b.terms[0]);
  result.size = only.size;
  for (std::size_t i = 0; i < only.size; ++i) result.terms[i] = only.terms[i];
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
