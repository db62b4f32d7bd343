// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Reading and printing numbers, against the C library's exactly rounded conversions.
#include "mortise/base/numbers.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "mortise/base/bits.h"
#include "support/catch.h"

using namespace mortise;

namespace {

using Random = std::mt19937_64;

std::uint64_t bits_of(double value) { return cast_bits<std::uint64_t>(value); }

int pick(Random& random, int low, int high) { return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1)); }

/// A decimal of 1 to 20 digits with a point anywhere or nowhere and, half the time, an exponent up to `exponent_limit`.
std::string random_decimal(Random& random, int exponent_limit) {
  std::string text;
  if (random() % 2 == 0) text += random() % 4 == 0 ? "+" : "-";
  const int digits = pick(random, 1, 20);
  const int point = pick(random, -5, digits + 5);
  for (int i = 0; i < digits; ++i) {
    if (i == point) text += '.';
    text += static_cast<char>('0' + pick(random, 0, 9));
  }
  if (point == digits) text += '.';
  if (random() % 2 == 0) {
    text += random() % 2 == 0 ? 'e' : 'E';
    text += std::to_string(pick(random, -exponent_limit, exponent_limit));
  }
  return text;
}

double strtod_of(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/// How many digits from the first to the last that is not 0?
int significant_digits(const std::string& text) {
  int count = 0;
  int zeros = 0;
  for (const char c : text) {
    if (c == 'e') break;
    if (c < '0' || c > '9' || (c == '0' && count == 0)) continue;
    ++count;
    zeros = c == '0' ? zeros + 1 : 0;
  }
  return count - zeros;
}

std::string with_digits(double value, int digits) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.*e", digits - 1, value);
  return buffer;
}

}  // namespace

TEST_CASE("A decimal is read to the same bits as strtod reads it") {
  constexpr std::uint64_t seed = 20240601;
  CAPTURE(seed);
  Random random(seed);
  int compared = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::string text = random_decimal(random, i % 2 == 0 ? 30 : 345);
    const double expected = strtod_of(text);
    const ParsedNumber<double> number = parse_double(text);
    CAPTURE(text);
    if (std::isinf(expected)) {
      REQUIRE(number.error == NumberError::Overflow);
    } else {
      REQUIRE(number.error == NumberError::None);
      REQUIRE(bits_of(number.value) == bits_of(expected));
      ++compared;
    }
  }
  CHECK(compared > 90000);
}

TEST_CASE("Subnormal decimals and those that vanish are read to the same bits as strtod reads them") {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const std::string text = std::to_string(random() >> pick(random, 0, 40)) + "e-" + std::to_string(pick(random, 310, 345));
    CAPTURE(text);
    const ParsedNumber<double> number = parse_double(text);
    REQUIRE(number.error == NumberError::None);
    REQUIRE(bits_of(number.value) == bits_of(strtod_of(text)));
  }
}

TEST_CASE("A decimal halfway between two doubles goes to the even one, a hair beside it to the nearer one") {
  CHECK(parse_double("9007199254740993").value == 9007199254740992.0);
  CHECK(parse_double("9007199254740993." + std::string(900, '0') + "1").value == 9007199254740994.0);
  CHECK(parse_double("9007199254740992." + std::string(900, '9')).value == 9007199254740992.0);
  CHECK(parse_double("9007199254740995").value == 9007199254740996.0);
  CHECK(bits_of(parse_double("2.2250738585072011e-308").value) == 0x000fffffffffffffU);
  CHECK(bits_of(parse_double("2.4703282292062327e-324").value) == 0);
  CHECK(bits_of(parse_double("2.4703282292062328e-324").value) == 1);
  CHECK(parse_double("1.7976931348623158e308").value == std::numeric_limits<double>::max());
  CHECK(parse_double("1.7976931348623159e308").error == NumberError::Overflow);
}

TEST_CASE("The usual ways to write a number are read") {
  const std::pair<const char*, double> texts[] = {{"1", 1},     {"+1", 1},        {"-1.", -1},        {".5", 0.5},        {"+.5", 0.5},
                                                  {"1e5", 1e5}, {"1E+5", 1e5},    {"1.5e-3", 0.0015}, {"000012", 12},     {"1e0005", 1e5},
                                                  {"0", 0},     {"0.000e999", 0}, {"1e-999", 0},      {"-12.25", -12.25}, {"3.e1", 30}};
  for (const auto& [text, value] : texts) {
    CAPTURE(text);
    CHECK(parse_double(text).error == NumberError::None);
    CHECK(parse_double(text).value == value);
  }
  CHECK(bits_of(parse_double("-0").value) == bits_of(-0.0));
  CHECK(bits_of(parse_double("-1e-999").value) == bits_of(-0.0));
}

TEST_CASE("What is no number from end to end is refused") {
  for (const char* text : {"",     "+",     "-",   ".",   "e5",  ".e5",    "1e",   "1e+", "1 ",  " 1",    "1,5",   "1.2.3",
                           "0x10", "0x1p3", "+-1", "--1", "-+1", "3.1+e2", "1e5f", "1d5", "one", "1_000", "1e5.5", "\xD9\xA3"}) {
    CAPTURE(text);
    CHECK(parse_double(text).error == NumberError::Malformed);
  }
  CHECK(parse_double(std::string_view("1\0", 2)).error == NumberError::Malformed);
}

