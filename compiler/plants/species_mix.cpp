#include "compiler/plants/species_mix.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "compiler/materials/noise.h"

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

constexpr double kReferenceLatitude_deg = 42.5, kMetresADegree = 100;

// Weights fall to 0 over this distance beyond a belt.
constexpr double kBeltEdge_m = 150;

// Effect of a slope's aspect; weight by water of members that are not wet; weight elsewhere of those that are.
constexpr double kShadeShare = 0.8, kDryByWater = 0.35, kWetElsewhere = 0.01;

// Width of groups of one species, and amplitude of its weight between them.
constexpr double kGroup_m = 70, kGrouping = 0.85;

// Slopes of 1 : 2 and more have full sun or shade: the horizontal part of their normal.
constexpr double kSteepest = 0.45;

// Trees have their full height up to the first belt, and this share of it at the tree line.
constexpr double kFullHeightUpTo_m = 1500, kTreeLine_m = 2350, kTreeLineHeight = 0.35;

std::span<const Member> members_of(PlantCommunity community) {
  const auto [first, last] =
      std::equal_range(std::begin(kMembers), std::end(kMembers), Member{community, {}, 0, 0, 0, 0, false},
                       [](const Member& a, const Member& b) { return a.community < b.community; });
  return {first, last};
}

// Distance of a belt to a member's belt; 0 inside.
double beyond_m(const Member& member, double belt_m) {
  return std::max({member.from_m - belt_m, belt_m - member.to_m, 0.0});
}

double weight_of(const Member& member, const Habitat& habitat, std::uint64_t seed) {
  const double in_belt = 1 - beyond_m(member, habitat.belt_m) / kBeltEdge_m;
  if (in_belt <= 0) return 0;
  const double slope = 1 + kShadeShare * member.shade * habitat.shade;
  const double water =
      member.is_wet ? (habitat.is_by_water ? 1 : kWetElsewhere) : (habitat.is_by_water ? kDryByWater : 1);
  const auto key = seed + static_cast<std::uint64_t>(member.species);
  return member.share * in_belt * slope * water * (1 + kGrouping * materials::noise_at(habitat.at, kGroup_m, key));
}

Species nearest_species(PlantCommunity community, double belt_m) {
  const auto members = members_of(community);
  return std::ranges::min_element(members, {}, [&](const Member& member) { return beyond_m(member, belt_m); })->species;
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
  assert(!is_single_species(species_mix));
  return static_cast<PlantCommunity>(static_cast<std::uint8_t>(species_mix) - kFirstCommunity);
}

}  // namespace

bool is_species_mix(std::uint64_t number) {
  return number < static_cast<std::uint64_t>(Species::kCount) ||
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
  std::ranges::sort(all);
  return all;
}

SpeciesMix species_mix_for(const map::PlantTags& plant_tags, SpeciesMix otherwise) {
  if (plant_tags.kind == map::PlantKind::kUnknown) return mix_by_leaf_type(plant_tags.leaves, otherwise);
  // both enumerations list the rows of species.inc; kUnknown comes first
  return species_mix_of(static_cast<Species>(static_cast<std::uint8_t>(plant_tags.kind) - 1));
}

Habitat habitat_at(double latitude_deg, Vec2 at, double height_m, Vec3 normal, bool is_by_water) {
  const double to_pole = latitude_deg < 0 ? -1 : 1;
  return {height_m + (std::abs(latitude_deg) - kReferenceLatitude_deg) * kMetresADegree,
          std::clamp(to_pole * normal.y / kSteepest, -1.0, 1.0), is_by_water, at};
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
  if (sum <= 0) return nearest_species(community, habitat.belt_m);
  std::size_t i = 0;
  while (i + 1 < members.size() && sums[i] <= uniform * sum) ++i;
  return members[i].species;
}

double height_factor(const Habitat& habitat) {
  const double up = (habitat.belt_m - kFullHeightUpTo_m) / (kTreeLine_m - kFullHeightUpTo_m);
  return 1 - (1 - kTreeLineHeight) * std::clamp(up, 0.0, 1.0);
}

}  // namespace citykiln::plants
