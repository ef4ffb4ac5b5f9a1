#include "compiler/plants/species_mix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>

#include "compiler/contract/erase_repeated.h"
#include "compiler/materials/noise.h"
#include "compiler/plants/tree_line.h"

namespace citykiln::plants {
namespace {

struct Member {
  PlantCommunity community;
  Species species;
  double share, from_m, to_m, shade;
  bool is_wet;
};

constexpr Member kMembers[] = {
#define MEMBER(community, species, share, from_m, to_m, shade, wet) \
  {PlantCommunity::community, Species::species, share, from_m, to_m, shade, wet != 0},
#include "compiler/plants/plant_communities.inc"
};

// True for the communities of planted trees, by number.
constexpr bool kIsPlanted[] = {
#define WILD_COMMUNITY(community) false,
#define PLANTED_COMMUNITY(community) true,
#include "compiler/plants/plant_communities.inc"
};

struct ClimateRow {
  bool is_planted;
  Species species;
  double share;
  std::string_view classes;
};
constexpr ClimateRow kClimateRows[] = {
#define WILD(species, share, classes) {false, Species::species, share, classes},
#define PLANTED(species, share, classes) {true, Species::species, share, classes},
#include "compiler/plants/species_climates.inc"
};

// Shares by species and class.
using ClimateShares =
    std::array<std::array<double, climate::kClimateClasses>, static_cast<std::size_t>(Species::kCount)>;

ClimateShares climate_shares(bool is_planted) {
  ClimateShares shares{};
  for (const ClimateRow& row : kClimateRows)
    for (std::string_view rest = row.classes; row.is_planted == is_planted && !rest.empty();) {
      const std::string_view name = rest.substr(0, rest.find(' '));
      const climate::ClimateClass named = climate::climate_named(name);
      assert(named < climate::ClimateClass::kCount);
      shares[static_cast<std::size_t>(row.species)][static_cast<std::size_t>(named)] = row.share;
      rest.remove_prefix(std::min(name.size() + 1, rest.size()));
    }
  return shares;
}

// Tree lines (belt_m_at): no change up to the subtropics, then these metres a degree.
constexpr double kSubtropics_deg = 30, kReferenceLatitude_deg = 42.5, kToTropics_m = 100, kToPole_m = 75;

// Weights fall to 0 over this distance beyond a belt.
constexpr double kBeltEdge_m = 150;

// Effect of a slope's aspect; weight by water of members that are not wet; weight elsewhere of those that are.
constexpr double kShadeShare = 0.8, kDryByWater = 0.35, kWetElsewhere = 0.01;

// Width of groups of one species, and amplitude of its weight between them.
constexpr double kGroup_m = 70, kGrouping = 0.85;

// Slopes of 1 : 2 and more have full sun or shade: the horizontal part of their normal.
constexpr double kSteepest = 0.45;

// Trees have their full height up to the first belt, and this share of it at the tree line.
constexpr double kFullHeightUpTo_m = 1500, kTreeLineHeight = 0.35;

std::span<const Member> members_of(PlantCommunity community) {
  const auto [first, last] =
      std::equal_range(std::begin(kMembers), std::end(kMembers), Member{community, {}, 0, 0, 0, 0, false},
                       [](const Member& a, const Member& b) { return a.community < b.community; });
  return {first, last};
}

// Distance of a belt to a member's belt; 0 inside. Below the belt it is never too warm where winters are cold.
double beyond_m(const Member& member, double belt_m, bool has_cold_winters = false) {
  return std::max({has_cold_winters ? 0 : member.from_m - belt_m, belt_m - member.to_m, 0.0});
}

// 1 where the climate and the belt are the member's, as a mean over the classes of the place.
double fitness_of(const Member& member, const Habitat& habitat) {
  return habitat.climate.mean([&](climate::ClimateClass each) {
    const double beyond = beyond_m(member, habitat.belt_m, climate::has_cold_winters(each));
    return std::max(1 - beyond / kBeltEdge_m, 0.0) * climate_share(member.community, member.species, each);
  });
}

double weight_of(const Member& member, const Habitat& habitat, std::uint64_t seed) {
  const double fitness = fitness_of(member, habitat);
  if (fitness <= 0) return 0;
  const double slope = 1 + kShadeShare * member.shade * habitat.shade;
  const double water =
      member.is_wet ? (habitat.is_by_water ? 1 : kWetElsewhere) : (habitat.is_by_water ? kDryByWater : 1);
  const auto key = seed + static_cast<std::uint64_t>(member.species);
  return member.share * fitness * slope * water * (1 + kGrouping * materials::noise_at(habitat.at, kGroup_m, key));
}

bool grows_in(const Member& member, const climate::ClimateMix& mix) {
  return mix.mean([&](auto each) { return climate_share(member.community, member.species, each); }) > 0;
}

Species nearest_species(PlantCommunity community, const Habitat& habitat) {
  constexpr double kElsewhere_m = 1e6;
  return std::ranges::min_element(members_of(community), {},
                                  [&](const Member& member) {
                                    return beyond_m(member, habitat.belt_m) +
                                           (grows_in(member, habitat.climate) ? 0 : kElsewhere_m);
                                  })
      ->species;
}

// The leaf type of a forest is its land-cover class; plant tags hold leaf types of other plants (map/locate_areas).
SpeciesMix mix_by_leaf_type(map::LeafType leaves, SpeciesMix otherwise) {
  switch (leaves) {
    case map::LeafType::kNeedle:
      return species_mix_of(PlantCommunity::kNeedleWood);
    case map::LeafType::kMixed:
      return species_mix_of(PlantCommunity::kMixedWood);
    case map::LeafType::kPalm:
      return species_mix_of(Species::kPalm);
    default:
      return otherwise;
  }
}

PlantCommunity community_of(SpeciesMix species_mix) {
  assert(!is_single_species(species_mix) && !is_spawner(species_mix));
  return static_cast<PlantCommunity>(static_cast<std::uint8_t>(species_mix) - kFirstCommunity);
}

}  // namespace

bool is_species_mix(std::uint64_t number) {
  return number < static_cast<std::uint64_t>(Species::kCount) ||
         (number >= kFirstUserSpecies && number < kFirstCommunity) || (number >= kFirstSpawner && number < 256) ||
         (number >= kFirstCommunity && number < kFirstCommunity + static_cast<std::uint64_t>(PlantCommunity::kCount));
}

std::string name_of(SpeciesMix species_mix) {
  constexpr std::string_view kCommunities[] = {
#define COMMUNITY(community) std::string_view(#community).substr(1),
#include "compiler/plants/plant_communities.inc"
  };
  return std::string(is_single_species(species_mix)
                         ? values_of(single_species(species_mix)).file
                         : kCommunities[static_cast<std::size_t>(community_of(species_mix))]);
}

std::vector<Species> species_in(SpeciesMix species_mix) {
  if (is_single_species(species_mix)) return {single_species(species_mix)};
  std::vector<Species> all;
  for (const Member& member : members_of(community_of(species_mix))) all.push_back(member.species);
  sort_unique(all);
  return all;
}

SpeciesMix species_mix_for(const map::PlantTags& plant_tags, SpeciesMix otherwise) {
  if (plant_tags.kind == map::PlantKind::kUnknown && plant_tags.spawner > 0)
    return species_mix_of_spawner(plant_tags.spawner - 1u);
  if (plant_tags.kind == map::PlantKind::kUnknown) return mix_by_leaf_type(plant_tags.leaves, otherwise);
  // both enumerations list the rows of species.inc; kUnknown comes first
  return species_mix_of(static_cast<Species>(static_cast<std::uint8_t>(plant_tags.kind) - 1));
}

double climate_share(PlantCommunity community, Species species, climate::ClimateClass climate) {
  static const std::array<ClimateShares, 2> shares = {climate_shares(false), climate_shares(true)};
  assert(community < PlantCommunity::kCount && species < Species::kCount && climate < climate::ClimateClass::kCount);
  return shares[kIsPlanted[static_cast<std::size_t>(community)]][static_cast<std::size_t>(species)]
               [static_cast<std::size_t>(climate)];
}

double belt_m_at(double latitude_deg, double height_m) {
  const double up_deg = std::max(std::abs(latitude_deg), kSubtropics_deg) - kReferenceLatitude_deg;
  return height_m + up_deg * (up_deg < 0 ? kToTropics_m : kToPole_m);
}

Habitat habitat_at(const climate::ClimateMix& climate, double latitude_deg, Vec2 at, double height_m, Vec3 normal,
                   bool is_by_water) {
  const double to_pole = latitude_deg < 0 ? -1 : 1;
  return {climate, belt_m_at(latitude_deg, height_m), std::clamp(to_pole * normal.y / kSteepest, -1.0, 1.0),
          is_by_water, at};
}

Species draw_species(SpeciesMix species_mix, const Habitat& habitat, std::uint64_t seed, double uniform) {
  if (is_single_species(species_mix)) return single_species(species_mix);
  assert(0 <= uniform && uniform < 1);
  const PlantCommunity community = community_of(species_mix);
  const auto members = members_of(community);
  constexpr std::size_t kMostMembers = 24;
  assert(!members.empty() && members.size() <= kMostMembers);
  double sums[kMostMembers], sum = 0;
  for (std::size_t i = 0; i < members.size(); ++i) sums[i] = sum += weight_of(members[i], habitat, seed);
  if (sum <= 0) return nearest_species(community, habitat);
  std::size_t i = 0;
  while (i + 1 < members.size() && sums[i] <= uniform * sum) ++i;
  return members[i].species;
}

double height_factor(const Habitat& habitat) {
  const double up = (habitat.belt_m - kFullHeightUpTo_m) / (kTreeLine_m - kFullHeightUpTo_m);
  return 1 - (1 - kTreeLineHeight) * std::clamp(up, 0.0, 1.0);
}

}  // namespace citykiln::plants
