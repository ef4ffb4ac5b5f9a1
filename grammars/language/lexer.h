// From the text of a rule file to its words.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "grammars/language/token.h"

namespace citykiln::grammars {

/// "file:line:column".
std::string position_text(std::string_view file, TextPosition place);

/// Cuts the text into names, numbers, strings and signs, and leaves out space and comments (// and # to the line's end,
/// /* … */). The last token is kEnd. O(n).
///
/// @param file_index  Goes into every place.
/// Errors: a character that begins no word, a string or comment without end, a number out of range.
Result<std::vector<Token>> tokens_of(std::string_view text, std::string_view file, std::uint32_t file_index);

}  // namespace citykiln::grammars
