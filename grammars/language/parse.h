// Parses the text of a rule file to its syntax tree.
#pragma once

#include <string_view>

#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Parses one file: version, import, attr, const, functions, rules and annotations. @StartRule is the only annotation
/// that has an effect.
///
/// Errors: the first position at which the text is not valid, with the token that was expected. Nesting deeper than
/// kNestingLimit is an error, which bounds the stack. O(n). Method: recursive descent.
Result<SyntaxTree> parse(std::string_view text, std::string_view file, std::uint32_t file_index = 0);

/// The greatest depth of nested braces, brackets and calls.
inline constexpr int kNestingLimit = 64;

}  // namespace citykiln::grammars
