// Reads which species a text names, and holds the tags of a plant.
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

/// The PlantKind of the first user-defined species (plants/species_folder.h). Every kind is 1 plus the number of its
/// species (plants/species.h). User-defined species have the numbers from 64 on, and no enumerators.
inline constexpr std::uint8_t kFirstUserKind = 65;

/// The names by which tags mean a user-defined species.
struct PlantWords {
  PlantKind kind{};                  ///< From kFirstUserKind on.
  std::vector<std::string> names{};  ///< In the form of lower_words(): "populus tremula".
};

/// The type of leaves.
enum class LeafType : std::uint8_t { kUnknown, kBroad, kNeedle, kMixed, kPalm };

/// The species and the size of one plant or wood by its tags.
struct PlantTags {
  PlantKind kind{};
  LeafType leaves{};
  double crown_m = 0;        ///< Crown diameter; 0: unknown.
  double girth_m = 0;        ///< Trunk circumference at breast height; 0: unknown.
  std::uint16_t year = 0;    ///< Year of planting; 0: unknown.
  std::uint8_t spawner = 0;  ///< 1 plus the index of the first row of UserPlants::spawners whose tags fit; 0: none.
  bool operator==(const PlantTags&) const = default;
};

/// The sides of a street with trees.
enum class TreeSides : std::uint8_t { kNone, kLeft, kRight, kBoth };

/// Returns the shipped species (never a user-defined one) that the first known word of a text names, in Latin, English,
/// German, French, Spanish or Catalan; kUnknown if no word is known. Case does not matter. A word matches a name of
/// species.inc as a whole, or, like German compounds ("Winterlinde"), if it ends with one of five letters or more.
/// O(words · names).
PlantKind kind_named(std::string_view text);

/// Returns the words of a text in lower case, separated by single spaces. Characters of ASCII that are no letters
/// separate words. Capitals of ASCII and Latin-1, in UTF-8, are converted; other characters stay.
std::string lower_words(std::string_view text);

/// Returns the user-defined species with the longest name that occurs in a text as whole words; the first of equally
/// long ones; kUnknown if none does. O(length of the text · names).
PlantKind user_kind_named(std::string_view text, std::span<const PlantWords> own);

}  // namespace citykiln::map
