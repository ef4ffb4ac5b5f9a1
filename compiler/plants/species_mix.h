// Species mixes: the recipe (planned data) of a tree or wood names one species, or a plant community from which each
// plant's species is drawn by habitat and chance.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/climate/climate_mix.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/plants/plant_kind.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

/// The communities of plant_communities.inc. Their order is part of the manifest's format: add at the end.
enum class PlantCommunity : std::uint8_t {
#define COMMUNITY(community) community,
#include "compiler/plants/plant_communities.inc"
  kCount
};

/// The number of a species, kFirstCommunity plus the number of a community, or kFirstSpawner plus the row of a spawner.
enum class SpeciesMix : std::uint8_t {};
inline constexpr std::uint8_t kFirstCommunity = 128;
/// The number of the first row of spawners.txt (species_table.h), which is a mix too.
inline constexpr std::uint8_t kFirstSpawner = 192;
static_assert(kFirstCommunity + static_cast<std::uint8_t>(PlantCommunity::kCount) <= kFirstSpawner);

constexpr SpeciesMix species_mix_of(Species species) { return SpeciesMix{static_cast<std::uint8_t>(species)}; }
constexpr SpeciesMix species_mix_of(PlantCommunity community) {
  return static_cast<SpeciesMix>(kFirstCommunity + static_cast<std::uint8_t>(community));
}
/// The mix of a row of spawners.txt.
/// @param row  Less than map::kMostSpawners.
constexpr SpeciesMix species_mix_of_spawner(std::size_t row) {
  return static_cast<SpeciesMix>(kFirstSpawner + static_cast<std::uint8_t>(row));
}
constexpr bool is_spawner(SpeciesMix species_mix) { return static_cast<std::uint8_t>(species_mix) >= kFirstSpawner; }
constexpr bool is_single_species(SpeciesMix species_mix) {
  return static_cast<std::uint8_t>(species_mix) < kFirstCommunity;
}
/// Returns the species of a mix of one.
/// @param species_mix  is_single_species() holds.
constexpr Species single_species(SpeciesMix species_mix) {
  assert(is_single_species(species_mix));
  return static_cast<Species>(species_mix);
}
/// True if a number read from a manifest may be a SpeciesMix. Whether the user-defined species or the row of
/// spawners.txt exists is not tested: the texts of the manifest decide that.
bool is_species_mix(std::uint64_t number);

/// Returns the community's enumerator without k, "AnyWood"; the file of a shipped species.
/// @param species_mix  No user-defined species or spawner.
std::string name_of(SpeciesMix species_mix);

/// Returns all species that may be drawn, sorted.
/// @param species_mix  No spawner.
std::vector<Species> species_in(SpeciesMix species_mix);

/// Returns the first of these that there is: the species that the tags name, the spawner that they fit, the community
/// of the tagged leaf type, `otherwise`.
SpeciesMix species_mix_for(const map::PlantTags& plant_tags, SpeciesMix otherwise);

/// Returns the share that multiplies a species' share in a community at places of a class (species_climates.inc); 0: it
/// does not grow there.
double climate_share(PlantCommunity community, Species species, climate::ClimateClass climate);

/// Returns the belt of an altitude: the altitude at 42.5° of latitude at which trees grow as they do here. Slopes have
/// belts within one class of climate. Tree lines have the belt kTreeLine_m (tree_line.h) at all latitudes: 3,600 m up
/// to 30°, 2,350 m at 42.5°, 1,000 m at 60°, 300 m at 70° (Körner, "Alpine Treelines", 2012, rounded).
double belt_m_at(double latitude_deg, double height_m);

/// The growing conditions at a position.
struct Habitat {
  climate::ClimateMix climate;
  double belt_m = 0;         ///< The result of belt_m_at().
  double shade = 0;          ///< From -1 on a steep slope towards the noon sun to 1 on one away from it.
  bool is_by_water = false;  ///< A lake or river is within a few metres.
  Vec2 at;                   ///< The position, plane metres: species stand in groups.
};

/// Returns the growing conditions at a position.
///
/// @param at        Plane metres.
/// @param height_m  Above sea level.
/// @param normal    The unit normal of the ground.
Habitat habitat_at(const climate::ClimateMix& climate, double latitude_deg, Vec2 at, double height_m, Vec3 normal,
                   bool is_by_water);

/// Draws the species of one plant. Members of a community are weighted by share, climate, belt, slope, water and
/// groups. If no member fits both climate and belt, the result is the member that fits the climate and has the nearest
/// belt. If none fits the climate, as woods may be mapped where they are not wild, it is the member with the nearest
/// belt among all.
///
/// @param species_mix  No spawner.
/// @param seed         The seed of the scene, which decides where groups of a species stand.
/// @param uniform      A uniform random number in [0, 1).
Species draw_species(SpeciesMix species_mix, const Habitat& habitat, std::uint64_t seed, double uniform);

/// Returns the height of trees as a share of their height in the valley. It falls towards the tree line.
double height_factor(const Habitat& habitat);

}  // namespace citykiln::plants
