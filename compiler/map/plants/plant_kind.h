// Kinds of plants, and tags of a plant.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace citykiln::map {

/// The species of a plant: kUnknown, then one enumerator for each block of species.inc, in its order. A tagged genus
/// without a block is read as the species that looks most similar.
enum class PlantKind : std::uint8_t {
  kUnknown,
#define SPECIES(name, ...) name,
#include "lsystems/species/species.inc"
};

/// The first kind of species of one's own (plants/species_folder.h). Like all kinds, these are 1 plus the number of the
/// species, which is 64 and more (plants/species.h); they have no enumerators.
inline constexpr std::uint8_t kFirstOwnKind = 65;

/// The words of tags that name a species of one's own.
struct PlantWords {
  PlantKind kind{};
  std::vector<std::string> names{};  ///< In lower case; several words are separated by a space: "populus tremula".
};

/// The type of leaves.
enum class LeafType : std::uint8_t { kUnknown, kBroad, kNeedle, kMixed, kPalm };

/// Tags of one plant or wood.
struct PlantTags {
  PlantKind kind{};
  LeafType leaves{};
  double crown_m = 0;        ///< Crown diameter; 0: unknown.
  double girth_m = 0;        ///< Trunk circumference at breast height; 0: unknown.
  std::uint16_t year = 0;    ///< Year of planting; 0: unknown.
  std::uint8_t spawner = 0;  ///< 1 plus the index of the row of OwnPlants::spawners that fits; 0: none.
  bool operator==(const PlantTags&) const = default;
};

/// The sides of a street with trees.
enum class TreeSides : std::uint8_t { kNone, kLeft, kRight, kBoth };

/// Returns the kind of the first word of a text that names a plant in Latin, English, German, French, Spanish or
/// Catalan; case does not matter. German compounds match by their ending ("Winterlinde"). kUnknown if no word is known.
/// O(words · taxa).
PlantKind kind_named(std::string_view text);

/// Returns the words of a text in lower case, separated by single spaces. All that is no letter separates words.
std::string lower_words(std::string_view text);

/// Returns the kind of the longest name that is in a text as whole words; kUnknown if none is.
PlantKind own_kind_named(std::string_view text, std::span<const PlantWords> own);

}  // namespace citykiln::map
