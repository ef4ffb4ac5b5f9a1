#include "compiler/roads/pieces/dropped_kerbs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/roads/pieces/pieces.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

constexpr double kKerbTile_m = 4096, kFullKerb_m = 0.125;

// A street of 6 m along y = 100 with pavements of 2 m, and a point at x = 200.
Road crossed_street(map::TrackPointKind kind, std::uint8_t traits = 0) {
  Road road = made_road(1, {{100, 100}, {200, 100}, {300, 100}}, 6, map::LandCoverClass::kTertiaryRoad, 2, 2);
  road.country = map::CountryGroup::kBritishIsles;
  road.points = {{.vertex = 1, .kind = kind, .traits = traits}};
  return road;
}

std::vector<RoadStretch> dropped(const Road& road, bool assumes) {
  return with_dropped_kerbs(road, stretches_of(road, {}, kKerbTile_m), {}, assumes);
}

double dropped_at(const Road& road, Vec2 p, bool assumes = true) {
  std::vector<KerbRamp> ramps;
  add_kerb_ramps(road, dropped(road, assumes), ramps);
  return dropped_m(index_kerb_ramps(std::move(ramps)), p, kFullKerb_m);
}

TEST(DroppedKerbs, FallAtCrossingsAndRiseAlongRampsAndAcrossThePavement) {
  const Road road = crossed_street(map::TrackPointKind::kZebra);
  const double low_m = kFullKerb_m - kKerbLip_m;
  EXPECT_DOUBLE_EQ(dropped_at(road, {200, 103}), low_m);
  EXPECT_DOUBLE_EQ(dropped_at(road, {198, 97}), low_m);
  EXPECT_NEAR(dropped_at(road, {202 + kKerbRamp_m / 2, 103}), low_m / 2, 1e-9);
  EXPECT_DOUBLE_EQ(dropped_at(road, {202 + kKerbRamp_m, 103}), 0);
  EXPECT_NEAR(dropped_at(road, {200, 104.5}), low_m * 0.5 / (2 - 0.15625), 1e-9);
  EXPECT_DOUBLE_EQ(dropped_at(road, {200, 105}), 0);
  EXPECT_DOUBLE_EQ(dropped_at(road, {200, 100}), 0);  // islands stay
}

TEST(DroppedKerbs, MappedOnesBeatWhatIsUsual) {
  using enum map::TrackPointKind;
  EXPECT_EQ(dropped_at(crossed_street(kCrossing, map::kRaisedKerb), {200, 103}), 0);
  EXPECT_EQ(dropped_at(crossed_street(kCrossing, map::kFlushKerb), {200, 103}), kFullKerb_m);
  EXPECT_EQ(dropped_at(crossed_street(kCrossing), {200, 103}, false), 0);
  EXPECT_GT(dropped_at(crossed_street(kCrossing, map::kLoweredKerb), {200, 103}, false), 0);
  EXPECT_GT(dropped_at(crossed_street(kPlainCrossing), {200, 103}), 0);
}

TEST(DroppedKerbs, StretchesAreCutWhereRampsEndAndKeepTheirMarkings) {
  const std::vector<RoadStretch> runs = dropped(crossed_street(map::TrackPointKind::kPlainCrossing), true);
  ASSERT_EQ(runs.size(), 5u);
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) EXPECT_EQ(runs[i].to_m, runs[i + 1].from_m);
  for (const RoadStretch& run : runs) EXPECT_EQ(run.stretch, StretchKind::kAlong);
  EXPECT_DOUBLE_EQ(runs[2].to_m - runs[2].from_m, kPlainCrossing_m);
  EXPECT_DOUBLE_EQ(runs[1].to_m - runs[1].from_m, kKerbRamp_m);
}

std::size_t slab_pieces(const Road& road, bool assumes) {
  const RoadPieces made = pieces_of(road, {}, dropped(road, assumes), {}, kKerbTile_m, 0.1);
  return static_cast<std::size_t>(std::ranges::count_if(made.pieces, [&](const Piece& piece) {
    return piece.layout != kNoMarkingLayout && made.layouts[piece.layout].panel_m > 0;
  }));
}

// Two at each kerb, since the axis has a point in the middle of the crossing.
TEST(TactilePaving, LiesAtBothKerbsWhereItIsUsualOrMapped) {
  using enum map::TrackPointKind;
  EXPECT_EQ(slab_pieces(crossed_street(kZebra), true), 4u);
  EXPECT_EQ(slab_pieces(crossed_street(kZebra), false), 0u);
  EXPECT_EQ(slab_pieces(crossed_street(kZebra, map::kNoTactileSlabs), true), 0u);
  EXPECT_EQ(slab_pieces(crossed_street(kZebra, map::kTactileSlabs | map::kLoweredKerb), false), 4u);
  Road elsewhere = crossed_street(kZebra);
  elsewhere.country = map::CountryGroup::kTropicalAfrica;
  EXPECT_EQ(slab_pieces(elsewhere, true), 0u);
}

}  // namespace
}  // namespace citykiln::roads
