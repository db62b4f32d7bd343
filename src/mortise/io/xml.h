// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The tags of an XML text, one after the other: as much of XML as files of numbers use.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mortise/io/text.h"

namespace mortise {

/// A tag with its attributes; what it points into is the text.
struct XmlTag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string>> attributes;  ///< values with their references resolved
  bool is_end = false;                                               ///< "</name>"
  bool is_empty = false;                                             ///< "<name/>"
  TextPlace place;                                                   ///< where it begins

  /// The value of an attribute; empty when there is none.
  [[nodiscard]] std::string_view value_of(std::string_view attribute) const;
};

/// Hands out tags; declarations, comments and instructions are read over.
class XmlReader {
 public:
  XmlReader(std::string_view text, std::string_view stage) : text_(text), place_{stage, 1} {}

  /// Moves to the next tag; false behind the last one. A start tag has its end tag, or is empty.
  /// @throws Error{ParseFailed}
  bool next(XmlTag& tag);
  /// The text from behind the current tag to the next one, as it is written.
  [[nodiscard]] std::string_view text_behind() const;
  /// Where the current tag ends.
  [[nodiscard]] const TextPlace& place() const { return place_; }
  [[noreturn]] void fail(const std::string& message) const { fail_at_line(ErrorCode::ParseFailed, place_, message); }

 private:
  void move_to(std::size_t offset);
  /// Moves behind `end`, or fails.
  void move_behind(std::string_view end);
  bool skip_to_tag();
  void read_attributes(std::string_view inside, XmlTag& tag) const;
  void track(const XmlTag& tag);

  std::string_view text_;
  std::size_t offset_ = 0;
  TextPlace place_;
  std::vector<std::string_view> open_;  ///< names of the tags we are inside of
};

}  // namespace mortise
