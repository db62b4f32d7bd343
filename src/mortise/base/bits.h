// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The bits of a number as another type: what std::bit_cast does, which the C++ library of Emscripten 3.1 lacks.
#pragma once

#include <type_traits>

namespace mortise {

/// The value of type To that has the same bits.
template <class To, class From>
[[nodiscard]] constexpr To cast_bits(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

}  // namespace mortise
