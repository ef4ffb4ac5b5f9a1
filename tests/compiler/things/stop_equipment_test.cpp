#include "compiler/things/stop_equipment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace citykiln::things {
namespace {

using map::LandCoverClass;

ground::LandCoverPolygon stop_cover(std::int64_t id, const Box2& box, LandCoverClass surface) {
  return {{{OsmType::kWay, id}, 0}, surface, 1, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
}

// A stop on the pavement north of a street, which it faces; houses behind the pavement.
struct StopInStreet {
  std::vector<ground::LandCoverPolygon> cover;
  std::vector<map::ThingFeature> mapped{};

  explicit StopInStreet(double pavement_m)
      : cover{stop_cover(1, {{-50, -6}, {50, 0}}, LandCoverClass::kTertiaryRoad),
              stop_cover(2, {{-50, 0}, {50, pavement_m}}, LandCoverClass::kPavement),
              stop_cover(3, {{-50, pavement_m}, {50, 20}}, LandCoverClass::kBuilding)} {}

  std::vector<map::ThingFeature> equipment(std::uint8_t has) const {
    FreePlaces places(cover);
    map::ThingFeature stop;
    stop.id = {{OsmType::kNode, 9}, 0}, stop.kind = "bus_stop", stop.stop_has = has;
    return equipment_of_stop(stop, {0, 0.5}, {0, -1}, mapped, places);
  }
};

std::set<std::string> kinds_of_all(const std::vector<map::ThingFeature>& things) {
  std::set<std::string> kinds;
  for (const map::ThingFeature& thing : things) kinds.insert(thing.kind);
  return kinds;
}

TEST(StopEquipment, IsThatOfItsTags) {
  const StopInStreet street(5);
  EXPECT_TRUE(street.equipment(0).empty());
  EXPECT_EQ(kinds_of_all(street.equipment(map::kStopShelter)), (std::set<std::string>{"shelter"}));
  EXPECT_EQ(kinds_of_all(street.equipment(map::kStopBench | map::kStopBin)),
            (std::set<std::string>{"bench", "waste_basket"}));
  EXPECT_EQ(kinds_of_all(street.equipment(map::kStopShelter | map::kStopBench)), (std::set<std::string>{"shelter"}))
      << "which has a bench";
}

TEST(StopEquipment, LooksAtTheStreetFromThePavement) {
  for (const map::ThingFeature& thing : StopInStreet(5).equipment(map::kStopShelter | map::kStopBin)) {
    EXPECT_EQ(thing.faces, (Vec2{0, -1}));
    EXPECT_GE(thing.at.y - thing.depth_m / 2, 0);
    EXPECT_LE(thing.at.y + thing.depth_m / 2, 5);
    EXPECT_GE(std::abs(thing.at.x), thing.width_m / 2) << "beside the stop";
  }
}

TEST(StopEquipment, IsLeftOutOnNarrowPavements) {
  EXPECT_EQ(kinds_of_all(StopInStreet(1.75).equipment(map::kStopShelter | map::kStopBench)),
            (std::set<std::string>{"bench"}));
}

TEST(StopEquipment, IsNotThereTwice) {
  StopInStreet street(5);
  map::ThingFeature shelter;
  shelter.kind = "shelter", shelter.at = {12, 2};
  street.mapped = {shelter};
  EXPECT_TRUE(street.equipment(map::kStopShelter).empty());
}

}  // namespace
}  // namespace citykiln::things
