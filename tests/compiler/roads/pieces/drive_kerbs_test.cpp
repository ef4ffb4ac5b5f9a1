#include "compiler/roads/pieces/drive_kerbs.h"

#include <gtest/gtest.h>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

constexpr double kDriveTile_m = 4096, kWholeKerb_m = 0.125, kLow_m = kWholeKerb_m - kKerbLip_m;

// A street of 6 m along y = 100 with pavements of 2 m.
Road street_with_drives() {
  return made_road(1, {{100, 100}, {300, 100}}, 6, map::LandCoverClass::kResidentialRoad, 2, 2);
}

// The end of a drive at the border of its lot, 0.5 m inside the pavement on the left of the street.
constexpr DriveMouth kLeftMouth{.at = {140, 104.5}, .outward = {0, -1}};

std::vector<DriveKerb> kerbs_of(const Road& road, std::span<const DriveMouth> mouths) {
  return drive_kerbs_of(road, stretches_of(road, {}, kDriveTile_m), {}, mouths);
}

double lowered_at(const Road& road, Vec2 p, std::span<const DriveMouth> mouths) {
  const std::vector<Road> roads = {road};
  return dropped_m(index_kerb_ramps(drive_ramps_of(roads, {}, kDriveTile_m, true, mouths)), p, kWholeKerb_m);
}

TEST(DriveKerbs, AreLowBeforeDrivesOnTheirSide) {
  const std::vector<DriveMouth> mouths = {kLeftMouth};
  const Road road = street_with_drives();
  EXPECT_DOUBLE_EQ(lowered_at(road, {138.75, 103}, mouths), kLow_m);
  EXPECT_DOUBLE_EQ(lowered_at(road, {141.5, 103}, mouths), kLow_m);
  EXPECT_NEAR(lowered_at(road, {141.5 + kKerbRamp_m / 2, 103}, mouths), kLow_m / 2, 1e-9);
  EXPECT_DOUBLE_EQ(lowered_at(road, {141.5 + kKerbRamp_m, 103}, mouths), 0);
  EXPECT_DOUBLE_EQ(lowered_at(road, {140, 97}, mouths), 0) << "the other side";
  EXPECT_DOUBLE_EQ(lowered_at(road, {140, 105}, mouths), 0) << "the outer edge of the pavement";
}

TEST(DriveKerbs, AreNoneBeforeDrivesOfOtherStreets) {
  const std::vector<DriveMouth> others = {{.at = {140, 104.5}, .outward = {0, 1}},
                                          {.at = {140, 107.5}, .outward = {0, -1}},
                                          {.at = {100.5, 104.5}, .outward = {0, -1}}};
  EXPECT_TRUE(kerbs_of(street_with_drives(), others).empty());
  const Road bare = made_road(1, {{100, 100}, {300, 100}}, 10);
  EXPECT_TRUE(kerbs_of(bare, std::vector<DriveMouth>{kLeftMouth}).empty()) << "no pavement";
}

TEST(DriveKerbs, OfDrivesThatFaceEachOtherCutTheStreetAtQuarterMetres) {
  const std::vector<DriveMouth> mouths = {kLeftMouth, {.at = {140.9, 95.5}, .outward = {0, 1}}};
  const Road road = street_with_drives();
  const std::vector<DriveKerb> kerbs = kerbs_of(road, mouths);
  EXPECT_EQ(kerbs, (std::vector<DriveKerb>{{38.5, 41.5, true}, {39.5, 42.5, false}}));
  EXPECT_DOUBLE_EQ(lowered_at(road, {140.9, 97}, mouths), kLow_m) << "on the right";
  const std::vector<RoadStretch> runs = cut_at_drives(stretches_of(road, {}, kDriveTile_m), kerbs);
  EXPECT_EQ(runs.size(), 9u);
  EXPECT_EQ(runs.front().from_m, 0);
  EXPECT_EQ(runs.back().to_m, 200);
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    EXPECT_EQ(runs[i].to_m, runs[i + 1].from_m);
    EXPECT_GE(runs[i].to_m - runs[i].from_m, 0.25);
  }
}

TEST(DriveKerbs, GiveWayToCrossingsAndJunctions) {
  Road road = made_road(1, {{100, 100}, {200, 100}, {300, 100}}, 6, map::LandCoverClass::kResidentialRoad, 2, 2);
  road.points = {{.vertex = 1, .kind = map::TrackPointKind::kZebra}};
  const std::vector<DriveMouth> beside = {{.at = {203, 104.5}, .outward = {0, -1}}};
  EXPECT_TRUE(kerbs_of(road, beside).empty());
  const std::vector<JunctionInterval> junction = {{.at_m = 40, .before_m = 3, .after_m = 3}};
  const Road plain = street_with_drives();
  EXPECT_TRUE(drive_kerbs_of(plain, stretches_of(plain, {}, kDriveTile_m), junction, std::vector{kLeftMouth}).empty());
}

}  // namespace
}  // namespace citykiln::roads
