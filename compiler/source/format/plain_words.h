// Brings tag values that are keywords into one spelling, so that tables of values need only one: building=Mixed Use is
// read as building=mixed_use.
#pragma once

#include <osmium/memory/buffer.hpp>
#include <string>
#include <string_view>

namespace citykiln::source {

/// Returns the value of a tag in lower case (A to Z only), with "_" for each space between two words, if the key is in
/// word_keys.inc; else the value as it is. "Mixed Use" becomes "mixed_use". Spaces at the ends of the value and beside
/// ";", "," or another space stay. The result has the length of the value.
std::string plain_word(std::string_view tag_key, std::string_view value);

/// Replaces the values of all tags of the elements in a buffer by their plain_word(), in place. O(bytes of tags).
void make_words_plain(osmium::memory::Buffer& buffer);

}  // namespace citykiln::source
