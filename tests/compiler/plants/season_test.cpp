#include "compiler/plants/season.h"

#include <gtest/gtest.h>

#include "compiler/materials/texture.h"
#include "compiler/plants/prototypes/prototype_mesh.h"
#include "compiler/plants/prototypes/sprays.h"

namespace citykiln::plants {
namespace {

constexpr Month kJanuary{1}, kMay{5}, kOctober{10};

GrownPlant grown_in(Month month, Species species, std::uint8_t variant = 0) {
  return GrownPlantCache({}, month).grown({species, variant});
}

PrototypeMesh mesh_in(Month month, Species species, double share) {
  const double tallest_m = values_of(species).tallest_m;
  return prototype_mesh(grown_in(month, species), leaf_atlas(month), species, tallest_m, share * tallest_m);
}

double height_of(const PrototypeMesh& plant) {
  double high = 0;
  for (const auto& dressed : plant.meshes)
    for (const Vec3 p : dressed.mesh.positions) high = std::max(high, p.z);
  return high;
}

double shown(const impostor::Cutout& cutout) {
  return static_cast<double>(
      std::ranges::count_if(cutout.opacity, [](std::uint8_t o) { return o >= impostor::kAlphaCutoff; }));
}

// The month of the leaves in a month of the calendar.
Month month_in(unsigned calendar, double latitude_deg, climate::ClimateClass climate) {
  return month_for(local_month_of(std::chrono::month(calendar), latitude_deg), climate);
}

TEST(Season, IsHalfAYearOffInTheSouthAndMidsummerInTheTropics) {
  using climate::ClimateClass;
  EXPECT_EQ(month_in(10, 52, ClimateClass::kCfb), kOctober);
  EXPECT_EQ(month_in(4, -38, ClimateClass::kCfb), kOctober);
  EXPECT_EQ(month_in(12, -38, ClimateClass::kCfb), kMidsummer);
  EXPECT_EQ(month_in(1, 10, ClimateClass::kAw), kMidsummer);
  EXPECT_EQ(month_in(10, 10, ClimateClass::kCfb), kOctober);  // a mountain of the tropics
}

TEST(Season, ComesLaterAndEndsEarlierWhereWintersAreLong) {
  using climate::ClimateClass;
  const auto leaves = [](unsigned month, ClimateClass climate) {
    return season_state_of({Species::kBirch, 0}, month_in(month, 60, climate)).leaf_share;
  };
  EXPECT_GT(leaves(4, ClimateClass::kCfb), leaves(4, ClimateClass::kDfc));
  EXPECT_GT(leaves(10, ClimateClass::kCfb), leaves(10, ClimateClass::kDfc));
}

TEST(Season, ChangesNothingInMidsummer) {
  for (int s = 0; s < static_cast<int>(Species::kCount); ++s)
    for (std::uint8_t variant = 0; variant < kVariants; ++variant) {
      const SeasonState state = season_state_of({static_cast<Species>(s), variant}, kMidsummer);
      EXPECT_EQ(state.leaf_share, 1);
      EXPECT_EQ(state.height_share, 1);
      EXPECT_EQ(state.young, 0);
      EXPECT_EQ(state.turned, 0);
    }
}

TEST(Season, DoesNotChangeEvergreens) {
  for (const Species species : {Species::kFir, Species::kPine, Species::kSpruce, Species::kCypress, Species::kPalm}) {
    const Appearance summer = appearance_of({species, 0}), winter = appearance_of({species, 0}, kJanuary);
    EXPECT_EQ(winter.leaf, summer.leaf);
    EXPECT_EQ(winter.leaf_material, summer.leaf_material);
    EXPECT_EQ(winter.leaf_share, 1);
  }
}

// With leaf cards, clumps and hulls: no leaf material, and less coverage than in summer.
TEST(Season, HasBareTreesWithoutLeaves) {
  EXPECT_LT(shown(leaf_atlas(kJanuary).cutout), 0.7 * shown(leaf_atlas(kMidsummer).cutout));
  for (const Species species : {Species::kOak, Species::kBirch, Species::kMaple, Species::kWillow})
    for (const double share : {0.005, 0.1, 0.5}) {
      const PrototypeMesh winter = mesh_in(kJanuary, species, share), summer = mesh_in(kMidsummer, species, share);
      ASSERT_FALSE(winter.meshes.empty());
      for (const auto& dressed : winter.meshes)
        EXPECT_TRUE(dressed.material == materials::Material::kBark || is_bark(dressed.material));
      EXPECT_EQ(winter.shows_leaf_atlas, summer.shows_leaf_atlas);
      EXPECT_LE(winter.error_per_m, summer.error_per_m + 1e-12);
    }
}

TEST(Season, HasFruitOnlyWithAllLeaves) {
  const auto fruit = [](const GrownPlant& grown) {
    return std::ranges::count_if(grown.foliage.cards,
                                 [&](const Card& card) { return is_fruit(grown.foliage.sprays[card.spray]); });
  };
  EXPECT_GT(fruit(grown_in(kMidsummer, Species::kApple)), 0);
  EXPECT_EQ(fruit(grown_in(kJanuary, Species::kApple)), 0);
}

TEST(Season, TurnsSpeciesAndVariantsAtDifferentTimes) {
  const auto redness = [](Species species, std::uint8_t variant, Month month) {
    const materials::Tint leaf = appearance_of({species, variant}, month).leaf;
    return static_cast<double>(leaf[0]) / leaf[1];
  };
  for (const Species species : {Species::kMaple, Species::kOak, Species::kBirch, Species::kBeech})
    EXPECT_GT(redness(species, 1, kOctober), 1.5 * redness(species, 1, kMidsummer));
  EXPECT_GT(redness(Species::kMaple, 1, kOctober), 2 * redness(Species::kBirch, 1, kOctober));
  EXPECT_GT(redness(Species::kMaple, 1, kOctober), redness(Species::kMaple, 0, kOctober));
  EXPECT_GT(appearance_of({Species::kBeech, 0}, kMay).leaf[1], appearance_of({Species::kBeech, 0}).leaf[1]);
}

// A crop's height and error are those of its month; a bare field has no error.
TEST(Season, SowsAndReaps) {
  EXPECT_NEAR(height_of(mesh_in(kMidsummer, Species::kWheat, 0.01)), 1, 0.05);
  EXPECT_NEAR(height_of(mesh_in(kJanuary, Species::kWheat, 0.01)), 0.15, 0.02);
  EXPECT_NEAR(height_of(mesh_in(Month{9}, Species::kWheat, 0.01)), 0.2, 0.02);
  EXPECT_NE(appearance_of({Species::kWheat, 0}, kMay).bark, appearance_of({Species::kWheat, 0}).bark);
  EXPECT_LE(mesh_in(kJanuary, Species::kWheat, 0.01).error_per_m, 0.025);
  EXPECT_EQ(mesh_in(kJanuary, Species::kWheat, 0.2).error_per_m, 0.15);
  const PrototypeMesh none = mesh_in(kJanuary, Species::kMaize, 0.01);
  EXPECT_TRUE(none.meshes.empty());
  EXPECT_EQ(none.error_per_m, 0);
}

TEST(Sprays, ShowTwigsInPlaceOfMissingLeaves) {
  const auto share = [](double leaf_share) {
    const impostor::Picture picture = picture_of_spray("oak_leaf", materials::Material::kBroadLeaf, leaf_share);
    std::uint64_t sum = 0;
    for (const impostor::Texel& texel : picture.texels) sum += texel.shown;
    return static_cast<double>(sum) / (static_cast<double>(picture.texels.size()) * impostor::kSamplesPerTexel);
  };
  EXPECT_GT(share(0), 0.05);
  EXPECT_LT(share(0), 0.15);
  EXPECT_LT(share(0), share(0.35));
  EXPECT_LT(share(0.35), share(1));
}

}  // namespace
}  // namespace citykiln::plants
