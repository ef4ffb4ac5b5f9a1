// The string functions of expressions. Indices are bytes from 0; indices outside of the text are clamped.
#pragma once

#include <string>

namespace citykiln::grammars {

/// Returns the bytes from index `from` up to but not including index `to`.
std::string part_of(const std::string& text, double from, double to);
/// Returns the index of the first `word` in `text` at or after index `from`; -1 if there is none.
double index_of_word(const std::string& text, const std::string& word, double from);
/// Returns the number of occurrences of `word` in `text` without overlap; 0 for an empty word.
double count_of_word(const std::string& text, const std::string& word);
/// Returns `text` with every `word` replaced by `other`, cut to 4096 bytes.
std::string replaced(const std::string& text, const std::string& word, const std::string& other);

}  // namespace citykiln::grammars
