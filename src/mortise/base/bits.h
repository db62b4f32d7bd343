// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Bits of numbers: a cast (std::bit_cast, which the C++ library of Emscripten 3.1 lacks) and a mix for keys.
#pragma once

#include <cstdint>
#include <type_traits>

namespace mortise {

/// The value of type To that has the same bits.
template <class To, class From>
[[nodiscard]] constexpr To cast_bits(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

/// 64 bits that depend on all bits of x; one to one (the finalizer of SplitMix64).
[[nodiscard]] constexpr std::uint64_t mixed_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

}  // namespace mortise
