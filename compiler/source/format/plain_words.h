// Writes tags whose values are words in one spelling, so that tables of values need only one.
#pragma once

#include <osmium/memory/buffer.hpp>
#include <string>
#include <string_view>

namespace citykiln::source {

/// Returns the value with A to Z made small and each space between words made "_" ("Mixed Use" becomes "mixed_use"), if
/// the key is in word_keys.inc; else the value as it is.
std::string plain_word(std::string_view tag_key, std::string_view value);

/// Applies plain_word() to all tags of the elements in a buffer, in place: no value changes its length. O(bytes of
/// tags).
void make_words_plain(osmium::memory::Buffer& buffer);

}  // namespace citykiln::source
