#include "compiler/plants/species_mix.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "compiler/materials/noise.h"

namespace citykiln::plants {
namespace {

struct Part {
  PlantCommunity community;
  Species species;
  double share, from_m, to_m, shade;
  bool is_wet;
};

constexpr Part kParts[] = {
#define COMMUNITY(community)
#define MEMBER(community, species, share, from_m, to_m, shade, wet) \
  {PlantCommunity::community, Species::species, share, from_m, to_m, shade, wet != 0},
#include "compiler/plants/plant_communities.inc"
#undef MEMBER
#undef COMMUNITY
};

constexpr double kReferenceLatitude_deg = 42.5, kMetresADegree = 100;

// Belts end softly.
constexpr double kBeltEdge_m = 150;

// How much a slope's side matters, what is left by water of what is not, and away from it of what needs it.
constexpr double kShadeShare = 0.8, kDryByWater = 0.35, kWetElsewhere = 0.01;

// Groups of one species are about this wide; how much rarer it is between them.
constexpr double kGroup_m = 70, kGrouping = 0.85;

// A slope of 1 : 2 is as sunny, or shady, as slopes get.
constexpr double kSteepest = 0.45;

// Trees are as tall as in the valley up to the first, and at the second, the tree line, only so tall.
constexpr double kFullUpTo_m = 1500, kTreeLine_m = 2350, kAtTreeLine = 0.35;

std::span<const Part> parts_of(PlantCommunity community) {
  const auto [first, last] =
      std::equal_range(std::begin(kParts), std::end(kParts), Part{community, {}, 0, 0, 0, 0, false},
                       [](const Part& a, const Part& b) { return a.community < b.community; });
  return {first, last};
}

// How far a place lies outside of a part's belt.
double beyond_m(const Part& part, double belt_m) { return std::max({part.from_m - belt_m, belt_m - part.to_m, 0.0}); }

double weight_of(const Part& part, const Habitat& habitat, std::uint64_t seed) {
  const double in_belt = 1 - beyond_m(part, habitat.belt_m) / kBeltEdge_m;
  if (in_belt <= 0) return 0;
  const double slope = 1 + kShadeShare * part.shade * habitat.shade;
  const double water =
      part.is_wet ? (habitat.is_by_water ? 1 : kWetElsewhere) : (habitat.is_by_water ? kDryByWater : 1);
  const auto key = seed + static_cast<std::uint64_t>(part.species);
  return part.share * in_belt * slope * water * (1 + kGrouping * materials::noise_at(habitat.at, kGroup_m, key));
}

// Where no belt reaches.
Species nearest_species(PlantCommunity community, double belt_m) {
  const auto parts = parts_of(community);
  return std::ranges::min_element(parts, {}, [&](const Part& part) { return beyond_m(part, belt_m); })->species;
}

SpeciesMix by_leaves(map::LeafType leaves, SpeciesMix untold) {
  switch (leaves) {
    case map::LeafType::kBroad:
      return untold == species_mix_of(PlantCommunity::kAnyWood) ? species_mix_of(PlantCommunity::kBroadWood) : untold;
    case map::LeafType::kNeedle:
      return species_mix_of(PlantCommunity::kNeedleWood);
    case map::LeafType::kMixed:
      return species_mix_of(PlantCommunity::kMixedWood);
    case map::LeafType::kPalm:
      return species_mix_of(Species::kPalm);
    default:
      return untold;
  }
}

}  // namespace

bool is_species_mix(std::uint64_t number) {
  return number < static_cast<std::uint64_t>(Species::kCount) ||
         (number >= kFirstCommunity && number < kFirstCommunity + static_cast<std::uint64_t>(PlantCommunity::kCount));
}

std::string name_of(SpeciesMix species_mix) {
  constexpr std::string_view kMixes[] = {
#define COMMUNITY(community) std::string_view(#community).substr(1),
#define MEMBER(community, species, share, from_m, to_m, shade, wet)
#include "compiler/plants/plant_communities.inc"
#undef MEMBER
#undef COMMUNITY
  };
  return std::string(is_single_species(species_mix) ? values_of(single_species(species_mix)).file
                                                    : kMixes[static_cast<std::uint8_t>(species_mix) - kFirstCommunity]);
}

std::vector<Species> species_in(SpeciesMix species_mix) {
  if (is_single_species(species_mix)) return {single_species(species_mix)};
  std::vector<Species> all;
  for (const Part& part :
       parts_of(static_cast<PlantCommunity>(static_cast<std::uint8_t>(species_mix) - kFirstCommunity)))
    all.push_back(part.species);
  std::ranges::sort(all);
  return all;
}

SpeciesMix species_mix_for(const map::PlantTags& plant_tags, SpeciesMix untold) {
  // in the order of map::PlantKind
  constexpr Species kSpecies[] = {
      Species::kApple,  Species::kBeech,  Species::kBirch,  Species::kBush, Species::kCypress, Species::kFir,
      Species::kLime,   Species::kMaple,  Species::kOak,    Species::kPalm, Species::kPine,    Species::kPlane,
      Species::kPoplar, Species::kSpruce, Species::kWillow, Species::kVine, Species::kGrass,   Species::kWheat,
      Species::kMaize,  Species::kFern,   Species::kHonda};
  static_assert(std::size(kSpecies) == static_cast<std::size_t>(map::PlantKind::kHonda));
  if (plant_tags.kind == map::PlantKind::kUnknown) return by_leaves(plant_tags.leaves, untold);
  return species_mix_of(kSpecies[static_cast<std::size_t>(plant_tags.kind) - 1]);
}

Habitat habitat_at(double latitude_deg, Vec2 at, double height_m, Vec3 normal, bool is_by_water) {
  const double to_pole = latitude_deg < 0 ? -1 : 1;
  return {height_m + (std::abs(latitude_deg) - kReferenceLatitude_deg) * kMetresADegree,
          std::clamp(to_pole * normal.y / kSteepest, -1.0, 1.0), is_by_water, at};
}

Species draw_species(SpeciesMix species_mix, const Habitat& habitat, std::uint64_t seed, double chance) {
  if (is_single_species(species_mix)) return single_species(species_mix);
  const PlantCommunity community =
      static_cast<PlantCommunity>(static_cast<std::uint8_t>(species_mix) - kFirstCommunity);
  const auto parts = parts_of(community);
  constexpr std::size_t kMostParts = 24;
  double sums[kMostParts], sum = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) sums[i] = sum += weight_of(parts[i], habitat, seed);
  if (sum <= 0) return nearest_species(community, habitat.belt_m);
  std::size_t i = 0;
  while (i + 1 < parts.size() && sums[i] <= chance * sum) ++i;
  return parts[i].species;
}

double height_factor(const Habitat& habitat) {
  const double up = (habitat.belt_m - kFullUpTo_m) / (kTreeLine_m - kFullUpTo_m);
  return 1 - (1 - kAtTreeLine) * std::clamp(up, 0.0, 1.0);
}

}  // namespace citykiln::plants
