// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Binary numbers of any length: sums, differences and products of doubles without any rounding, of any range. The last
// rung of every predicate.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "mortise/exact/sign.h"

namespace mortise {

/// Digits of base 2^32 of a given number; up to 32 of them without heap memory. The digits start undefined.
class LimbArray {
 public:
  explicit LimbArray(std::size_t size = 0) : size_(static_cast<std::uint32_t>(size)) {
    if (size > inline_limbs) heap_.reset(new std::uint32_t[size]);  // undefined, unlike make_unique's
  }
  LimbArray(const LimbArray& other) : LimbArray(other.size_) { std::copy(other.begin(), other.end(), begin()); }
  LimbArray(LimbArray&& other) noexcept : size_(other.size_), heap_(std::move(other.heap_)) {
    if (!heap_) std::copy_n(other.inline_.data(), size_, inline_.data());
    other.size_ = 0;
  }
  LimbArray& operator=(const LimbArray& other) {
    if (this != &other) *this = LimbArray(other);
    return *this;
  }
  LimbArray& operator=(LimbArray&& other) noexcept {
    size_ = other.size_;
    heap_ = std::move(other.heap_);
    if (!heap_) std::copy_n(other.inline_.data(), size_, inline_.data());
    return *this;
  }
  ~LimbArray() = default;

  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] std::uint32_t* begin() { return heap_ ? heap_.get() : inline_.data(); }
  [[nodiscard]] const std::uint32_t* begin() const { return heap_ ? heap_.get() : inline_.data(); }
  [[nodiscard]] std::uint32_t* end() { return begin() + size_; }
  [[nodiscard]] const std::uint32_t* end() const { return begin() + size_; }

  /// Forgets the digits from `size` on. Memory stays.
  void shrink(std::uint32_t size) { size_ = size; }

 private:
  static constexpr std::size_t inline_limbs = 32;
  std::uint32_t size_;
  std::unique_ptr<std::uint32_t[]> heap_;
  std::array<std::uint32_t, inline_limbs> inline_;
};

/// sign * (sum of limbs[i] * 2^(32 (exponent + i))); the first and the last limb are not zero; zero has none.
class BigFloat {
 public:
  BigFloat() : BigFloat(0, 0, 0) {}
  /// @param x  finite
  explicit BigFloat(double x);

  /// a - b.
  [[nodiscard]] static BigFloat difference(double a, double b);

  [[nodiscard]] Sign sign() const { return sign_of(sign_); }

  /// value * 2^exponent with value of at least 2^64 (zero: 0), within one part in 2^52 of the number.
  struct Leading {
    double value;
    int exponent;
  };
  [[nodiscard]] Leading leading() const;

  [[nodiscard]] BigFloat operator-() const&;
  [[nodiscard]] BigFloat operator-() &&;

  friend BigFloat operator+(const BigFloat& a, const BigFloat& b) { return sum(a, b, b.sign_); }
  friend BigFloat operator-(const BigFloat& a, const BigFloat& b) { return sum(a, b, -b.sign_); }
  friend BigFloat operator*(const BigFloat& a, const BigFloat& b);

 private:
  BigFloat(int sign, int exponent, std::size_t size) : sign_(sign), exponent_(exponent), limbs_(size) {}
  static BigFloat sum(const BigFloat& a, const BigFloat& b, int sign_of_b);
  static BigFloat sum_of_sizes(const BigFloat& a, const BigFloat& b, int sign);
  static BigFloat difference_of_sizes(const BigFloat& a, const BigFloat& b, int sign);
  static int compare_sizes(const BigFloat& a, const BigFloat& b);
  [[nodiscard]] int top() const { return exponent_ + static_cast<int>(limbs_.size()); }
  void trim();

  int sign_;
  int exponent_;
  LimbArray limbs_;
};

}  // namespace mortise
