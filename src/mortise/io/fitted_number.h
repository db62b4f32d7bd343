// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Numbers in the narrow fields of older formats.
#pragma once

#include <cstddef>
#include <string>

namespace mortise {

enum class ExponentStyle : unsigned char {
  WithLetter,  ///< "1.5e-07"
  SignOnly,    ///< "1.5-7": how Nastran saves room
};

/// The shortest decimal that reads back as the same bits when it has at most `width` characters, else the one with the most digits that
/// has, rounded to nearest, ties away from zero. Always with a decimal point. `width` is at least 16, the value is finite.
[[nodiscard]] std::string fitted_number(double value, std::size_t width, ExponentStyle style);

}  // namespace mortise
