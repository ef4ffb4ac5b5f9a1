#include "compiler/map/plant_kind.h"

#include <algorithm>
#include <string>

namespace citykiln::map {
namespace {

struct Taxon {
  PlantKind kind;
  std::string_view names;  // separated by spaces
};

constexpr Taxon kTaxa[] = {
#define TAXON(kind, names) {PlantKind::kind, names},
#include "compiler/map/taxa.inc"
#undef TAXON
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

// The text in lower case with a space for each other character. Of UTF-8, capitals of Latin-1 are converted.
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

template <typename Fits>
PlantKind first_kind(Fits fits) {
  for (const Taxon& taxon : kTaxa)
    for (std::string_view names = taxon.names; !names.empty();)
      if (fits(take_word(names))) return taxon.kind;
  return PlantKind::kUnknown;
}

PlantKind kind_of_word(std::string_view word) {
  const PlantKind whole = first_kind([&](std::string_view name) { return word == name; });
  if (whole != PlantKind::kUnknown || word.size() <= kLeastEnd) return whole;
  return first_kind([&](std::string_view name) { return name.size() >= kLeastEnd && word.ends_with(name); });
}

}  // namespace

PlantKind kind_named(std::string_view text) {
  const std::string lower = lowered(text);
  for (std::string_view rest = lower; !rest.empty();)
    if (const std::string_view word = take_word(rest); !word.empty())
      if (const PlantKind kind = kind_of_word(word); kind != PlantKind::kUnknown) return kind;
  return PlantKind::kUnknown;
}

}  // namespace citykiln::map
