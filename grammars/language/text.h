// What expressions do with texts. Indices are bytes from 0; those outside are brought inside.
#pragma once

#include <string>

namespace citykiln::grammars {

/// From index `from` to before `to`.
std::string part_of(const std::string& text, double from, double to);
/// Where `word` begins in `text`, not before index `from`; -1 if nowhere.
double place_in(const std::string& text, const std::string& word, double from);
/// How often `word` stands in `text`, without overlap; 0 for an empty word.
double times_in(const std::string& text, const std::string& word);
/// `text` with `other` wherever `word` stands; at most 4096 bytes.
std::string text_with(const std::string& text, const std::string& word, const std::string& other);

}  // namespace citykiln::grammars
