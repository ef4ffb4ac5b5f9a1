// What grows somewhere, as far as tags tell.
#pragma once

#include <cstdint>
#include <string_view>

namespace citykiln::map {

/// The species that tags name: kUnknown, then one enumerator for each block of species.inc, in its order. Genera
/// without a species of their own map to the one that looks most similar.
enum class PlantKind : std::uint8_t {
  kUnknown,
#define SPECIES(name, ...) name,
#include "lsystems/species/species.inc"
};

enum class LeafType : std::uint8_t { kUnknown, kBroad, kNeedle, kMixed, kPalm };

struct PlantTags {
  PlantKind kind{};
  LeafType leaves{};
  double crown_m = 0;      ///< Across; 0: nobody says.
  double girth_m = 0;      ///< About the trunk at breast height; 0: nobody says.
  std::uint16_t year = 0;  ///< In which it was planted; 0: nobody says.
  bool operator==(const PlantTags&) const = default;
};

/// On which sides of a street trees stand.
enum class TreeSides : std::uint8_t { kNone, kLeft, kRight, kBoth };

/// The kind that the first known word of a text names, in Latin, English, German, French, Spanish or Catalan, in any
/// case; German compounds by their end ("Winterlinde"). kUnknown where it knows none. O(words · taxa).
PlantKind kind_named(std::string_view text);

}  // namespace citykiln::map
