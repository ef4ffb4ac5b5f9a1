#include "compiler/plants/stock.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "compiler/materials/noise.h"

namespace citykiln::plants {
namespace {

struct Part {
  Mix mix;
  Species species;
  double share, from_m, to_m, shade;
  bool is_wet;
};

constexpr Part kParts[] = {
#define MIX(mix)
#define PART(mix, species, share, from_m, to_m, shade, wet) \
  {Mix::mix, Species::species, share, from_m, to_m, shade, wet != 0},
#include "compiler/plants/mixes.inc"
#undef PART
#undef MIX
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

std::span<const Part> parts_of(Mix mix) {
  const auto [first, last] = std::equal_range(std::begin(kParts), std::end(kParts), Part{mix, {}, 0, 0, 0, 0, false},
                                              [](const Part& a, const Part& b) { return a.mix < b.mix; });
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
Species nearest_species(Mix mix, double belt_m) {
  const auto parts = parts_of(mix);
  return std::ranges::min_element(parts, {}, [&](const Part& part) { return beyond_m(part, belt_m); })->species;
}

Stock by_leaves(map::LeafType leaves, Stock untold) {
  switch (leaves) {
    case map::LeafType::kBroad:
      return untold == stock_of(Mix::kAnyWood) ? stock_of(Mix::kBroadWood) : untold;
    case map::LeafType::kNeedle:
      return stock_of(Mix::kNeedleWood);
    case map::LeafType::kMixed:
      return stock_of(Mix::kMixedWood);
    case map::LeafType::kPalm:
      return stock_of(Species::kPalm);
    default:
      return untold;
  }
}

}  // namespace

bool is_stock(std::uint64_t number) {
  return number < static_cast<std::uint64_t>(Species::kCount) ||
         (number >= kFirstMix && number < kFirstMix + static_cast<std::uint64_t>(Mix::kCount));
}

std::string name_of(Stock stock) {
  constexpr std::string_view kMixes[] = {
#define MIX(mix) std::string_view(#mix).substr(1),
#define PART(mix, species, share, from_m, to_m, shade, wet)
#include "compiler/plants/mixes.inc"
#undef PART
#undef MIX
  };
  return std::string(is_species(stock) ? values_of(species_of(stock)).file
                                       : kMixes[static_cast<std::uint8_t>(stock) - kFirstMix]);
}

std::vector<Species> all_of(Stock stock) {
  if (is_species(stock)) return {species_of(stock)};
  std::vector<Species> all;
  for (const Part& part : parts_of(static_cast<Mix>(static_cast<std::uint8_t>(stock) - kFirstMix)))
    all.push_back(part.species);
  std::ranges::sort(all);
  return all;
}

Stock stock_for(const map::Growth& growth, Stock untold) {
  // in the order of map::PlantKind
  constexpr Species kSpecies[] = {Species::kApple,   Species::kBeech,  Species::kBirch,  Species::kBush,
                                  Species::kCypress, Species::kFir,    Species::kLime,   Species::kMaple,
                                  Species::kOak,     Species::kPalm,   Species::kPine,   Species::kPlane,
                                  Species::kPoplar,  Species::kSpruce, Species::kWillow, Species::kVine,
                                  Species::kGrass,   Species::kWheat,  Species::kMaize};
  static_assert(std::size(kSpecies) == static_cast<std::size_t>(map::PlantKind::kMaize));
  if (growth.kind == map::PlantKind::kUntold) return by_leaves(growth.leaves, untold);
  return stock_of(kSpecies[static_cast<std::size_t>(growth.kind) - 1]);
}

Habitat habitat_at(double latitude_deg, Vec2 at, double height_m, Vec3 normal, bool is_by_water) {
  const double to_pole = latitude_deg < 0 ? -1 : 1;
  return {height_m + (std::abs(latitude_deg) - kReferenceLatitude_deg) * kMetresADegree,
          std::clamp(to_pole * normal.y / kSteepest, -1.0, 1.0), is_by_water, at};
}

Species draw_species(Stock stock, const Habitat& habitat, std::uint64_t seed, double chance) {
  if (is_species(stock)) return species_of(stock);
  const Mix mix = static_cast<Mix>(static_cast<std::uint8_t>(stock) - kFirstMix);
  const auto parts = parts_of(mix);
  constexpr std::size_t kMostParts = 24;
  double sums[kMostParts], sum = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) sums[i] = sum += weight_of(parts[i], habitat, seed);
  if (sum <= 0) return nearest_species(mix, habitat.belt_m);
  std::size_t i = 0;
  while (i + 1 < parts.size() && sums[i] <= chance * sum) ++i;
  return parts[i].species;
}

double vigour(const Habitat& habitat) {
  const double up = (habitat.belt_m - kFullUpTo_m) / (kTreeLine_m - kFullUpTo_m);
  return 1 - (1 - kAtTreeLine) * std::clamp(up, 0.0, 1.0);
}

}  // namespace citykiln::plants
