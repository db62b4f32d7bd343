// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Lines, words and names of text formats.
#include "mortise/io/text.h"

#include <limits>

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const TextPlace line_seven{"test", 7};

}  // namespace

TEST_CASE("Lines end with LF, CRLF or CR and are counted from 1") {
  LineReader lines("a\nb\r\nc\rd\n\n\re", "test");
  std::string seen;
  while (lines.next()) seen += std::to_string(lines.place().line) + std::string(lines.line()) + ";";
  CHECK(seen == "1a;2b;3c;4d;5;6;7e;");
}

TEST_CASE("Lines of white space or comment are passed over when content is asked for") {
  LineReader lines("\xEF\xBB\xBF \t\n# a\nb # c\n", "test");
  REQUIRE(lines.next_content());
  CHECK(lines.line() == "b ");
  CHECK(lines.place().line == 3);
  CHECK_FALSE(lines.next_content());
}

TEST_CASE("Words are taken one after the other until none is left") {
  std::string_view rest = "  ab\tc ";
  CHECK(take_word(rest) == "ab");
  CHECK(take_word(rest) == "c");
  CHECK(take_word(rest).empty());
  CHECK(rest.empty());
}

TEST_CASE("A name is made to fit a line, and a name that fits stays as it is") {
  CHECK(one_line_name("deck #1 (\xC3\xA9t\xC3\xA9)") == "deck #1 (\xC3\xA9t\xC3\xA9)");
  CHECK(one_line_name("  a \t\n b\x7F\\") == "a b");
  CHECK(one_line_name("\n").empty());
}

TEST_CASE("Counts are whole, not negative and within 32 bits") {
  CHECK(read_count("4294967294", line_seven, "a count") == 4294967294U);
  for (const char* word : {"", "-1", "4294967295", "99999999999999999999", "1.0", "x"}) {
    CAPTURE(word);
    check_error(ErrorCode::ParseFailed, "test", IdKind::Line, 7, [&] { return read_count(word, line_seven, "a count"); });
  }
}

TEST_CASE("Messages show only the printable beginning of what a file holds") {
  const Error error = error_of([] { return read_coordinate("\x01\xFF" + std::string(100, 'x'), line_seven); });
  CHECK(error.message == "line 7: '\?\?" + std::string(38, 'x') + "...' is not a number");
}

TEST_CASE("Byte offsets beyond 32 bits are given as the largest number") {
  if (sizeof(std::size_t) == 4) return;
  const auto far = static_cast<std::size_t>(std::uint64_t{1} << 33U);
  check_error(ErrorCode::ParseFailed, "test", IdKind::Byte, std::numeric_limits<std::uint32_t>::max(),
              [&]() -> int { fail_at_byte(ErrorCode::ParseFailed, "test", far, "far"); });
}

TEST_CASE("No more memory is reserved for a promise than the bytes left can hold") {
  CHECK(believable_count(10, 1000, 6) == 10);
  CHECK(believable_count(4000000000U, 60, 6) == 11);
  CHECK(believable_count(5, 0, 6) == 1);
}

TEST_CASE("Words are handed out across lines, comments cut where asked") {
  const std::string text = "a b # c\n\n  d\r\ne f\n\ng";
  WordReader words(LineReader(text, "stage", 10), Comments::CutFromHash);
  CHECK(words.next() == "a");
  CHECK(words.rest_of_line() == "b");
  CHECK(words.next() == "d");
  CHECK(words.place().line == 13);
  words.skip_paragraph();
  CHECK(words.next() == "g");
  CHECK(words.next().empty());
  CHECK_FALSE(words.next_line());
  WordReader kept(LineReader(text, "stage"));
  kept.expect("a");
  CHECK(kept.rest_of_line() == "b # c");
  check_error(ErrorCode::ParseFailed, "stage", IdKind::Line, 3, [&] { return kept.expect("x"), 0; });
}

TEST_CASE("Tags fit 31 bits and vertices are among those there are") {
  const TextPlace place{"stage", 4};
  CHECK(read_tag("2147483647", place, "a tag", 1) == 2147483647);
  CHECK(read_vertex_index("3", place, 1, 3) == 2);
  for (const char* word : {"0", "2147483648", "x", ""}) {
    check_error(ErrorCode::ParseFailed, "stage", IdKind::Line, 4, [&] { return read_tag(word, place, "a tag", 1); });
  }
  for (const char* word : {"0", "4", "-1", "9999999999"}) {
    check_error(ErrorCode::BadIndex, "stage", IdKind::Line, 4, [&] { return read_vertex_index(word, place, 1, 3); });
  }
}
