#include "compiler/edits/split_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace citykiln::edits {
namespace {

std::uint32_t characters_in(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// Adds the bytes between two quotation marks, and returns the index of the closing one; npos if there is none.
std::size_t add_quoted(std::string_view line, std::size_t open, Word& word) {
  for (std::size_t i = open + 1; i < line.size(); ++i) {
    if (line[i] == '"') return i;
    const bool is_escaped = line[i] == '\\' && i + 1 < line.size() && (line[i + 1] == '"' || line[i + 1] == '\\');
    word.text += is_escaped ? line[++i] : line[i];
    word.plain += 'x';
  }
  return std::string_view::npos;
}

}  // namespace

Word part_of(const Word& word, std::size_t first, std::size_t count) {
  return {word.text.substr(first, count), word.plain.substr(first, count),
          word.column + characters_in(std::string_view(word.text).substr(0, first))};
}

std::vector<Word> parts_between(const Word& word, char separator) {
  std::vector<Word> parts;
  for (std::size_t first = 0;;) {
    const std::size_t end = word.plain.find(separator, first);
    parts.push_back(part_of(word, first, end == std::string::npos ? end : end - first));
    if (end == std::string::npos) return parts;
    first = end + 1;
  }
}

Result<std::vector<Word>> split_line(std::string_view line) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < line.size();) {
    if (is_blank(line[i])) {
      ++i;
      continue;
    }
    if (line[i] == '#') break;
    Word word;
    word.column = characters_in(line.substr(0, i)) + 1;
    for (; i < line.size() && !is_blank(line[i]); ++i) {
      if (line[i] != '"') {
        word.text += line[i], word.plain += line[i];
        continue;
      }
      const std::size_t open = i;
      i = add_quoted(line, open, word);
      if (i == std::string_view::npos)
        return Error{fmt::format("{}", characters_in(line.substr(0, open)) + 1),
                     "expected \" at the end of the text, found the end of the line"};
    }
    words.push_back(std::move(word));
  }
  return words;
}

}  // namespace citykiln::edits
