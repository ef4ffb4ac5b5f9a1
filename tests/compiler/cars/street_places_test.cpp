#include "compiler/cars/street_places.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/geometry/polygon.h"
#include "compiler/roads/markings/markings.h"
#include "tests/compiler/cars/made_street.h"

namespace citykiln::cars {
namespace {

using map::LaneDirection;
using map::LaneKind;
using roads::RoadStretch;

// A street of two lanes with a marked parking lane on its right, which has a junction in its middle.
struct BayStreet {
  std::vector<roads::Road> roads;
  std::vector<RoadStretch> stretches;

  BayStreet(double lane_m, map::DrivingSide side) {
    roads = {made_street(7, {{0, 0}, {120, 0}, {250, 0}}), made_street(8, {{120, 0}, {120, 100}})};
    roads::Road& road = roads[0];
    road.side = side, road.surface = map::LandCoverClass::kTertiaryRoad, road.kerb_parking = 0;
    const LaneDirection way = side == map::DrivingSide::kRight ? LaneDirection::kForward : LaneDirection::kBackward;
    road.section.lanes.push_back({LaneKind::kParking, way, lane_m});
    Report report;
    const std::vector<roads::Junction> junctions = roads::plan_junctions(roads, report);
    stretches = roads::stretches_of(road, roads::junction_intervals_of(roads, junctions)[0], 256);
  }

  std::vector<Place> places() const {
    std::vector<Place> all = places_along(roads[0], stretches, kMadeBox);
    std::erase_if(all, [](const Place& place) { return place.across == Vec2{}; });
    return all;
  }

  // True if paint covers a point, or the fresh asphalt that covers bays near a junction.
  bool is_painted(Vec2 p) const {
    const auto under = std::ranges::find_if(
        stretches, [&](const RoadStretch& stretch) { return stretch.from_m <= p.x && p.x <= stretch.to_m; });
    if (under == stretches.end()) return true;
    const roads::MarkingLayout layout{
        .surface = roads[0].surface, .lanes = roads[0].section.lanes, .stretch = under->stretch, .side = roads[0].side};
    const Vec2 uv{roads[0].section.axis_offset_m - p.y, p.x - under->zero_m};
    for (const roads::Mark& mark : roads::marks_of(layout))
      for (int turns = -22; turns <= 22; ++turns)
        if (winding_number(mark.ring, uv + Vec2{0, turns * roads::kLayoutLength_m}) != 0) return true;
    return false;
  }
};

// Places of the inner part of a place that lie in the lane, beside its line towards the traffic.
std::vector<Vec2> samples_in(const Place& place, const roads::Road& road) {
  constexpr double kStep_m = 0.25, kEdge_m = 0.125;
  const double inner_y = road.section.axis_offset_m - 7 - 0.2,
               outer_y = road.section.axis_offset_m - map::total_width_m(road.section) + 0.05;
  std::vector<Vec2> samples;
  for (double x = -place.length_m / 2 + kEdge_m; x < place.length_m / 2 - kEdge_m; x += kStep_m)
    for (double y = -place.width_m / 2 + kEdge_m; y < place.width_m / 2 - kEdge_m; y += kStep_m) {
      const Vec2 p = place.at + place.ahead * x + left_of(place.ahead) * y;
      if (p.y < inner_y && p.y > outer_y) samples.push_back(p);
    }
  return samples;
}

TEST(StreetPlaces, LieBetweenThePaintedLines) {
  for (const auto side : {map::DrivingSide::kRight, map::DrivingSide::kLeft})
    for (const double lane_m : {2.0, 3.25, 4.0, 4.25, 4.5, 5.0}) {
      const BayStreet street(lane_m, side);
      const std::vector<Place> places = street.places();
      EXPECT_GT(places.size(), lane_m < 4 ? 30u : 60u) << lane_m;
      std::size_t painted = 0, samples = 0;
      for (const Place& place : places)
        for (const Vec2 p : samples_in(place, street.roads[0])) ++samples, painted += street.is_painted(p);
      EXPECT_GT(samples, places.size() * 50);
      EXPECT_EQ(painted, 0u) << lane_m;
    }
}

TEST(StreetPlaces, AreAsManyAsBays) {
  // 250 m less the junction and 6 m on either side of it
  EXPECT_NEAR(static_cast<double>(BayStreet(2, map::DrivingSide::kRight).places().size()), 225 / 6.0, 3);
  EXPECT_NEAR(static_cast<double>(BayStreet(4.5, map::DrivingSide::kRight).places().size()), 225 / 3.0, 5);
  EXPECT_NEAR(static_cast<double>(BayStreet(5, map::DrivingSide::kRight).places().size()), 225 / 2.4, 6);
}

TEST(StreetPlaces, OfSlantedRowsLookAheadAndToTheKerb) {
  for (const Place& place : BayStreet(4.5, map::DrivingSide::kRight).places()) {
    EXPECT_NEAR(place.ahead.x, 0.5, 0.01);
    EXPECT_LT(place.ahead.y, -0.8);
    EXPECT_GE(place.length_m, 4.75);
  }
  for (const Place& place : BayStreet(4.5, map::DrivingSide::kLeft).places()) EXPECT_NEAR(place.ahead.x, -0.5, 0.01);
}

TEST(StreetPlaces, HaveKeysOfTheirOwn) {
  std::vector<StableId> keys;
  for (const Place& place : BayStreet(5, map::DrivingSide::kRight).places()) keys.push_back(place.key);
  std::ranges::sort(keys);
  EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());
}

}  // namespace
}  // namespace citykiln::cars
