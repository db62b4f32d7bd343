// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Own trigonometry: close to libm, exact where it promises to be, the same bits on every machine.
#include "mortise/base/trig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "mortise/base/bits.h"
#include "support/catch.h"
#include "support/test_scale.h"

namespace mortise {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = 0x1.921fb54442d18p+1;

double ulps_between(double got, double expected) {
  if (got == expected) return 0;
  int exponent = 0;
  std::frexp(expected, &exponent);
  return std::fabs(got - expected) / std::max(std::ldexp(1.0, exponent - 53), std::numeric_limits<double>::denorm_min());
}

/// Uniform in (-size, size).
double random_within(std::mt19937_64& random, double size) { return (static_cast<double>(random() >> 11) * 0x1p-52 - 1) * size; }

/// Sizes from 2^low to 2^high, either sign.
double random_of_any_size(std::mt19937_64& random, int low, int high) {
  const int exponent = low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low));
  return std::ldexp(random_within(random, 2), exponent);
}

template <class Function, class Reference, class Argument>
double largest_error(Function function, Reference reference, Argument argument) {
  const unsigned seed = 20240611;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  double largest = 0;
  for (std::size_t i = 0; i < test::scaled_count(200'000, 1'000'000); ++i) {
    const double x = argument(random);
    largest = std::max(largest, ulps_between(function(x), reference(x)));
  }
  return largest;
}

double libm_sin(double x) { return std::sin(x); }
double libm_cos(double x) { return std::cos(x); }
double libm_exp(double x) { return std::exp(x); }
double libm_log(double x) { return std::log(x); }
double libm_acos(double x) { return std::acos(x); }

}  // namespace

TEST_CASE("sin and cos are within 2 ulp of libm for angles of every size", "[base][trig]") {
  const auto small = [](std::mt19937_64& random) { return random_within(random, 10); };
  const auto any = [](std::mt19937_64& random) { return random_of_any_size(random, -1000, 1023); };
  CHECK(largest_error(trig::sin, libm_sin, small) <= 2);
  CHECK(largest_error(trig::cos, libm_cos, small) <= 2);
  CHECK(largest_error(trig::sin, libm_sin, any) <= 2);
  CHECK(largest_error(trig::cos, libm_cos, any) <= 2);
}

TEST_CASE("exp, log and acos are within 2 ulp of libm", "[base][trig]") {
  CHECK(largest_error(trig::exp, libm_exp, [](std::mt19937_64& random) { return random_within(random, 740); }) <= 2);
  CHECK(largest_error(trig::exp, libm_exp, [](std::mt19937_64& random) { return random_within(random, 1); }) <= 2);
  CHECK(largest_error(trig::log, libm_log, [](std::mt19937_64& random) { return std::fabs(random_of_any_size(random, -1070, 1023)); }) <=
        2);
  CHECK(largest_error(trig::log, libm_log, [](std::mt19937_64& random) { return 1 + random_of_any_size(random, -50, -1) / 2; }) <= 2);
  CHECK(largest_error(trig::acos, libm_acos, [](std::mt19937_64& random) { return random_within(random, 1); }) <= 2);
  CHECK(largest_error(trig::acos, libm_acos, [](std::mt19937_64& random) { return 1 - std::fabs(random_of_any_size(random, -52, -1)); }) <=
        2);
}

