// Splits the text of a rule file into tokens.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "grammars/language/token.h"

namespace citykiln::grammars {

/// Returns a position as "file:line:column".
std::string position_text(std::string_view file, TextPosition position);

/// Splits the text into names, numbers, strings and signs, without white space and comments (// and # to the end of the
/// line, /* … */). The last token is kEnd. O(n).
///
/// @param file_index  Copied into every position.
/// Errors: a character with which no token begins, an unterminated string or comment, a number that is not a finite
/// double.
Result<std::vector<Token>> tokens_of(std::string_view text, std::string_view file, std::uint32_t file_index);

}  // namespace citykiln::grammars
