#include "compiler/verify/ground/measure_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/map/land_cover_class.h"

namespace citykiln::verify {
namespace {

constexpr OsmId kLawn{OsmType::kWay, 1};
constexpr OsmId kBridge{OsmType::kWay, 2};

/// Everything should lie at 10 m.
double flat(Vec2, double z_m, OsmId) { return std::abs(z_m - 10); }

/// A square of ground about the tile's origin (0, 0, 10), with its last corner lifted; and a deck of the bridge
/// below it, of the same material.
bake::BakedTile square(float lifted_m, bool has_second_half) {
  bake::BakedTile tile{{0, 0}, {0, 0, 10}, 0.1, 0, {OsmId{}, kLawn, kBridge}, {}, {}};
  bake::Primitive ground;
  ground.material = map::values_of(map::LandCoverClass::kUnknown).material;
  ground.positions = {{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, lifted_m}};
  ground.features = {1, 1, 1, 1};
  ground.triangles = {{0, 1, 2}};
  if (has_second_half) ground.triangles.push_back({0, 2, 3});
  bake::Primitive bridge{ground.material, {{0, 0, -5}, {64, 0, -5}, {64, 64, -5}}, {}, {}, {2, 2, 2}, {{0, 1, 2}}};
  bridge.layer = bake::Layer::kStructures;
  tile.primitives = {ground, bridge};
  return tile;
}

constexpr Box2 kBox{{0, 0}, {64, 64}};

TEST(SampleGround, ReportsNoErrorOnCorrectGround) {
  const GroundSamples samples = sample_ground(square(0, true), flat, kBox, 16);
  EXPECT_EQ(samples.count, 256u);
  EXPECT_EQ(samples.uncovered, 0u);
  EXPECT_EQ(samples.error_m, 0);
}

TEST(SampleGround, FindsPlacesWithoutGround) {
  const GroundSamples samples = sample_ground(square(0, false), flat, kBox, 16);
  // the other half, but for squares on the diagonal, which may fall to either side
  EXPECT_GE(samples.uncovered, (256u - 16u) / 2);
  EXPECT_LE(samples.uncovered, (256u + 16u) / 2);
}

TEST(SampleGround, PassesTheFeatureOfAPlace) {
  const auto off_m = [](Vec2, double, OsmId feature) { return feature == kLawn ? 1.0 : 2.0; };
  EXPECT_EQ(sample_ground(square(0, true), off_m, kBox, 16).error_m, 1);
}

TEST(SampleGround, FindsTheLargestDeviation) {
  const GroundSamples samples = sample_ground(square(2, true), flat, kBox, 16);
  EXPECT_GT(samples.error_m, 1.8);
  EXPECT_LE(samples.error_m, 2);
}

// A way may be a wall, a building and land cover at once: its layers tell which of its faces are ground.
TEST(SampleGround, CountsAFeaturesGroundWhateverElseItIs) {
  bake::BakedTile tile = square(0, true);
  for (bake::Primitive& primitive : tile.primitives) primitive.features.assign(primitive.positions.size(), 2);
  for (const bake::Layer layer : {bake::Layer::kBuildings, bake::Layer::kStructures, bake::Layer::kProps}) {
    tile.primitives[1].layer = layer;
    EXPECT_EQ(sample_ground(tile, flat, kBox, 16).uncovered, 0u);
    EXPECT_EQ(sample_ground(tile, flat, kBox, 16).error_m, 0);
  }
}

TEST(SampleGround, CountsRoadsAndWater) {
  for (const bake::Layer layer : {bake::Layer::kGround, bake::Layer::kRoads, bake::Layer::kWater}) {
    bake::BakedTile tile = square(0, true);
    tile.primitives[0].layer = layer;
    EXPECT_EQ(sample_ground(tile, flat, kBox, 16).uncovered, 0u);
    tile.primitives[1].layer = layer;
    EXPECT_EQ(sample_ground(tile, flat, kBox, 16).error_m, 5);
  }
}

TEST(SamplesASide, GrowsWithTheFacesWithinItsLimits) {
  EXPECT_EQ(samples_a_side(0), kFewestSamplesASide);
  EXPECT_EQ(samples_a_side(2), kFewestSamplesASide);
  EXPECT_EQ(samples_a_side(20'000), 200);
  EXPECT_EQ(samples_a_side(20'001), 201);
  EXPECT_EQ(samples_a_side(100'000'000), kMostSamplesASide);
}

}  // namespace
}  // namespace citykiln::verify
