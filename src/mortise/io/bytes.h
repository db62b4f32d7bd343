// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Numbers in binary files, in either byte order, on any machine.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "mortise/base/bits.h"

namespace mortise {

enum class ByteOrder : unsigned char { Little, Big };

inline constexpr ByteOrder native_byte_order = std::endian::native == std::endian::little ? ByteOrder::Little : ByteOrder::Big;

/// The number stored at `offset`; the bytes are there.
template <class T>
[[nodiscard]] T load_number(std::string_view bytes, std::size_t offset, ByteOrder order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data() + offset, sizeof(T));
  if (order != native_byte_order) std::reverse(raw.begin(), raw.end());
  return cast_bits<T>(raw);
}

/// Appends a number, lowest byte first.
template <class T>
void append_little_endian(std::string& bytes, T number) {
  auto raw = cast_bits<std::array<char, sizeof(T)>>(number);
  if (native_byte_order != ByteOrder::Little) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

}  // namespace mortise
