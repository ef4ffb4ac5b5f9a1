// The species that plants are of: a row of species.inc each, and a file of lsystems/species.
#pragma once

#include <compare>
#include <cstdint>
#include <string_view>

namespace citykiln::plants {

enum class Species : std::uint8_t {
#define SPECIES(name, file, leaves, height_m, tallest_m) name,
#include "compiler/plants/species.inc"
#undef SPECIES
  kCount
};

enum class LeafForm : std::uint8_t { kBroad, kNeedle, kPalm, kBlade };

struct SpeciesValues {
  std::string_view file;  ///< Without ".lsys".
  LeafForm leaves{};
  double height_m = 0;   ///< That the file grows it to.
  double tallest_m = 0;  ///< None is drawn taller.
};

const SpeciesValues& values_of(Species species);

/// How many plants of a species differ from each other.
inline constexpr int kVariants = 8;

/// A shape that many plants share.
struct Prototype {
  Species species{};
  std::uint8_t variant = 0;  ///< Below kVariants.
  auto operator<=>(const Prototype&) const = default;
};

}  // namespace citykiln::plants
