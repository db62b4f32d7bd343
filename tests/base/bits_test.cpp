// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Bits of numbers: casts, and the mix against the published values of SplitMix64.
#include "mortise/base/bits.h"

#include <algorithm>
#include <vector>

#include "support/catch.h"

using namespace mortise;

TEST_CASE("a cast keeps the bits") {
  CHECK(cast_bits<std::uint64_t>(1.0) == 0x3ff0000000000000U);
  CHECK(cast_bits<std::uint64_t>(-0.0) == 0x8000000000000000U);
  CHECK(cast_bits<double>(std::uint64_t{0x4000000000000000U}) == 2.0);
  CHECK(cast_bits<std::uint32_t>(1.0F) == 0x3f800000U);
}

TEST_CASE("the mix is the finalizer of SplitMix64") {
  // The generator of seed 0 adds 0x9e3779b97f4a7c15 before each value; these are its first three.
  CHECK(mixed_bits(0) == 0xe220a8397b1dcdafU);
  CHECK(mixed_bits(0x9e3779b97f4a7c15U) == 0x6e789e6aa1b965f4U);
  CHECK(mixed_bits(2 * 0x9e3779b97f4a7c15U) == 0x06c45d188009454fU);
}

TEST_CASE("every bit of a number changes many bits of its mix") {
  for (unsigned bit = 0; bit < 64; ++bit) {
    int least = 64;
    for (std::uint64_t x = 0; x < 64; ++x) {
      std::uint64_t difference = mixed_bits(x) ^ mixed_bits(x ^ (std::uint64_t{1} << bit));
      int count = 0;
      for (; difference != 0; difference &= difference - 1) ++count;
      least = std::min(least, count);
    }
    CHECK(least >= 10);
  }
}

TEST_CASE("different small numbers have different mixes") {
  std::vector<std::uint64_t> mixes;
  for (std::uint64_t x = 0; x < 100000; ++x) mixes.push_back(mixed_bits(x));
  std::sort(mixes.begin(), mixes.end());
  CHECK(std::adjacent_find(mixes.begin(), mixes.end()) == mixes.end());
}
