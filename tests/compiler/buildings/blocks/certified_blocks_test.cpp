#include "compiler/buildings/blocks/certified_blocks.h"

#include <gtest/gtest.h>

#include "compiler/buildings/styles/rulebook.h"
#include "tests/compiler/buildings/blocks/made_town.h"
#include "tests/compiler/buildings/real_buildings.h"
#include "tests/test_files.h"

namespace citykiln::buildings {
namespace {

CertifiedBlocks blocks_of(std::span<const Building> town, const Rulebook& rules, double tolerance_m,
                          std::span<const simplify::Corners> ground) {
  const auto shapes = shapes_of(town, rules, block_source_tolerance_m(tolerance_m));
  return certified_blocks({town, shapes, ground}, tolerance_m);
}

TEST(CertifiedBlocks, StateNoLessThanTheDistanceOfAnySampleBothWays) {
  for (const double tolerance_m : {18.75, 37.5, 75.0})
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const std::vector<Building> town = random_town(seed, 60);
      const std::vector<simplify::Corners> ground = ground_below();
      const CertifiedBlocks made = blocks_of(town, {}, tolerance_m, ground);
      EXPECT_LE(made.error_m, tolerance_m);

      std::vector<simplify::Corners> full;
      const auto shapes = shapes_of(town, {}, 0.01, false);
      for (const GeneratedBuilding& shape : shapes) add(full, shape);
      std::vector<simplify::Corners> level = surface_of(made, shapes);
      ASSERT_FALSE(level.empty());
      EXPECT_GE(made.error_m, simplify::sampled_distance_m(level, full, 12));
      level.insert(level.end(), ground.begin(), ground.end());
      EXPECT_GE(made.error_m, simplify::sampled_distance_m(full, level, 12));
    }
}

TEST(CertifiedBlocks, HaveEveryBuildingOnce) {
  const std::vector<Building> town = random_town(9, 80);
  const CertifiedBlocks made = blocks_of(town, {}, 25, ground_below());
  std::vector<std::uint32_t> all = made.kept;
  for (const Block& block : made.blocks) all.insert(all.end(), block.members.begin(), block.members.end());
  std::ranges::sort(all);
  ASSERT_EQ(all.size(), town.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], i);
  EXPECT_LT(made.blocks.size(), town.size());
}

// A closed slot between two towers would leave its walls farther from roof, ends and ground than the tolerance.
TEST(CertifiedBlocks, KeepDeepSlotsOpen) {
  const std::vector towers = {box_building(1, {0, 0}, 30, 120, 150), box_building(2, {36, 0}, 30, 120, 150)};
  const CertifiedBlocks made = blocks_of(towers, {}, 25, ground_below(0, 0));
  EXPECT_EQ(made.blocks.size() + made.kept.size(), 2u);
  const std::vector low = {box_building(1, {0, 0}, 30, 120, 15), box_building(2, {36, 0}, 30, 120, 15)};
  EXPECT_EQ(blocks_of(low, {}, 25, ground_below(0, 0)).blocks.size(), 1u);
}

TEST(CertifiedBlocks, AreTheSameEachTime) {
  const std::vector<Building> town = random_town(4, 60);
  const CertifiedBlocks one = blocks_of(town, {}, 25, ground_below()), other = blocks_of(town, {}, 25, ground_below());
  ASSERT_EQ(one.blocks.size(), other.blocks.size());
  for (std::size_t i = 0; i < one.blocks.size(); ++i) {
    EXPECT_EQ(one.blocks[i].walls.positions, other.blocks[i].walls.positions);
    EXPECT_EQ(one.blocks[i].roof.positions, other.blocks[i].roof.positions);
  }
  EXPECT_EQ(one.error_m, other.error_m);
}

// Every 20th building of real places in detail, against its blocks.
TEST(CertifiedBlocksReal, StandForBuildingsWithRoofsAndFacades) {
  const Rulebook rules = parse_rulebook(shipped_rules());
  for (const char* name : {"monaco/monaco-2023.osm.pbf", "chicago-loop/chicago_loop.osm.pbf"}) {
    if (!std::filesystem::exists(real_data(name))) GTEST_SKIP() << name << " is absent";
    std::vector<Building> town = buildings_in(name);
    ASSERT_GT(town.size(), 500u);
    town.resize(300);
    const std::vector<simplify::Corners> ground = {{{-1e5, -1e5, 0}, {1e5, -1e5, 0}, {1e5, 1e5, 0}},
                                                   {{-1e5, -1e5, 0}, {1e5, 1e5, 0}, {-1e5, 1e5, 0}}};
    const auto shapes = shapes_of(town, rules, block_source_tolerance_m(25));
    const CertifiedBlocks made = certified_blocks({town, shapes, ground}, 25);
    EXPECT_LE(made.error_m, 25);
    EXPECT_LT(made.blocks.size() + made.kept.size(), town.size());
    std::vector<simplify::Corners> level = surface_of(made, shapes);
    level.insert(level.end(), ground.begin(), ground.end());
    for (std::size_t i = 0; i < town.size(); i += 20) {
      constexpr double kFine_m = 0.4;  // without facade textures
      std::vector<simplify::Corners> full;
      add(full, shapes_of(std::span(&town[i], 1), rules, kFine_m, false).front());
      EXPECT_GE(made.error_m + kFine_m, simplify::sampled_distance_m(full, level, 4)) << name << " " << i;
    }
  }
}

}  // namespace
}  // namespace citykiln::buildings
