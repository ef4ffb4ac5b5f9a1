#include "compiler/plants/species_mix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "compiler/climate/climate_at.h"
#include "compiler/plants/tree_line.h"

namespace citykiln::plants {
namespace {

constexpr double kHabitatLatitude_deg = 42.5;

using climate::ClimateClass;
using climate::ClimateMix;

// The Pyrenees.
const ClimateMix kAtHome(ClimateClass::kCfb);

Habitat place(double height_m, bool is_by_water = false) {
  return habitat_at(kAtHome, kHabitatLatitude_deg, {10, 20}, height_m, {0, 0, 1}, is_by_water);
}

// At 10 m above the sea.
Habitat place_in(ClimateClass climate, double latitude_deg) {
  return habitat_at(ClimateMix(climate), latitude_deg, {10, 20}, 10, {0, 0, 1}, false);
}

// Shares over many places, as species stand in groups.
std::map<Species, double> shares(SpeciesMix species_mix, Habitat habitat) {
  std::map<Species, double> counts;
  constexpr int kPlaces = 60, kDraws = 50;
  for (int i = 0; i < kPlaces; ++i)
    for (int k = 0; k < kDraws; ++k) {
      habitat.at = {i * 173.0, i * 97.0};
      counts[draw_species(species_mix, habitat, 5, (k + 0.5) / kDraws)] += 1.0 / (kPlaces * kDraws);
    }
  return counts;
}

double conifers(const std::map<Species, double>& shares) {
  double sum = 0;
  for (const auto& [species, share] : shares)
    if (values_of(species).leaf_form == LeafForm::kNeedle) sum += share;
  return sum;
}

TEST(SpeciesMix, EveryCommunityHasSpeciesAtEveryHeight) {
  for (int m = 0; m < static_cast<int>(PlantCommunity::kCount); ++m) {
    const SpeciesMix species_mix = species_mix_of(static_cast<PlantCommunity>(m));
    EXPECT_TRUE(is_species_mix(static_cast<std::uint64_t>(species_mix)));
    EXPECT_FALSE(species_in(species_mix).empty()) << name_of(species_mix);
    for (double height_m = -400; height_m < 6000; height_m += 50) {
      const Species species = draw_species(species_mix, place(height_m), 5, 0.99);
      EXPECT_TRUE(std::ranges::binary_search(species_in(species_mix), species))
          << name_of(species_mix) << " at " << height_m;
    }
  }
  EXPECT_FALSE(is_species_mix(static_cast<std::uint64_t>(Species::kCount)));
  EXPECT_FALSE(is_species_mix(kFirstCommunity + static_cast<std::uint64_t>(PlantCommunity::kCount)));
  EXPECT_FALSE(is_species_mix(300));
}

TEST(SpeciesMix, ConifersTakeOverWithHeight) {
  const SpeciesMix any = species_mix_of(PlantCommunity::kAnyWood);
  double before = 0;
  for (const double height_m : {700.0, 1200.0, 1500.0, 1800.0, 2200.0}) {
    const double share = conifers(shares(any, place(height_m)));
    EXPECT_GE(share, before - 0.02) << height_m;
    before = share;
  }
  EXPECT_LT(conifers(shares(any, place(700))), 0.15);
  EXPECT_GT(before, 0.95);
}

TEST(SpeciesMix, TreeLinesFallTowardsThePoles) {
  EXPECT_EQ(belt_m_at(42.5, 700), 700);
  EXPECT_EQ(belt_m_at(-42.5, 700), 700);
  EXPECT_EQ(belt_m_at(52.5, 40), 790);
  EXPECT_EQ(belt_m_at(0, 40), belt_m_at(30, 40));
  // Körner 2012: 3,600 m in the subtropics, 1,000 m at 60°, 300 m at 70°
  EXPECT_NEAR(kTreeLine_m - belt_m_at(30, 0), 3600, 10);
  EXPECT_NEAR(kTreeLine_m - belt_m_at(60, 0), 1000, 50);
  EXPECT_NEAR(kTreeLine_m - belt_m_at(70, 0), 300, 50);
}

// Places of ten climates, and species that grow there and that do not.
TEST(SpeciesMix, FollowsTheClimate) {
  const SpeciesMix any = species_mix_of(PlantCommunity::kAnyWood);
  EXPECT_GT(shares(any, place_in(ClimateClass::kAf, 1.3))[Species::kBanyan], 0.5);
  EXPECT_GT(shares(any, place_in(ClimateClass::kAw, -22.9))[Species::kPalm], 0.1);
  EXPECT_GT(shares(any, place_in(ClimateClass::kBWh, 30))[Species::kAcacia], 0.7);
  EXPECT_GT(shares(any, place_in(ClimateClass::kCsa, 41.9))[Species::kOlive], 0.1);
  EXPECT_GT(shares(any, place_in(ClimateClass::kCfb, 51.5))[Species::kOak], 0.2);
  EXPECT_GT(conifers(shares(any, place_in(ClimateClass::kDfb, 60.2))), 0.5);
  EXPECT_GT(shares(any, place_in(ClimateClass::kDfd, 62))[Species::kLarch], 0.4);
  for (const ClimateClass cold : {ClimateClass::kDfa, ClimateClass::kDfb, ClimateClass::kDfc, ClimateClass::kCfb})
    for (const PlantCommunity each : {PlantCommunity::kAnyWood, PlantCommunity::kParkTrees, PlantCommunity::kTownTrees,
                                      PlantCommunity::kGardenTrees, PlantCommunity::kGraveTrees}) {
      auto found = shares(species_mix_of(each), place_in(cold, 42.4));
      for (const Species warm : {Species::kPalm, Species::kBanyan, Species::kAcacia, Species::kOlive})
        EXPECT_EQ(found[warm], 0) << climate::name_of(cold) << ' ' << values_of(warm).file;
    }
}

// Each community that is not of needle-leaved trees has a species of each climate, even on ice, where woods are mapped.
TEST(SpeciesMix, HasASpeciesInEveryClimate) {
  for (std::size_t c = 0; c < climate::kClimateClasses; ++c)
    for (int m = 0; m < static_cast<int>(PlantCommunity::kCount); ++m) {
      const auto community = static_cast<PlantCommunity>(m);
      const auto climate = static_cast<ClimateClass>(c);
      double sum = 0;
      for (const Species species : species_in(species_mix_of(community)))
        sum += climate_share(community, species, climate);
      const bool may_be_empty = community == PlantCommunity::kNeedleWood || community == PlantCommunity::kMixedWood ||
                                community == PlantCommunity::kOrchardTrees || climate == ClimateClass::kEF;
      EXPECT_TRUE(may_be_empty || sum > 0) << climate::name_of(climate) << ' ' << name_of(species_mix_of(community));
      for (const double latitude_deg : {0.0, 35.0, -35.0, 80.0}) {
        const Species drawn = draw_species(species_mix_of(community), place_in(climate, latitude_deg), 5, 0.5);
        EXPECT_TRUE(std::ranges::binary_search(species_in(species_mix_of(community)), drawn));
      }
    }
}

// From oaks to larches: each step of the mix changes few trees.
TEST(SpeciesMix, ChangesGraduallyBetweenClimates) {
  const SpeciesMix park = species_mix_of(PlantCommunity::kParkTrees);
  std::map<Species, double> before;
  for (int tenths = 0; tenths <= 20; ++tenths) {
    Habitat habitat = place_in(ClimateClass::kCfb, 50);
    habitat.climate = {};
    habitat.climate.add(ClimateClass::kCfb, 1 - tenths / 20.0);
    habitat.climate.add(ClimateClass::kBWh, tenths / 20.0);
    const auto now = shares(park, habitat);
    if (tenths > 0)
      for (int s = 0; s < static_cast<int>(Species::kCount); ++s) {
        const auto species = static_cast<Species>(s);
        const auto share = [&](const auto& of) { return of.contains(species) ? of.at(species) : 0; };
        EXPECT_NEAR(share(now), share(before), 0.12) << values_of(species).file;
      }
    before = now;
  }
}

// Places a degree apart on the whole Earth: woods, parks, gardens and streets have a tree that grows in the climate.
TEST(SpeciesMix, HasASpeciesThatGrowsThereAtEveryPlace) {
  for (double lat_deg = -59.7; lat_deg < 84; ++lat_deg)
    for (double lon_deg = -179.7; lon_deg < 180; ++lon_deg) {
      const ClimateMix mix = climate::climate_mix_at(lon_deg, lat_deg);
      for (const PlantCommunity community : {PlantCommunity::kAnyWood, PlantCommunity::kParkTrees,
                                             PlantCommunity::kGardenTrees, PlantCommunity::kTownTrees}) {
        const Habitat habitat = habitat_at(mix, lat_deg, {}, 10, {0, 0, 1}, false);
        const Species drawn = draw_species(species_mix_of(community), habitat, 5, 0.4);
        const double share = mix.mean([&](auto each) { return climate_share(community, drawn, each); });
        ASSERT_GT(share, 0) << lon_deg << ' ' << lat_deg << ' ' << values_of(drawn).file;
      }
    }
}

TEST(SpeciesMix, HasMountainTreesInValleysOnlyWhereWintersAreCold) {
  const SpeciesMix needles = species_mix_of(PlantCommunity::kNeedleWood);
  EXPECT_EQ(shares(needles, place_in(ClimateClass::kCfb, 42.5))[Species::kSpruce], 0);
  EXPECT_GT(shares(needles, place_in(ClimateClass::kDfb, 42.5))[Species::kSpruce], 0.2);
}

TEST(SpeciesMix, FirsLikeShadeAndPinesTheSun) {
  const auto on = [&](double north) {
    return shares(species_mix_of(PlantCommunity::kNeedleWood),
                  habitat_at(kAtHome, kHabitatLatitude_deg, {}, 1700, unit(Vec3{0, north, 1}), false));
  };
  EXPECT_GT(on(0.5)[Species::kFir], 2 * on(-0.5)[Species::kFir]);
  EXPECT_GT(on(-0.5)[Species::kPine], 1.5 * on(0.5)[Species::kPine]);
}

TEST(SpeciesMix, WillowsStandByWater) {
  const SpeciesMix broad = species_mix_of(PlantCommunity::kBroadWood);
  const auto wet = shares(broad, place(900, true));
  EXPECT_GT(wet.at(Species::kWillow) + wet.at(Species::kPoplar), 0.4);
  auto dry = shares(broad, place(900));
  EXPECT_LT(dry[Species::kWillow] + dry[Species::kPoplar], 0.02);
}

TEST(SpeciesMix, TreesGetLowTowardsTheTreeLine) {
  EXPECT_EQ(height_factor(place(800)), 1);
  EXPECT_LT(height_factor(place(2300)), 0.5);
  EXPECT_GT(height_factor(place(4000)), 0.2);
}

TEST(SpeciesMix, HasTheNamesOfItsTable) {
  EXPECT_EQ(name_of(species_mix_of(Species::kOak)), "oak");
  EXPECT_EQ(name_of(species_mix_of(PlantCommunity::kAnyWood)), "AnyWood");
  EXPECT_EQ(name_of(species_mix_of(PlantCommunity::kTownTrees)), "TownTrees");
}

TEST(SpeciesMixFor, PrefersTheKindToTheLeafType) {
  using map::LeafType;
  const SpeciesMix any = species_mix_of(PlantCommunity::kAnyWood);
  EXPECT_EQ(species_mix_for({map::PlantKind::kMaize}, any), species_mix_of(Species::kMaize));
  EXPECT_EQ(species_mix_for({map::PlantKind::kApple}, any), species_mix_of(Species::kApple));
  EXPECT_EQ(species_mix_for({map::PlantKind::kWillow, LeafType::kNeedle}, any), species_mix_of(Species::kWillow));
  EXPECT_EQ(species_mix_for({{}, LeafType::kNeedle}, any), species_mix_of(PlantCommunity::kNeedleWood));
  EXPECT_EQ(species_mix_for({{}, LeafType::kBroad}, species_mix_of(PlantCommunity::kTownTrees)),
            species_mix_of(PlantCommunity::kTownTrees));
  EXPECT_EQ(species_mix_for({}, any), any);
}

}  // namespace
}  // namespace citykiln::plants
