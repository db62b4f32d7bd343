// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The tags of an XML text.
#include "mortise/io/xml.h"

#include <algorithm>
#include <array>

namespace mortise {
namespace {

constexpr std::string_view blanks = " \t\r\n";

constexpr std::array<std::pair<std::string_view, char>, 5> references{
    {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};

/// Other references stay as they are.
std::string resolve(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto is_here = [&](const auto& reference) { return text.substr(0, reference.first.size()) == reference.first; };
    const auto known = std::find_if(references.begin(), references.end(), is_here);
    result += known == references.end() ? text.front() : known->second;
    text.remove_prefix(known == references.end() ? 1 : known->first.size());
  }
  return result;
}

void skip_blanks(std::string_view& text) { text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size())); }

std::string_view take_name(std::string_view& text) {
  const std::size_t size = std::min(text.find_first_of(" \t\r\n=/>"), text.size());
  const std::string_view name = text.substr(0, size);
  text.remove_prefix(size);
  return name;
}

}  // namespace

std::string_view XmlTag::value_of(std::string_view attribute) const {
  for (const auto& [key, value] : attributes) {
    if (key == attribute) return value;
  }
  return {};
}

void XmlReader::move_to(std::size_t offset) {
  const std::string_view passed = text_.substr(offset_, offset - offset_);
  place_.line += static_cast<std::uint32_t>(std::count(passed.begin(), passed.end(), '\n'));
  offset_ = offset;
}

void XmlReader::move_behind(std::string_view end) {
  const std::size_t at = text_.find(end, offset_);
  if (at == std::string_view::npos) fail("the file ends before '" + std::string(end) + "'");
  move_to(at + end.size());
}

/// Moves to the '<' of the next tag; false when there is none.
bool XmlReader::skip_to_tag() {
  for (;;) {
    const std::size_t at = text_.find('<', offset_);
    move_to(std::min(at, text_.size()));
    if (at == std::string_view::npos) return false;
    const std::string_view rest = text_.substr(offset_);
    if (rest.substr(0, 4) == "<!--") {
      move_behind("-->");
    } else if (rest.substr(0, 2) == "<?") {
      move_behind("?>");
    } else if (rest.substr(0, 2) == "<!") {
      move_behind(">");
    } else {
      return true;
    }
  }
}

bool XmlReader::next(XmlTag& tag) {
  tag = {};
  if (!skip_to_tag()) {
    if (!open_.empty()) fail("the file ends inside of '" + std::string(open_.back()) + "'");
    return false;
  }
  tag.place = place_;
  const std::size_t begin = offset_ + 1;
  move_behind(">");
  std::string_view inside = text_.substr(begin, offset_ - 1 - begin);
  tag.is_end = !inside.empty() && inside.front() == '/';
  if (tag.is_end) inside.remove_prefix(1);
  tag.is_empty = !tag.is_end && !inside.empty() && inside.back() == '/';
  if (tag.is_empty) inside.remove_suffix(1);
  tag.name = take_name(inside);
  if (tag.name.empty()) fail("a tag has no name");
  read_attributes(inside, tag);
  track(tag);
  return true;
}

void XmlReader::read_attributes(std::string_view inside, XmlTag& tag) const {
  for (;;) {
    skip_blanks(inside);
    if (inside.empty()) return;
    const std::string_view name = take_name(inside);
    skip_blanks(inside);
    if (name.empty() || inside.empty() || inside.front() != '=') fail("a tag has an attribute without a value");
    inside.remove_prefix(1);
    skip_blanks(inside);
    const char quote = inside.empty() ? ' ' : inside.front();
    const std::size_t end = quote == '"' || quote == '\'' ? inside.find(quote, 1) : std::string_view::npos;
    if (end == std::string_view::npos) fail("the value of an attribute is not in quotes");
    tag.attributes.emplace_back(name, resolve(inside.substr(1, end - 1)));
    inside.remove_prefix(end + 1);
  }
}

void XmlReader::track(const XmlTag& tag) {
  if (!tag.is_end) {
    if (!tag.is_empty) open_.push_back(tag.name);
    return;
  }
  if (open_.empty() || open_.back() != tag.name) fail("'" + std::string(tag.name.substr(0, 40)) + "' ends but did not begin");
  open_.pop_back();
}

std::string_view XmlReader::text_behind() const {
  const std::string_view rest = text_.substr(offset_);
  return rest.substr(0, rest.find('<'));
}

}  // namespace mortise