TEST_CASE("atan2 is within 2 ulp of libm in every quadrant and at every ratio", "[base][trig]") {
  const unsigned seed = 7;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  double largest = 0;
  for (std::size_t i = 0; i < test::scaled_count(200'000, 1'000'000); ++i) {
    const int range = i % 2 == 0 ? 3 : 1000;
    const double y = random_of_any_size(random, -range, range);
    const double x = random_of_any_size(random, -range, range);
    largest = std::max(largest, ulps_between(trig::atan2(y, x), std::atan2(y, x)));
  }
  CHECK(largest <= 2);
}

TEST_CASE("atan2 treats zeros and infinities with their signs as C does", "[base][trig]") {
  constexpr std::array<double, 9> values{0.0, -0.0, 1, -1, infinity, -infinity, 0x1p-1074, -0x1p-1074, 0x1p1023};
  for (const double y : values) {
    for (const double x : values) {
      INFO("atan2(" << y << ", " << x << ")");
      CHECK(cast_bits<std::uint64_t>(trig::atan2(y, x)) == cast_bits<std::uint64_t>(std::atan2(y, x)));
    }
  }
  CHECK(std::isnan(trig::atan2(nan, 1)));
  CHECK(std::isnan(trig::atan2(1, nan)));
}

TEST_CASE("Multiples of 90 degrees are exact, of any size and sign, and never -0", "[base][trig]") {
  constexpr std::array<double, 4> sines{0, 1, 0, -1};
  for (int turn = -12; turn <= 12; ++turn) {
    const double degrees = 90.0 * turn;
    const auto quarter = static_cast<std::size_t>((turn % 4 + 4) % 4);
    INFO(degrees);
    CHECK(trig::sin_deg(degrees) == sines[quarter]);
    CHECK(trig::cos_deg(degrees) == sines[(quarter + 1) % 4]);
    CHECK_FALSE((trig::sin_deg(degrees) == 0 && std::signbit(trig::sin_deg(degrees))));
    CHECK_FALSE((trig::cos_deg(degrees) == 0 && std::signbit(trig::cos_deg(degrees))));
  }
  CHECK(trig::sin_deg(90 * 0x1p60) == 0);
  CHECK(trig::cos_deg(90 * 0x1p60) == 1);
}

TEST_CASE("Degrees give the expected values at 30, 45 and 60 and are symmetric", "[base][trig]") {
  CHECK(trig::sin_deg(30) == 0.5);
  CHECK(trig::cos_deg(60) == 0.5);
  CHECK(trig::sin_deg(-150) == -0.5);
  CHECK(trig::cos_deg(240) == -0.5);
  CHECK(trig::sin_deg(45) == std::sqrt(0.5));
  CHECK(trig::cos_deg(45) == std::sqrt(0.5));
  CHECK(trig::sin_deg(225) == -std::sqrt(0.5));
  for (int degrees = 0; degrees <= 90; ++degrees) {
    INFO(degrees);
    CHECK(trig::sin_deg(degrees) == trig::cos_deg(90 - degrees));
    CHECK(trig::sin_deg(degrees) == trig::sin_deg(180 - degrees));
    CHECK(trig::sin_deg(degrees) == -trig::sin_deg(-degrees));
    CHECK(trig::cos_deg(degrees) == -trig::cos_deg(180 - degrees));
  }
}

TEST_CASE("Degrees agree with radians, up to the rounding of radians", "[base][trig]") {
  for (int i = -1000; i <= 1000; ++i) {
    const double degrees = 0.375 * i;
    INFO(degrees);
    CHECK(std::fabs(trig::sin_deg(degrees) - std::sin(degrees * pi / 180)) < 2e-15);
    CHECK(std::fabs(trig::cos_deg(degrees) - std::cos(degrees * pi / 180)) < 2e-15);
  }
}

TEST_CASE("Arguments without an answer give NaN, and limits are those of the functions", "[base][trig]") {
  CHECK(std::isnan(trig::sin(infinity)));
  CHECK(std::isnan(trig::cos(nan)));
  CHECK(std::isnan(trig::sin_deg(-infinity)));
  CHECK(std::isnan(trig::cos_deg(nan)));
  CHECK(std::isnan(trig::acos(1.5)));
  CHECK(std::isnan(trig::log(-1)));
  CHECK(std::isnan(trig::exp(nan)));
  CHECK(trig::acos(1) == 0);
  CHECK(trig::acos(-1) == pi);
  CHECK(trig::log(1) == 0);
  CHECK(trig::log(0) == -infinity);
  CHECK(trig::log(infinity) == infinity);
  CHECK(trig::exp(0) == 1);
  CHECK(trig::exp(800) == infinity);
  CHECK(trig::exp(-infinity) == 0);
  CHECK(trig::to_degrees(pi) == 180);
}

TEST_CASE("The bits are the same on every machine", "[base][trig]") {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&hash](double value) { hash = (hash ^ cast_bits<std::uint64_t>(value)) * 0x100000001b3U; };
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const double x = random_of_any_size(random, -60, 200);
    const double y = random_of_any_size(random, -60, 200);
    for (const double value :
         {trig::sin(x), trig::cos(x), trig::atan2(y, x), trig::log(std::fabs(x)), trig::sin_deg(x), trig::cos_deg(y)}) {
      add(value);
    }
    add(trig::exp(random_within(random, 700)));
    add(trig::acos(random_within(random, 1)));
  }
  CHECK(hash == 0x4066485ed962ae18U);  // as built by GCC 12 for x86-64
}

}  // namespace mortise
