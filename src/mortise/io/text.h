// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lines, tokens and numbers of text formats, with errors that name the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mortise/base/error.h"
#include "mortise/geom/vec.h"

namespace mortise {

/// Where in a text the reader is, for errors.
struct TextPlace {
  std::string_view stage;  ///< "read_obj", ...
  std::uint32_t line = 0;  ///< from 1
};

/// Throws an error that names one line.
[[noreturn]] void fail_at_line(ErrorCode code, const TextPlace& place, const std::string& message);

/// Throws an error that names one byte offset; offsets beyond 32 bits are given as the largest number.
[[noreturn]] void fail_at_byte(ErrorCode code, std::string_view stage, std::size_t offset, const std::string& message);

/// Hands out the lines of a text without their ends: LF, CRLF or CR. A byte order mark in front is skipped.
class LineReader {
 public:
  /// @param lines_before  how many lines of the file come before the text
  LineReader(std::string_view text, std::string_view stage, std::uint32_t lines_before = 0);

  /// Moves to the next line; false after the last one.
  bool next();
  /// Moves to the next line that holds more than white space and a comment from '#' on; the comment is cut off.
  bool next_content();

  [[nodiscard]] std::string_view line() const { return line_; }
  /// The current line; after the last one, the last line.
  [[nodiscard]] const TextPlace& place() const { return place_; }
  /// Offset of the first byte behind the current line and its end.
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t bytes_left() const { return text_.size() - offset_; }

 private:
  std::string_view text_;
  std::string_view line_;
  std::size_t offset_ = 0;
  TextPlace place_;
};

enum class Comments : unsigned char { Keep, CutFromHash };

/// Hands out the words of a text across its lines.
class WordReader {
 public:
  explicit WordReader(const LineReader& lines, Comments comments = Comments::Keep) : lines_(lines), comments_(comments) {}

  /// The next word; empty at the end of the text.
  std::string_view next();
  /// What is left of the current line.
  std::string_view rest_of_line();
  /// Moves to the beginning of the next line; false after the last one.
  bool next_line();
  /// Moves behind the next empty line.
  void skip_paragraph();

  /// Reads over a word, in any case; `keyword` has no capitals.
  /// @throws Error{ParseFailed} when another word, or none, is there
  void expect(std::string_view keyword);
  [[noreturn]] void fail(const std::string& message) const { fail_at_line(ErrorCode::ParseFailed, place(), message); }
  [[nodiscard]] const TextPlace& place() const { return lines_.place(); }
  /// Bytes of the text behind the current line.
  [[nodiscard]] std::size_t bytes_left() const { return lines_.bytes_left(); }

 private:
  LineReader lines_;
  Comments comments_;
  std::string_view rest_;
};

/// Cuts the first word off `rest` and returns it; empty when there is none. Words are separated by spaces and tabs.
[[nodiscard]] std::string_view take_word(std::string_view& rest);

/// The text without white space at its ends.
[[nodiscard]] std::string_view trim(std::string_view text);

/// The text up to the first '#'.
[[nodiscard]] std::string_view cut_comment(std::string_view text);

/// Are the texts equal when 'A' to 'Z' count as small letters? `lower` holds none of them.
[[nodiscard]] bool equals_ignoring_case(std::string_view text, std::string_view lower);

/// A name that survives being written at the end of a line: control characters become spaces, runs of spaces one space,
/// a backslash at the end is dropped.
[[nodiscard]] std::string one_line_name(std::string_view name);

/// A coordinate read from one word.
/// @throws Error{ParseFailed} not a number or empty, {NotFinite} a word for NaN or infinity, {OutOfRange} beyond double; each with the line
[[nodiscard]] double read_coordinate(std::string_view word, const TextPlace& place);

/// The number a word says, NaN where it is no finite number: for data, which may lack values.
[[nodiscard]] double value_of_word(std::string_view word);

/// An integer read from one word. `what` names it in messages.
/// @throws Error{ParseFailed} with the line
[[nodiscard]] std::int64_t read_integer(std::string_view word, const TextPlace& place, std::string_view what);

/// A count that is at least 0 and fits 32 bits, read from one word.
/// @throws Error{ParseFailed} with the line
[[nodiscard]] std::uint32_t read_count(std::string_view word, const TextPlace& place, std::string_view what);

/// A number from `least` that fits 31 bits, read from one word: the tag of an entity or a group.
/// @throws Error{ParseFailed} with the line
[[nodiscard]] std::int32_t read_tag(std::string_view word, const TextPlace& place, std::string_view what, std::int32_t least);

/// The place from 0 of a vertex that a word names, where the first of `count` is called `first`.
/// @throws Error{ParseFailed, BadIndex} with the line
[[nodiscard]] std::uint32_t read_vertex_index(std::string_view word, const TextPlace& place, std::uint32_t first, std::size_t count);

/// Appends "x y z", each the shortest text that reads back as the same bits.
void append_point(std::string& text, const Vec3d& point);

/// How many items to reserve memory for, when a header promises `count` and `bytes_left` remain: no promise is believed blindly.
[[nodiscard]] std::size_t believable_count(std::uint64_t count, std::size_t bytes_left, std::size_t least_bytes_per_item);

}  // namespace mortise
