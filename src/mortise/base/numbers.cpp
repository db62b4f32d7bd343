// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Number text: reading by fast_float, printing by Schubfach (R. Giulietti, "The Schubfach way to render doubles", 2020).
#include "mortise/base/numbers.h"

#include <fast_float/fast_float.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <system_error>

#include "mortise/base/bits.h"

namespace mortise {
namespace {

bool starts_with_word(std::string_view text, std::string_view lower_word) {
  if (text.size() < lower_word.size()) return false;
  for (std::size_t i = 0; i < lower_word.size(); ++i) {
    const char c = text[i];
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (lower != lower_word[i]) return false;
  }
  return true;
}

/// Words for what is not finite, in C, in JavaScript and in old Windows runtimes ("1.#INF", "-1.#IND").
bool is_not_finite_word(std::string_view unsigned_text) {
  return starts_with_word(unsigned_text, "nan") || starts_with_word(unsigned_text, "inf") || starts_with_word(unsigned_text, "1.#");
}

bool may_start_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }

// ---- Printing -------------------------------------------------------------------------------------------------------

using Uint128 = unsigned __int128;

/// A positive number digits * 10^exponent.
struct Decimal {
  std::uint64_t digits;
  int exponent;
};

/// A positive binary number significand * 2^exponent whose neighbours lie half a unit of the significand away;
/// the lower one only a quarter when the significand is the smallest of its exponent.
struct Binary {
  std::uint64_t significand;
  int exponent;
  bool lower_is_closer;
};

int floor_log2_pow10(int e) { return (e * 1741647) >> 19; }
int floor_log10_pow2(int e) { return (e * 1262611) >> 22; }
int floor_log10_three_quarters_pow2(int e) { return (e * 1262611 - 524031) >> 22; }

constexpr int min_power = -292;
constexpr int max_power = 324;
constexpr std::size_t limb_count = 27;  // 864 bits: 10^324 without its power of two needs 753, and 2^863 / 5^292 keeps 185

/// A natural number of 32-bit limbs, the lowest first: just enough to make the table of powers.
using Limbs = std::array<std::uint32_t, limb_count>;

void multiply_by_5(Limbs& limbs) {
  std::uint64_t carry = 0;
  for (std::uint32_t& limb : limbs) {
    carry += std::uint64_t{limb} * 5;
    limb = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
}

void divide_by_5(Limbs& limbs) {
  std::uint64_t rest = 0;
  for (std::size_t i = limb_count; i-- > 0;) {
    rest = (rest << 32) | limbs[i];
    limbs[i] = static_cast<std::uint32_t>(rest / 5);
    rest %= 5;
  }
}

int bit_length(const Limbs& limbs) {
  std::size_t top = limb_count;
  while (limbs[top - 1] == 0) --top;
  return static_cast<int>(top) * 32 - std::countl_zero(limbs[top - 1]);
}

bool bit_at(const Limbs& limbs, int i) { return i >= 0 && ((limbs[static_cast<std::size_t>(i) / 32] >> (i % 32)) & 1) != 0; }

/// The 128 leading bits, rounded up when anything is cut off; `inexact` when something was cut off before.
Uint128 leading_bits(const Limbs& limbs, bool inexact) {
  const int length = bit_length(limbs);
  Uint128 leading = 0;
  for (int i = 1; i <= 128; ++i) leading = (leading << 1) | (bit_at(limbs, length - i) ? 1U : 0U);
  bool rounds_up = inexact;
  for (int i = 0; i < length - 128 && !rounds_up; ++i) rounds_up = bit_at(limbs, i);
  return leading + (rounds_up ? 1 : 0);
}

using PowerTable = std::array<Uint128, static_cast<std::size_t>(max_power - min_power + 1)>;

/// 10^k for every k a double needs, as 128 bits with the top bit set, rounded up. Floors of repeated division by 5 are exact.
PowerTable make_powers_of_10() {
  PowerTable table{};
  const auto entry = [&table](int k) -> Uint128& { return table[static_cast<std::size_t>(k - min_power)]; };
  Limbs power{1};
  for (int k = 0; k <= max_power; ++k, multiply_by_5(power)) entry(k) = leading_bits(power, false);
  Limbs inverse{};
  inverse[limb_count - 1] = 1U << 31;
  for (int k = -1; k >= min_power; --k) {
    divide_by_5(inverse);
    entry(k) = leading_bits(inverse, true);
  }
  return table;
}

Uint128 power_of_10(int k) {
  static const PowerTable table = make_powers_of_10();
  return table[static_cast<std::size_t>(k - min_power)];
}

/// The upper 64 of the 192 bits of power * factor, the lowest bit set when the cut bits were not zero (up to the rounding of power).
std::uint64_t multiply_round_to_odd(Uint128 power, std::uint64_t factor) {
  const auto low = static_cast<std::uint64_t>(power);
  const auto high = static_cast<std::uint64_t>(power >> 64);
  const Uint128 x = Uint128{low} * factor;
  const Uint128 y = Uint128{high} * factor + static_cast<std::uint64_t>(x >> 64);
  return static_cast<std::uint64_t>(y >> 64) | (static_cast<std::uint64_t>(y) > 1 ? 1U : 0U);
}

/// The shortest decimal inside the rounding interval, of those the nearest (Schubfach, figure 4). All quantities are four times
/// the decimal significand, so that two fraction bits remain.
Decimal shortest_decimal(const Binary& number) {
  const int q = number.exponent;
  const std::uint64_t c = number.significand;
  const int k = number.lower_is_closer ? floor_log10_three_quarters_pow2(q) : floor_log10_pow2(q);
  const int shift = q + floor_log2_pow10(-k) + 1;
  const Uint128 power = power_of_10(-k);
  const std::uint64_t open = c & 1;  // the ends of the interval belong to it when the significand is even
  const std::uint64_t lower = multiply_round_to_odd(power, (4 * c - (number.lower_is_closer ? 1 : 2)) << shift) + open;
  const std::uint64_t middle = multiply_round_to_odd(power, (4 * c) << shift);
  const std::uint64_t upper = multiply_round_to_odd(power, (4 * c + 2) << shift) - open;

  const std::uint64_t s = middle / 4;
  if (s >= 10) {
    const std::uint64_t tens = s / 10;
    const bool down_is_inside = lower <= 40 * tens;
    const bool up_is_inside = 40 * tens + 40 <= upper;
    if (down_is_inside != up_is_inside) return {tens + (up_is_inside ? 1 : 0), k + 1};
  }
  const bool down_is_inside = lower <= 4 * s;
  const bool up_is_inside = 4 * s + 4 <= upper;
  if (down_is_inside != up_is_inside) return {s + (up_is_inside ? 1 : 0), k};
  const std::uint64_t half = 4 * s + 2;
  const bool rounds_up = middle > half || (middle == half && (s & 1) != 0);
  return {s + (rounds_up ? 1 : 0), k};
}

/// Appends the digits in fixed notation from 1e-5 up to 1e17, else with an exponent, as "%.17g" chooses.
void append_decimal(std::string& text, Decimal number) {
  while (number.digits % 10 == 0) {
    number.digits /= 10;
    ++number.exponent;
  }
  std::array<char, 20> buffer{};
  std::size_t begin = buffer.size();
  for (std::uint64_t rest = number.digits; rest != 0; rest /= 10) buffer[--begin] = static_cast<char>('0' + rest % 10);
  const std::string_view digits(&buffer[begin], buffer.size() - begin);
  const int count = static_cast<int>(digits.size());
  const int point = count + number.exponent;  // the value is 0.digits * 10^point

  if (point > 17 || point < -4) {
    text += digits[0];
    if (count > 1) text.append(1, '.').append(digits.substr(1));
    text += point > 0 ? "e+" : "e-";
    text += std::to_string(point > 0 ? point - 1 : 1 - point);
  } else if (point <= 0) {
    text.append("0.").append(static_cast<std::size_t>(-point), '0').append(digits);
  } else if (point >= count) {
    text.append(digits).append(static_cast<std::size_t>(point - count), '0');
  } else {
    const auto whole = static_cast<std::size_t>(point);
    text.append(digits.substr(0, whole)).append(1, '.').append(digits.substr(whole));
  }
}

/// Appends sign, zero or a word; true when nothing is left to print.
bool append_special(std::string& text, bool is_negative, bool is_zero, bool is_finite, bool is_nan) {
  if (is_nan) {
    text += "nan";
    return true;
  }
  if (is_negative) text += '-';
  if (is_zero) text += '0';
  if (!is_finite) text += "inf";
  return is_zero || !is_finite;
}

/// Appends a float or double from its bits: `fraction_bits` stored bits of significand, exponent offset `exponent_bias`.
template <class Bits, int fraction_bits, int exponent_bias>
void append_bits(std::string& text, Bits bits) {
  constexpr Bits hidden_bit = Bits{1} << fraction_bits;
  constexpr Bits top_exponent = (std::numeric_limits<Bits>::max() >> 1) >> fraction_bits;
  const Bits fraction = bits & (hidden_bit - 1);
  const Bits exponent = (bits >> fraction_bits) & top_exponent;
  const bool is_negative = (bits >> (std::numeric_limits<Bits>::digits - 1)) != 0;
  const bool is_finite = exponent != top_exponent;
  if (append_special(text, is_negative, exponent == 0 && fraction == 0, is_finite, !is_finite && fraction != 0)) return;
  const std::uint64_t significand = exponent != 0 ? (fraction | hidden_bit) : fraction;
  const int power = static_cast<int>(exponent != 0 ? exponent : 1) - exponent_bias - fraction_bits;
  append_decimal(text, shortest_decimal({significand, power, fraction == 0 && exponent > 1}));
}

}  // namespace

ParsedNumber<double> parse_double(std::string_view text) {
  const bool has_sign = !text.empty() && (text[0] == '+' || text[0] == '-');
  const std::string_view digits = text.substr(has_sign ? 1 : 0);
  if (digits.empty()) return {0, NumberError::Malformed};
  if (!may_start_number(digits[0])) return {0, is_not_finite_word(digits) ? NumberError::NotFinite : NumberError::Malformed};
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const fast_float::from_chars_result result = fast_float::from_chars(digits.data(), end, value);
  if (result.ptr != end) return {0, is_not_finite_word(digits) ? NumberError::NotFinite : NumberError::Malformed};
  if (value > std::numeric_limits<double>::max()) return {0, NumberError::Overflow};
  if (result.ec == std::errc::invalid_argument) return {0, NumberError::Malformed};
  return {text[0] == '-' ? -value : value, NumberError::None};
}

ParsedNumber<std::int64_t> parse_integer(std::string_view text) {
  const bool has_plus = !text.empty() && text[0] == '+';
  const std::string_view digits = text.substr(has_plus ? 1 : 0);
  if (has_plus && !digits.empty() && digits[0] == '-') return {0, NumberError::Malformed};
  std::int64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const std::from_chars_result result = std::from_chars(digits.data(), end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end) return {0, NumberError::Malformed};
  if (result.ec == std::errc::result_out_of_range) return {0, NumberError::Overflow};
  return {value, NumberError::None};
}

void append_double(std::string& text, double value) { append_bits<std::uint64_t, 52, 1023>(text, cast_bits<std::uint64_t>(value)); }

std::string format_double(double value) {
  std::string text;
  append_double(text, value);
  return text;
}

std::string format_float(float value) {
  std::string text;
  append_bits<std::uint32_t, 23, 127>(text, cast_bits<std::uint32_t>(value));
  return text;
}

}  // namespace mortise
