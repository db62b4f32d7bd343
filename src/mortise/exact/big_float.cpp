// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Schoolbook arithmetic on digits of base 2^32: the numbers met are a few dozen digits long.
#include "mortise/exact/big_float.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "mortise/base/bits.h"
#include "mortise/exact/double_double.h"

namespace mortise {

namespace {

/// Adds b[0, n) to a and carries on as far as needed. The sum fits.
void add_limbs(std::uint32_t* a, const std::uint32_t* b, std::size_t n) {
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < n; ++i) {
    carry += std::uint64_t{a[i]} + b[i];
    a[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  for (std::size_t i = n; carry != 0; ++i) {
    carry += a[i];
    a[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
}

/// Subtracts b[0, n) from a and borrows as far as needed. The difference is not negative.
void subtract_limbs(std::uint32_t* a, const std::uint32_t* b, std::size_t n) {
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t digit = std::uint64_t{a[i]} - b[i] - borrow;
    a[i] = static_cast<std::uint32_t>(digit);
    borrow = digit >> 63;
  }
  for (std::size_t i = n; borrow != 0; ++i) {
    borrow = a[i] == 0 ? 1 : 0;
    --a[i];
  }
}

/// A digit between -2^31 and 2^31 and its place.
struct SignedDigit {
  std::int64_t value;
  std::size_t place;
};

/// The digits that are not zero when they may be negative. Sums and differences of doubles far apart have few: what lies between the
/// doubles are digits 0, or 2^32 - 1 where one was subtracted. Up to a number of them; then the answer is that there are more.
class SparseDigits {
 public:
  static constexpr std::size_t most = 48;

  explicit SparseDigits(const LimbArray& limbs) {
    std::int64_t carry = 0;
    const std::uint32_t* digits = limbs.begin();
    for (std::size_t i = 0; i <= limbs.size(); ++i) {
      const std::int64_t digit = carry + (i < limbs.size() ? std::int64_t{digits[i]} : 0);
      carry = digit > 0x7fffffff ? 1 : 0;
      const std::int64_t value = digit - carry * 0x100000000;
      if (value == 0) continue;
      if (count_ == most) {
        has_more_ = true;
        return;
      }
      digits_[count_++] = {value, i};
    }
  }

  [[nodiscard]] bool has_more() const { return has_more_; }
  [[nodiscard]] std::span<const SignedDigit> all() const { return {digits_.data(), count_}; }

 private:
  std::array<SignedDigit, most> digits_;
  std::size_t count_ = 0;
  bool has_more_ = false;
};

/// Fills n digits with the product, which is positive and fits.
void multiply_sparse(const SparseDigits& a, const SparseDigits& b, std::uint32_t* product, std::size_t n) {
  std::vector<std::int64_t> columns(n + 2, 0);
  for (const SignedDigit& d : a.all()) {
    for (const SignedDigit& e : b.all()) {
      const std::int64_t value = d.value * e.value;
      columns[d.place + e.place] += value & 0xffffffff;
      columns[d.place + e.place + 1] += value >> 32;
    }
  }
  std::int64_t carry = 0;
  for (std::size_t i = 0; i < n; ++i) {
    carry += columns[i];
    product[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
}

/// Adds factor * b to the digits from `a` on; the one after the last of b is still zero.
void add_product(std::uint32_t* a, std::uint32_t factor, const LimbArray& b) {
  std::uint64_t carry = 0;
  for (const std::uint32_t limb : b) {
    carry += std::uint64_t{factor} * limb + *a;
    *a++ = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  *a = static_cast<std::uint32_t>(carry);
}

}  // namespace

BigFloat::BigFloat(double x) : BigFloat(x > 0 ? 1 : x < 0 ? -1 : 0, 0, x == 0 ? 0 : 3) {
  if (sign_ == 0) return;
  const auto bits = cast_bits<std::uint64_t>(x);
  const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffffULL;
  const std::uint64_t mantissa = biased == 0 ? fraction : fraction | 0x10000000000000ULL;
  const int shifted = (biased == 0 ? 1 : biased) - 1075 + 1088;  // 1088 = 34 * 32 makes it positive
  const unsigned shift = static_cast<unsigned>(shifted) % 32;
  exponent_ = shifted / 32 - 34;
  std::uint32_t* limbs = limbs_.begin();
  const std::uint64_t low = mantissa << shift;
  limbs[0] = static_cast<std::uint32_t>(low);
  limbs[1] = static_cast<std::uint32_t>(low >> 32);
  limbs[2] = shift == 0 ? 0 : static_cast<std::uint32_t>(mantissa >> (64 - shift));
  trim();
}

BigFloat BigFloat::difference(double a, double b) {
  const ExactSum s = two_sum(a, -b);
  if (s.error == 0) return BigFloat(s.sum);  // most often; an overflow makes the error NaN
  return BigFloat(a) - BigFloat(b);
}

BigFloat::Leading BigFloat::leading() const {
  double value = 0;
  const std::uint32_t* limbs = limbs_.begin();
  for (std::uint32_t i = 0; i < 3; ++i) {
    value = value * 0x1p32 + (i < limbs_.size() ? limbs[limbs_.size() - 1 - i] : 0.0);
  }
  return {sign_ * value, 32 * (top() - 3)};
}

BigFloat BigFloat::operator-() const& {
  BigFloat result = *this;
  result.sign_ = -sign_;
  return result;
}

BigFloat BigFloat::operator-() && {
  sign_ = -sign_;
  return std::move(*this);
}

void BigFloat::trim() {
  const std::uint32_t* limbs = limbs_.begin();
  std::uint32_t high = limbs_.size(), low = 0;
  while (limbs[high - 1] == 0) --high;
  while (limbs[low] == 0) ++low;
  if (low > 0) std::copy(limbs + low, limbs + high, limbs_.begin());
  limbs_.shrink(high - low);
  exponent_ += static_cast<int>(low);
}

int BigFloat::compare_sizes(const BigFloat& a, const BigFloat& b) {
  if (a.top() != b.top()) return a.top() < b.top() ? -1 : 1;
  const std::uint32_t shared = std::min(a.limbs_.size(), b.limbs_.size());
  const std::uint32_t* a_end = a.limbs_.end();
  const std::uint32_t* b_end = b.limbs_.end();
  for (std::uint32_t i = 1; i <= shared; ++i) {
    if (*(a_end - i) != *(b_end - i)) return *(a_end - i) < *(b_end - i) ? -1 : 1;
  }
  return a.limbs_.size() == b.limbs_.size() ? 0 : a.limbs_.size() < b.limbs_.size() ? -1 : 1;
}

BigFloat BigFloat::sum_of_sizes(const BigFloat& a, const BigFloat& b, int sign) {
  const int exponent = std::min(a.exponent_, b.exponent_);
  BigFloat result(sign, exponent, static_cast<std::size_t>(std::max(a.top(), b.top()) - exponent + 1));
  std::uint32_t* limbs = result.limbs_.begin();
  std::uint32_t* after_a = std::copy(a.limbs_.begin(), a.limbs_.end(), std::fill_n(limbs, a.exponent_ - result.exponent_, 0U));
  std::fill(after_a, result.limbs_.end(), 0U);
  add_limbs(limbs + (b.exponent_ - result.exponent_), b.limbs_.begin(), b.limbs_.size());
  result.trim();
  return result;
}

BigFloat BigFloat::difference_of_sizes(const BigFloat& a, const BigFloat& b, int sign) {
  const int exponent = std::min(a.exponent_, b.exponent_);
  BigFloat result(sign, exponent, static_cast<std::size_t>(a.top() - exponent));
  std::uint32_t* limbs = result.limbs_.begin();
  std::copy(a.limbs_.begin(), a.limbs_.end(), std::fill_n(limbs, a.exponent_ - result.exponent_, 0U));
  subtract_limbs(limbs + (b.exponent_ - result.exponent_), b.limbs_.begin(), b.limbs_.size());
  result.trim();
  return result;
}

BigFloat BigFloat::sum(const BigFloat& a, const BigFloat& b, int sign_of_b) {
  if (sign_of_b == 0) return a;
  if (a.sign_ == 0) return sign_of_b == b.sign_ ? b : -b;
  if (a.sign_ == sign_of_b) return sum_of_sizes(a, b, a.sign_);
  const int order = compare_sizes(a, b);
  if (order == 0) return BigFloat();
  return order > 0 ? difference_of_sizes(a, b, a.sign_) : difference_of_sizes(b, a, sign_of_b);
}

BigFloat operator*(const BigFloat& a, const BigFloat& b) {
  if (a.sign_ == 0 || b.sign_ == 0) return BigFloat();
  const LimbArray &x = a.limbs_.size() < b.limbs_.size() ? a.limbs_ : b.limbs_, &y = &x == &a.limbs_ ? b.limbs_ : a.limbs_;
  BigFloat result(a.sign_ * b.sign_, a.exponent_ + b.exponent_, std::size_t{x.size()} + y.size());
  std::uint32_t* limbs = result.limbs_.begin();
  constexpr std::size_t long_enough = 8;  // for gaps
  if (y.size() >= long_enough) {
    const SparseDigits few(x), others(y);
    if (!few.has_more() && !others.has_more() && 3 * few.all().size() * others.all().size() < std::size_t{x.size()} * y.size()) {
      multiply_sparse(few, others, limbs, result.limbs_.size());
      result.trim();
      return result;
    }
  }
  std::fill_n(limbs, result.limbs_.size(), 0U);
  for (const std::uint32_t limb : x) {
    if (limb != 0) add_product(limbs, limb, y);
    ++limbs;
  }
  result.trim();
  return result;
}

}  // namespace mortise
