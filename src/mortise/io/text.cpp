// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lines, tokens and numbers of text formats.
#include "mortise/io/text.h"

#include <algorithm>
#include <limits>

#include "mortise/base/numbers.h"

namespace mortise {
namespace {

constexpr std::string_view blanks = " \t\v\f";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t quoted_length = 40;

/// A word from a file as it may stand in a message: short, printable.
std::string quote(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, quoted_length)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > quoted_length ? "...'" : "'");
}

}  // namespace

void fail_at_line(ErrorCode code, const TextPlace& place, const std::string& message) {
  throw Error(code, place.stage, "line " + std::to_string(place.line) + ": " + message).with_ids(IdKind::Line, {place.line});
}

void fail_at_byte(ErrorCode code, std::string_view stage, std::size_t offset, const std::string& message) {
  const auto byte = static_cast<std::uint32_t>(std::min<std::uint64_t>(offset, std::numeric_limits<std::uint32_t>::max()));
  throw Error(code, stage, "byte " + std::to_string(offset) + ": " + message).with_ids(IdKind::Byte, {byte});
}

LineReader::LineReader(std::string_view text, std::string_view stage, std::uint32_t lines_before)
    : text_(text), place_{stage, lines_before} {
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) offset_ = byte_order_mark.size();
}

bool LineReader::next() {
  if (offset_ >= text_.size()) return false;
  std::size_t end = offset_;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
  line_ = text_.substr(offset_, end - offset_);
  const bool is_crlf = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
  offset_ = std::min(text_.size(), end + (is_crlf ? 2 : 1));
  ++place_.line;
  return true;
}

bool LineReader::next_content() {
  while (next()) {
    line_ = cut_comment(line_);
    if (!trim(line_).empty()) return true;
  }
  return false;
}

std::string_view WordReader::next() {
  for (;;) {
    const std::string_view word = take_word(rest_);
    if (!word.empty()) return word;
    if (!next_line()) return {};
  }
}

bool WordReader::next_line() {
  rest_ = {};
  if (!lines_.next()) return false;
  rest_ = comments_ == Comments::Keep ? lines_.line() : cut_comment(lines_.line());
  return true;
}

std::string_view WordReader::rest_of_line() {
  const std::string_view rest = trim(rest_);
  rest_ = {};
  return rest;
}

void WordReader::skip_paragraph() {
  rest_ = {};
  while (lines_.next() && !trim(lines_.line()).empty()) continue;
}

void WordReader::expect(std::string_view keyword) {
  const std::string_view word = next();
  if (!equals_ignoring_case(word, keyword)) fail("'" + std::string(keyword) + "' is expected" + (word.empty() ? " but the file ends" : ""));
}

std::string_view take_word(std::string_view& rest) {
  const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

std::string_view trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string_view cut_comment(std::string_view text) { return text.substr(0, text.find('#')); }

bool equals_ignoring_case(std::string_view text, std::string_view lower) {
  const auto equal = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; };
  return text.size() == lower.size() && std::equal(text.begin(), text.end(), lower.begin(), equal);
}

std::string one_line_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const bool is_space = c == ' ' || static_cast<unsigned char>(c) < 0x20 || c == '\x7F';
    if (!is_space) result += c;
    if (is_space && !result.empty() && result.back() != ' ') result += ' ';
  }
  while (!result.empty() && (result.back() == ' ' || result.back() == '\\')) result.pop_back();
  return result;
}

double value_of_word(std::string_view word) {
  const ParsedNumber<double> number = parse_double(word);
  return number.error == NumberError::None ? number.value : std::numeric_limits<double>::quiet_NaN();
}

double read_coordinate(std::string_view word, const TextPlace& place) {
  const ParsedNumber<double> number = parse_double(word);
  switch (number.error) {
    case NumberError::None:
      break;
    case NumberError::Malformed:
      fail_at_line(ErrorCode::ParseFailed, place, word.empty() ? "a coordinate is missing" : quote(word) + " is not a number");
    case NumberError::NotFinite:
      fail_at_line(ErrorCode::NotFinite, place, "the coordinate " + quote(word) + " is not finite");
    case NumberError::Overflow:
      fail_at_line(ErrorCode::OutOfRange, place, "the coordinate " + quote(word) + " does not fit a double");
  }
  return number.value;
}

std::int64_t read_integer(std::string_view word, const TextPlace& place, std::string_view what) {
  const ParsedNumber<std::int64_t> number = parse_integer(word);
  if (word.empty()) fail_at_line(ErrorCode::ParseFailed, place, std::string(what) + " is missing");
  if (number.error != NumberError::None) {
    fail_at_line(ErrorCode::ParseFailed, place, quote(word) + " is not an integer where " + std::string(what) + " is expected");
  }
  return number.value;
}

std::uint32_t read_count(std::string_view word, const TextPlace& place, std::string_view what) {
  const std::int64_t count = read_integer(word, place, what);
  if (count < 0 || count >= std::numeric_limits<std::uint32_t>::max()) {
    fail_at_line(ErrorCode::ParseFailed, place, std::string(what) + " " + quote(word) + " is out of range");
  }
  return static_cast<std::uint32_t>(count);
}

std::int32_t read_tag(std::string_view word, const TextPlace& place, std::string_view what, std::int32_t least) {
  const std::int64_t tag = read_integer(word, place, what);
  if (tag < least || tag > std::numeric_limits<std::int32_t>::max()) {
    fail_at_line(ErrorCode::ParseFailed, place, std::string(what) + " " + quote(word) + " is out of range");
  }
  return static_cast<std::int32_t>(tag);
}

std::uint32_t read_vertex_index(std::string_view word, const TextPlace& place, std::uint32_t first, std::size_t count) {
  const std::int64_t index = read_integer(word, place, "a vertex index");
  if (index < first || static_cast<std::uint64_t>(index - first) >= count) {
    fail_at_line(ErrorCode::BadIndex, place,
                 "the element names vertex " + std::to_string(index) + " of " + std::to_string(count) + " (the first is " +
                     std::to_string(first) + ")");
  }
  return static_cast<std::uint32_t>(index - first);
}

void append_point(std::string& text, const Vec3d& point) {
  append_double(text, point.x);
  text += ' ';
  append_double(text, point.y);
  text += ' ';
  append_double(text, point.z);
}

std::size_t believable_count(std::uint64_t count, std::size_t bytes_left, std::size_t least_bytes_per_item) {
  return static_cast<std::size_t>(std::min<std::uint64_t>(count, bytes_left / least_bytes_per_item + 1));
}

}  // namespace mortise
