#include "compiler/map/plants/plant_kind.h"

#include <algorithm>
#include <string>

namespace citykiln::map {
namespace {

struct Taxa {
  PlantKind kind;
  std::string_view names;  // separated by spaces
};

constexpr Taxa kTaxa[] = {
#define TAXA(name, words) {PlantKind::name, words},
#include "lsystems/species/species.inc"
};

// Minimum length of a word's ending that names a plant: "esche" ends "kirsche" except for a letter.
constexpr std::size_t kLeastEnd = 5;

// Takes the next word, up to a space, off the text.
std::string_view take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

// The text in lower case, with a space for each character that is not a letter. Converts capitals of ASCII and Latin-1.
std::string lowered(std::string_view text) {
  std::string lower;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool is_capital = byte >= 'A' && byte <= 'Z', is_letter = is_capital || (byte >= 'a' && byte <= 'z');
    const bool is_latin = i > 0 && static_cast<unsigned char>(text[i - 1]) == 0xc3 && byte >= 0x80 && byte < 0x9f;
    if (is_capital || is_latin)
      lower += static_cast<char>(byte + 0x20);
    else
      lower += is_letter || byte >= 0x80 ? static_cast<char>(byte) : ' ';
  }
  return lower;
}

// The kind of the longest name that the word ends with, of at least `least` bytes.
PlantKind kind_of_ending(std::string_view word, std::size_t least) {
  PlantKind kind = PlantKind::kUnknown;
  for (const Taxa& taxa : kTaxa)
    for (std::string_view names = taxa.names; !names.empty();)
      if (const std::string_view name = take_word(names); name.size() >= least && word.ends_with(name))
        kind = taxa.kind, least = name.size() + 1;
  return kind;
}

PlantKind kind_of_word(std::string_view word) {
  const PlantKind whole = kind_of_ending(word, word.size());
  return whole == PlantKind::kUnknown && word.size() > kLeastEnd ? kind_of_ending(word, kLeastEnd) : whole;
}

}  // namespace

PlantKind kind_named(std::string_view text) {
  const std::string lower = lowered(text);
  for (std::string_view rest = lower; !rest.empty();)
    if (const std::string_view word = take_word(rest); !word.empty())
      if (const PlantKind kind = kind_of_word(word); kind != PlantKind::kUnknown) return kind;
  return PlantKind::kUnknown;
}

std::string lower_words(std::string_view text) {
  std::string words;
  const std::string lower = lowered(text);
  for (std::string_view rest = lower; !rest.empty();)
    if (const std::string_view word = take_word(rest); !word.empty())
      words += (words.empty() ? "" : " ") + std::string(word);
  return words;
}

PlantKind user_kind_named(std::string_view text, std::span<const PlantWords> own) {
  const std::string words = " " + lower_words(text) + " ";
  PlantKind kind = PlantKind::kUnknown;
  std::size_t longest = 0;
  for (const PlantWords& plant : own)
    for (const std::string& name : plant.names)
      if (name.size() > longest && words.find(" " + name + " ") != std::string::npos)
        kind = plant.kind, longest = name.size();
  return kind;
}

}  // namespace citykiln::map
