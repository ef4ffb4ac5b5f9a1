// Plant species (the rows of lsystems/species/species.inc) and prototypes (the distinct plants of each species).
#pragma once

#include <array>
#include <cassert>
#include <compare>
#include <cstdint>
#include <string_view>

namespace citykiln::plants {

/// Rows of species.inc.
enum class Species : std::uint8_t {
#define SPECIES(name, ...) name,
#include "lsystems/species/species.inc"
  kCount
};

/// User-defined species have numbers from here on (species_table.h), below SpeciesMix of communities.
inline constexpr std::uint8_t kFirstUserSpecies = 64;
inline constexpr std::size_t kMostUserSpecies = 64;
static_assert(static_cast<std::uint8_t>(Species::kCount) <= kFirstUserSpecies);

/// The form of leaves.
enum class LeafForm : std::uint8_t {
  kBroad,   ///< Flat leaves of broad-leaved trees and shrubs.
  kNeedle,  ///< Needles of conifers.
  kPalm,    ///< Fronds of palms.
  kBlade    ///< Blades of grass, reed and corn.
};

/// The largest width of a plant as a share of its height: of crown_share, and of user-defined plants
/// (user_species.md). A width is the mean of the extents along x and y.
inline constexpr double kWidestCrown = 1.5;
/// An upper bound of the distance in plan from a plant's foot to its leaves, as a share of its height: half of the
/// width, and a tenth of the height because crowns are not round. Exceptions: blades (0.3 to 1 m tall) reach up to 1.2
/// heights, and a user-defined plant that leans may reach farther, since only its width is limited.
inline constexpr double kCrownReach = kWidestCrown / 2 + 0.1;

/// Linear reflectance of red, green and blue in thousandths.
using Thousandths = std::array<int, 3>;

/// A row of species.inc, which describes the columns.
struct SpeciesValues {
  std::string_view file;
  LeafForm leaf_form{};
  double height_m = 0, tallest_m = 0, crown_share = 0;
  Thousandths leaf{}, bark{};
  std::string_view months;
  Thousandths young_leaf{}, turned_leaf{};
};

inline constexpr SpeciesValues kSpecies[] = {
#define RGB(red, green, blue) \
  { red, green, blue }
#define SPECIES(name, file, leaf_form, ...) {file, LeafForm::leaf_form, __VA_ARGS__},
#include "lsystems/species/species.inc"
#undef RGB
};

/// Returns the row of a shipped species; a SpeciesTable has the user-defined ones too.
constexpr const SpeciesValues& values_of(Species species) {
  assert(species < Species::kCount);
  return kSpecies[static_cast<std::size_t>(species)];
}

/// The number of variants: plants of one species that are grown differently.
inline constexpr int kVariants = 8;

/// One plant of a species. Trees that share a prototype are instances of one mesh.
struct Prototype {
  Species species{};
  std::uint8_t variant = 0;  ///< Less than kVariants.
  auto operator<=>(const Prototype&) const = default;
};

}  // namespace citykiln::plants
