// From the words of a rule file to its tree.
#pragma once

#include <string_view>

#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Reads one file: version, import, attr, const, functions, rules, annotations (kept: @StartRule; skipped: others).
///
/// Errors name the first place where the text can go on in no way, and what was expected there. Nested deeper than
/// kNestingLimit is an error, so that no text overflows the stack. O(n). Method: recursive descent.
Result<SyntaxTree> parse(std::string_view text, std::string_view file, std::uint32_t file_index = 0);

/// Braces, brackets and calls in each other.
inline constexpr int kNestingLimit = 64;

}  // namespace citykiln::grammars
