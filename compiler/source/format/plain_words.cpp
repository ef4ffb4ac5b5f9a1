#include "compiler/source/format/plain_words.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <osmium/osm/object.hpp>
#include <osmium/osm/tag.hpp>

namespace citykiln::source {
namespace {

constexpr std::string_view kWordValueKeys[] = {
#define WORD_KEY(name) name,
#include "compiler/source/format/word_keys.inc"
#undef WORD_KEY
};
static_assert(std::ranges::is_sorted(kWordValueKeys));

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

bool ends_word(char c) { return c == ';' || c == ',' || c == ' '; }

// A space after a word and before another one. Spaces after a semicolon stay.
bool joins_words(std::string_view value, std::size_t i) {
  return value[i] == ' ' && i > 0 && i + 1 < value.size() && !ends_word(value[i - 1]) && !ends_word(value[i + 1]);
}

// The byte at a place of the plain value; both have the same length.
char plain_byte(std::string_view value, std::size_t i) {
  if (is_capital(value[i])) return static_cast<char>(value[i] - 'A' + 'a');
  return joins_words(value, i) ? '_' : value[i];
}

bool is_plain(std::string_view value) {
  return std::ranges::none_of(value, [](char c) { return is_capital(c) || c == ' '; });
}

bool has_word_values(std::string_view tag_key) { return std::ranges::binary_search(kWordValueKeys, tag_key); }

}  // namespace

std::string plain_word(std::string_view tag_key, std::string_view value) {
  std::string plain(value);
  if (!is_plain(value) && has_word_values(tag_key))
    for (std::size_t i = 0; i < plain.size(); ++i) plain[i] = plain_byte(value, i);
  return plain;
}

void make_words_plain(osmium::memory::Buffer& buffer) {
  for (osmium::OSMObject& object : buffer.select<osmium::OSMObject>())
    for (const osmium::Tag& tag : object.tags()) {
      const std::string plain = is_plain(tag.value()) ? "" : plain_word(tag.key(), tag.value());
      // libosmium has no function that changes a value; the buffer is ours and the length stays
      std::ranges::copy(plain, const_cast<char*>(tag.value()));
    }
}

}  // namespace citykiln::source
