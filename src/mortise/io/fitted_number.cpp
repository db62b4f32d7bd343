// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Numbers in the narrow fields of older formats.
#include "mortise/io/fitted_number.h"

#include "mortise/base/numbers.h"

namespace mortise {
namespace {

/// 0.DIGITS times ten to the power, the first digit not 0 but for zero itself.
struct Decimal {
  bool is_negative = false;
  std::string digits;
  int power = 0;
};

/// Takes a number apart that format_double() wrote.
Decimal decimal_of(double value) {
  Decimal decimal;
  const std::string text = format_double(value);
  bool is_behind_point = false;
  std::size_t i = 0;
  for (; i < text.size() && text[i] != 'e'; ++i) {
    if (text[i] == '-') decimal.is_negative = true;
    if (text[i] == '.') is_behind_point = true;
    if (text[i] < '0' || text[i] > '9') continue;
    if (!decimal.digits.empty() || text[i] != '0') decimal.digits += text[i];
    if (!is_behind_point && !decimal.digits.empty()) ++decimal.power;
    if (is_behind_point && decimal.digits.empty()) --decimal.power;
  }
  if (i < text.size()) decimal.power += static_cast<int>(parse_integer(std::string_view(text).substr(i + 1)).value);
  while (decimal.digits.size() > 1 && decimal.digits.back() == '0') decimal.digits.pop_back();
  if (decimal.digits.empty()) decimal = {decimal.is_negative, "0", 1};
  return decimal;
}

/// Rounds to one digit less; a 9 may carry.
Decimal with_one_digit_less(Decimal decimal) {
  const bool goes_up = decimal.digits.back() >= '5';
  decimal.digits.pop_back();
  while (goes_up) {
    if (decimal.digits.empty()) {
      decimal.digits = "1";
      ++decimal.power;
      break;
    }
    if (decimal.digits.back() != '9') {
      ++decimal.digits.back();
      break;
    }
    decimal.digits.pop_back();
  }
  while (decimal.digits.size() > 1 && decimal.digits.back() == '0') decimal.digits.pop_back();
  return decimal;
}

/// "123.45", "0.00123"; empty where that would be longer than any field.
std::string fixed_text(const Decimal& decimal) {
  constexpr int longest = 40;
  if (decimal.power > longest || decimal.power < -longest) return {};
  std::string text = decimal.is_negative ? "-" : "";
  if (decimal.power <= 0) return text.append("0.").append(static_cast<std::size_t>(-decimal.power), '0') + decimal.digits;
  const auto whole = static_cast<std::size_t>(decimal.power);
  if (decimal.digits.size() <= whole) return text.append(decimal.digits).append(whole - decimal.digits.size(), '0') + '.';
  return text.append(decimal.digits, 0, whole).append(".").append(decimal.digits, whole);
}

/// "1.2345e-07", "1.2345-7".
std::string exponent_text(const Decimal& decimal, ExponentStyle style) {
  std::string text = decimal.is_negative ? "-" : "";
  text.append(decimal.digits, 0, 1).append(".").append(decimal.digits, 1);
  const int exponent = decimal.power - 1;
  if (style == ExponentStyle::WithLetter) text += 'e';
  return text.append(exponent < 0 ? "-" : "+").append(std::to_string(exponent < 0 ? -exponent : exponent));
}

}  // namespace

std::string fitted_number(double value, std::size_t width, ExponentStyle style) {
  Decimal decimal = decimal_of(value);
  for (;;) {
    const std::string fixed = fixed_text(decimal), with_exponent = exponent_text(decimal, style);
    const bool takes_fixed = !fixed.empty() && fixed.size() <= with_exponent.size() + 2;
    if (takes_fixed && fixed.size() <= width) return fixed;
    if (with_exponent.size() <= width) return with_exponent;
    if (!fixed.empty() && fixed.size() <= width) return fixed;
    decimal = with_one_digit_less(decimal);
  }
}

}  // namespace mortise
