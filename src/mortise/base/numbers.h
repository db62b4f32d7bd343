// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Text to number and back: correctly rounded, free of locale, the same bits natively and in WebAssembly.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mortise {

/// Why a text is not a number that fits.
enum class NumberError : unsigned char {
  None,
  Malformed,  ///< not a number, or only its beginning is one
  NotFinite,  ///< a word for NaN or infinity, "1.#INF" included
  Overflow,   ///< a number too large for the type
};

/// A number read from text; `value` is meaningful only without an error.
template <class T>
struct ParsedNumber {
  T value = 0;
  NumberError error = NumberError::None;
};

/// The double nearest to a decimal number, ties to even; the whole text must be one number.
/// Reads "1", "-1.", "+.5", "1e5", "1E+5"; never hexadecimal. Too small for a subnormal: zero of its sign.
[[nodiscard]] ParsedNumber<double> parse_double(std::string_view text);

/// A decimal integer with an optional sign; the whole text must be one.
[[nodiscard]] ParsedNumber<std::int64_t> parse_integer(std::string_view text);

/// Appends the shortest decimal that parse_double() reads back as the same bits; of those the nearest to the value.
/// "0.1", "-0", "1e+22"; "nan", "inf", "-inf" for what is not finite (parse_double() refuses these).
void append_double(std::string& text, double value);

/// The text append_double() appends.
[[nodiscard]] std::string format_double(double value);

/// The shortest decimal whose nearest float has the same bits.
[[nodiscard]] std::string format_float(float value);

}  // namespace mortise