TEST_CASE("Words for what is not finite are told from malformed numbers") {
  for (const char* text :
       {"nan", "NaN", "-nan", "+NAN", "nan(0x1)", "inf", "-Inf", "+infinity", "INFINITY", "1.#INF", "-1.#IND", "1.#QNAN"}) {
    CAPTURE(text);
    CHECK(parse_double(text).error == NumberError::NotFinite);
  }
}

TEST_CASE("Numbers too large for a double are reported as such") {
  for (const char* text : {"1e309", "-1e400", "1e99999999999999999999", "17976931348623159e292"}) {
    CAPTURE(text);
    CHECK(parse_double(text).error == NumberError::Overflow);
  }
  CHECK(parse_double("1" + std::string(400, '0')).error == NumberError::Overflow);
}

TEST_CASE("Integers are read from end to end within 64 bits") {
  CHECK(parse_integer("-12").value == -12);
  CHECK(parse_integer("+7").value == 7);
  CHECK(parse_integer("9223372036854775807").value == std::numeric_limits<std::int64_t>::max());
  CHECK(parse_integer("9223372036854775808").error == NumberError::Overflow);
  for (const char* text : {"", "+", "-", "+-1", "1.0", "1e3", "0x1", "1 ", "12a"}) {
    CAPTURE(text);
    CHECK(parse_integer(text).error == NumberError::Malformed);
  }
}

TEST_CASE("Every double printed is read back to the same bits, by us and by strtod") {
  constexpr std::uint64_t seed = 11;
  CAPTURE(seed);
  Random random(seed);
  for (int i = 0; i < 200000; ++i) {
    std::uint64_t bits = random();
    if (i % 4 == 1) bits &= ~(std::uint64_t{0x7ff} << 52);                  // subnormal
    if (i % 4 == 2) bits &= (std::uint64_t{0xfff} << 52) | (random() & 3);  // powers of two and next to them
    if (i % 4 == 3) bits = bits_of(static_cast<double>(static_cast<float>(static_cast<double>(bits % 1000000) * 1e-4)));
    const auto value = cast_bits<double>(bits);
    if (!std::isfinite(value)) continue;
    const std::string text = format_double(value);
    CAPTURE(bits, text);
    REQUIRE(parse_double(text).error == NumberError::None);
    REQUIRE(bits_of(parse_double(text).value) == bits);
    REQUIRE(bits_of(strtod_of(text)) == bits);
  }
}

TEST_CASE("No shorter decimal than the printed one reads back the same, and none of its length is nearer") {
  Random random(12);
  for (int i = 0; i < 20000; ++i) {
    std::uint64_t bits = random() & ~(std::uint64_t{1} << 63);
    if (i % 3 == 0) bits &= std::uint64_t{0x7ff} << 52;
    const auto value = cast_bits<double>(bits);
    if (!std::isfinite(value) || value == 0) continue;
    const std::string text = format_double(value);
    const int digits = significant_digits(text);
    CAPTURE(bits, text);
    REQUIRE(digits <= 17);
    if (digits > 1) REQUIRE(strtod_of(with_digits(value, digits - 1)) != value);
    const std::string nearest = with_digits(value, digits);
    // A power of two has a nearer neighbour below: there the nearest decimal may lie outside the interval.
    if (strtod_of(nearest) == value) REQUIRE(with_digits(strtod_of(text), digits) == nearest);
  }
}

TEST_CASE("Doubles are printed as people write them") {
  const std::pair<double, const char*> texts[] = {{0.0, "0"},
                                                  {-0.0, "-0"},
                                                  {0.1, "0.1"},
                                                  {-12.5, "-12.5"},
                                                  {100, "100"},
                                                  {0.00001, "0.00001"},
                                                  {0.000001, "1e-6"},
                                                  {1e16, "10000000000000000"},
                                                  {1e17, "1e+17"},
                                                  {1.25e22, "1.25e+22"},
                                                  {5e-324, "5e-324"},
                                                  {1.7976931348623157e308, "1.7976931348623157e+308"},
                                                  {std::numeric_limits<double>::infinity(), "inf"},
                                                  {-std::numeric_limits<double>::infinity(), "-inf"},
                                                  {std::numeric_limits<double>::quiet_NaN(), "nan"}};
  for (const auto& [value, text] : texts) CHECK(format_double(value) == text);
}

TEST_CASE("Every float printed is read back to the same bits with at most nine digits") {
  for (std::uint64_t bits = 1; bits < 0x7f800000U; bits += 9973) {
    const auto value = cast_bits<float>(static_cast<std::uint32_t>(bits));
    const std::string text = format_float(value);
    CAPTURE(bits, text);
    REQUIRE(cast_bits<std::uint32_t>(std::strtof(text.c_str(), nullptr)) == bits);
    REQUIRE(significant_digits(text) <= 9);
  }
  CHECK(format_float(0.1F) == "0.1");
  CHECK(format_float(-16777216.0F) == "-16777216");
  CHECK(format_float(1e-45F) == "1e-45");
}
