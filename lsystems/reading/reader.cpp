#include "lsystems/reading/reader.h"

#include <fmt/core.h>

#include <algorithm>

namespace citykiln::lsystems {
namespace {

// The next word, sign or UTF-8 character, for errors.
std::string found_text(const Reader& reader) {
  if (reader.done()) return "the end of the line";
  std::size_t to = reader.at + 1;
  const auto at = [&](std::size_t i) { return reader.text[i]; };
  if (is_name_letter(at(reader.at))) {
    while (to < reader.end && to < reader.at + 40 && (is_name_letter(at(to)) || at(to) == '.')) ++to;
  } else {
    while (to < reader.end && (at(to) & 0xc0) == 0x80) ++to;
  }
  const std::string word(reader.text.substr(reader.at, to - reader.at));
  const auto byte = static_cast<unsigned char>(word[0]);
  return byte < ' ' || byte == 0x7f ? "a control character" : fmt::format("'{}'", word);
}

}  // namespace

std::string position_name(std::string_view file, TextPosition place) {
  return fmt::format("{}:{}:{}", file, place.line, place.column);
}

void Reader::skip_space() {
  while (at < end && (text[at] == ' ' || text[at] == '\t' || text[at] == '\r' || text[at] == '\n')) ++at;
}

bool Reader::accept(std::string_view word) {
  skip_space();
  if (!starts_with(word)) return false;
  at += word.size();
  return true;
}

bool Reader::expect(std::string_view word, std::string_view why) {
  if (accept(word)) return true;
  fail_expected(fmt::format("'{}' {}", word, why));
  return false;
}

TextPosition Reader::position_at(std::size_t byte) const {
  const auto line = std::upper_bound(line_starts.begin(), line_starts.end(), byte) - line_starts.begin();
  return {static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(byte - line_starts[line - 1] + 1)};
}

void Reader::fail_expected(std::string_view what) {
  if (failed) return;
  skip_space();
  fail(place(), fmt::format("expected {}, found {}", what, found_text(*this)));
}

void Reader::fail(TextPosition where, std::string message) {
  if (!failed) failed = Error{position_name(file, where), std::move(message)};
  at = end;
}

std::string take_name(Reader& reader) {
  reader.skip_space();
  const std::size_t from = reader.at;
  if (is_letter(reader.peek()) || reader.peek() == '_')
    while (is_name_letter(reader.peek())) ++reader.at;
  return std::string(reader.text.substr(from, reader.at - from));
}

bool at_arrow(const Reader& reader) { return reader.starts_with("->") || reader.starts_with("-->"); }

}  // namespace citykiln::lsystems
