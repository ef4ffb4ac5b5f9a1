#include "compiler/plants/species_mix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace citykiln::plants {
namespace {

constexpr double kHabitatLatitude_deg = 42.5;

Habitat place(double height_m, bool is_by_water = false) {
  return habitat_at(kHabitatLatitude_deg, {10, 20}, height_m, {0, 0, 1}, is_by_water);
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

TEST(SpeciesMix, ADegreeTowardsThePoleIsAHundredMetresUp) {
  const Vec3 up{0, 0, 1};
  EXPECT_EQ(habitat_at(52.5, {}, 40, up, false).belt_m, 1040);
  EXPECT_EQ(habitat_at(-52.5, {}, 40, up, false).belt_m, 1040);
  // pines and birches in Helsinki, palms in Niteroi
  EXPECT_GT(conifers(shares(species_mix_of(PlantCommunity::kAnyWood), habitat_at(60.2, {}, 10, up, false))), 0.8);
  EXPECT_GT(shares(species_mix_of(PlantCommunity::kAnyWood), habitat_at(-22.9, {}, 10, up, false))[Species::kPalm],
            0.3);
}

TEST(SpeciesMix, FirsLikeShadeAndPinesTheSun) {
  const auto on = [&](double north) {
    return shares(species_mix_of(PlantCommunity::kNeedleWood),
                  habitat_at(kHabitatLatitude_deg, {}, 1700, unit(Vec3{0, north, 1}), false));
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
