// Splits a line of a file of edits into words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::edits {

/// A word, without its quotation marks. Blanks and separators in quotation marks are part of its text.
struct Word {
  std::string text;
  /// The text with 'x' in place of each byte that was in quotation marks, so that separators are found in it alone.
  std::string plain;
  std::uint32_t column = 1;  ///< The place of its first character, counted from 1.
};

/// Returns a part of a word as a word. Bytes from `first` on, `count` of them.
Word part_of(const Word& word, std::size_t first, std::size_t count = std::string::npos);

/// Returns the parts of a word between separators that are not in quotation marks.
std::vector<Word> parts_between(const Word& word, char separator);

/// Returns the words of a line, which blanks and tabs separate. A word that begins with "#" ends the line. In quotation
/// marks \" and \\ stand for " and \. Error: quotation marks that are not closed; `where` is the column.
/// @param line  Valid UTF-8.
Result<std::vector<Word>> split_line(std::string_view line);

}  // namespace citykiln::edits
