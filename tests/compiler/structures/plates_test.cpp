#include "compiler/structures/plates.h"

#include <gtest/gtest.h>

#include "compiler/roads/roads_on_ground.h"
#include "compiler/structures/plate_mesh.h"
#include "tests/compiler/structures/made_spans.h"

namespace citykiln::structures {
namespace {

map::Track bridge_track(std::int64_t id, Polyline axis) {
  map::Track track;
  track.id = {{OsmType::kWay, id}, 0};
  track.axis = std::move(axis);
  track.surface = map::LandCoverClass::kResidentialRoad;
  track.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  track.passage = map::Passage::kBridge;
  return track;
}

Span span_on(const map::Track& track, double from_m, double to_m) {
  Span span{roads::road_of(track)};
  span.profile = {{0, from_m, 0}, {40, to_m, 0}};
  return span;
}

// Two bridges of 6 m side by side on an outline of 40 x 30 m.
struct TwoOnAnOutline {
  map::Features features;
  std::vector<Span> bridges;

  TwoOnAnOutline() {
    features.tracks = {bridge_track(1, {{0, -8}, {40, -8}}), bridge_track(2, {{0, 8}, {40, 8}})};
    features.bridge_areas = {{.id = {{OsmType::kWay, 9}, 0},
                              .polygon = {{{0, -15}, {40, -15}, {40, 15}, {0, 15}}, {}},
                              .layer = 1,
                              .is_outline = true,
                              .tracks = {features.tracks[0].id, features.tracks[1].id}}};
    bridges = with_plates({span_on(features.tracks[0], 10, 12), span_on(features.tracks[1], 11, 11)}, features);
  }
};

double plan_area_m2(const Plate& plate, bool is_below_road) {
  double sum_m2 = 0;
  for (const PlatePart& part : plate.parts)
    for (const auto& corners : part.rings) {
      Ring ring;
      for (const PlateCorner& corner : corners) ring.push_back(in_plan(corner.at));
      sum_m2 += part.is_below_road == is_below_road ? signed_area_m2(ring) : 0;
    }
  return sum_m2;
}

TEST(Plates, TheFirstBridgeStoresThePlateAndNoneHasASlab) {
  const TwoOnAnOutline made;
  EXPECT_EQ(made.bridges[0].deck, DeckForm::kPlate);
  EXPECT_EQ(made.bridges[1].deck, DeckForm::kPlate);
  EXPECT_EQ(made.bridges[0].plates.size(), 1u);
  EXPECT_TRUE(made.bridges[1].plates.empty());
}

TEST(Plates, PartsCoverTheOutlineOnce) {
  const TwoOnAnOutline made;
  const Plate& plate = made.bridges[0].plates.at(0);
  EXPECT_NEAR(plan_area_m2(plate, true), 2 * 6 * 40, 0.5);
  EXPECT_NEAR(plan_area_m2(plate, false), 40 * 30 - 2 * 6 * 40, 0.5);
}

TEST(Plates, APlateHasTheHeightsOfTheRoadsThatItCarries) {
  const TwoOnAnOutline made;
  const Plate& plate = made.bridges[0].plates.at(0);
  EXPECT_NEAR(plate_height_m(plate, {0, -5}), 10, 0.02);
  EXPECT_NEAR(plate_height_m(plate, {40, -11}), 12, 0.02);
  EXPECT_NEAR(plate_height_m(plate, {20, 5}), 11, 0.02);
  EXPECT_TRUE(is_on_plate(plate, {20, 0}));
  EXPECT_FALSE(is_on_plate(plate, {20, 16}));
}

TEST(Plates, WallsStandOnTheOutlineExceptWhereRoadsCrossIt) {
  const TwoOnAnOutline made;
  double walls_m = 0;
  for (const std::vector<Rib>& run : wall_runs(made.bridges[0].plates.at(0))) {
    walls_m += run.back().along_m;
    for (const Rib& rib : run) {
      EXPECT_TRUE(std::abs(rib.at.x) < 0.01 || std::abs(rib.at.x - 40) < 0.01 ||
                  std::abs(std::abs(rib.at.y) - 15) < 0.01);
      EXPECT_TRUE(std::abs(rib.at.y) >= 14 || std::abs(std::abs(rib.at.y) - 8) > 2.9) << rib.at.y;
    }
  }
  EXPECT_NEAR(walls_m, 140 - 4 * 6.5, 3);
}

TEST(Plates, MeshesAreClosedAndAsThickAsTheSlab) {
  const TwoOnAnOutline made;
  GeneratedStructure generated;
  add_plate(made.bridges[0].plates.at(0), {.thickness_m = 1, .parapet_m = 1}, {}, generated);
  const std::vector<materials::MaterialMesh> meshes = all_meshes(generated);
  EXPECT_TRUE(open_edges(meshes).empty());
  // roads lie in a step of 0.25 m
  EXPECT_NEAR(volume_m3(meshes), 40 * 30 * 1 - 2 * 6 * 40 * 0.25 + 114 * 0.25, 8);
}

}  // namespace
}  // namespace citykiln::structures
