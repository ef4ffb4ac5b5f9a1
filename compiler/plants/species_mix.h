// What plants are drawn from: one species, or a mix that altitude, slope and water decide (mixes.inc).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/contract/draw.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/plant_kind.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

/// Rows of mixes.inc. The order is part of the manifest's format: add at the end.
enum class PlantCommunity : std::uint8_t {
#define COMMUNITY(community) community,
#define MEMBER(community, species, share, from_m, to_m, shade, wet)
#include "compiler/plants/plant_communities.inc"
#undef MEMBER
#undef COMMUNITY
  kCount
};

/// A species' number, or kFirstCommunity more than a mix's.
enum class SpeciesMix : std::uint8_t {};
inline constexpr std::uint8_t kFirstCommunity = 128;

constexpr SpeciesMix species_mix_of(Species species) { return SpeciesMix{static_cast<std::uint8_t>(species)}; }
constexpr SpeciesMix species_mix_of(PlantCommunity community) {
  return static_cast<SpeciesMix>(kFirstCommunity + static_cast<std::uint8_t>(community));
}
constexpr bool is_single_species(SpeciesMix species_mix) {
  return static_cast<std::uint8_t>(species_mix) < kFirstCommunity;
}
constexpr Species single_species(SpeciesMix species_mix) { return static_cast<Species>(species_mix); }
/// Whether there is such a species or mix.
bool is_species_mix(std::uint64_t number);

/// "oak", "AnyWood".
std::string name_of(SpeciesMix species_mix);

/// All species that it may be drawn as, sorted.
std::vector<Species> species_in(SpeciesMix species_mix);

/// What tags tell: the species that looks most like the kind, else a mix by the leaves, else `untold`.
SpeciesMix species_mix_for(const map::PlantTags& plant_tags, SpeciesMix untold);

/// A place as plants feel it.
struct Habitat {
  double belt_m = 0;         ///< Altitude of the same climate at 42.5 degrees of latitude.
  double shade = 0;          ///< From -1 on a steep slope that looks at the noon sun to 1 on one that looks away.
  bool is_by_water = false;  ///< Within a few metres of a lake or river.
  Vec2 at;                   ///< Species stand in groups.
};

/// The habitat on ground of a height and a normal.
Habitat habitat_at(double latitude_deg, Vec2 at, double height_m, Vec3 normal, bool is_by_water);

/// The species of one plant: the stock's, or drawn from the mix. Where none of a mix can grow, the one whose belt is
/// nearest. Total.
Species draw_species(SpeciesMix species_mix, const Habitat& habitat, std::uint64_t seed, double chance);

/// How tall trees grow there, as a share of what they do in the valley: less towards the tree line.
double height_factor(const Habitat& habitat);

}  // namespace citykiln::plants
