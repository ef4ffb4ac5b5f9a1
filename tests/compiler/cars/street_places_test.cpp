#include "compiler/cars/street_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/geometry/polygon.h"
#include "compiler/roads/markings/markings.h"
#include "tests/compiler/cars/made_street.h"

namespace citykiln::cars {
namespace {

using map::LaneDirection;
using map::LaneKind;
using roads::RoadStretch;

// A street of two lanes with a marked parking lane on its right, which has a junction at either end.
struct BayStreet {
  std::vector<roads::Road> roads;
  std::vector<RoadStretch> stretches;

  BayStreet(double lane_m, map::DrivingSide side) {
    roads = {made_street(7, {{20, 0}, {120, 0}, {240, 0}}), made_street(8, {{20, -100}, {20, 0}, {20, 100}}),
             made_street(9, {{240, -100}, {240, 0}, {240, 100}})};
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

  bool has(roads::StretchKind kind) const {
    return std::ranges::any_of(stretches, [&](const RoadStretch& stretch) { return stretch.stretch == kind; });
  }

  roads::Marks marks_on(const RoadStretch& stretch) const {
    return roads::marks_of({.surface = roads[0].surface,
                            .lanes = roads[0].section.lanes,
                            .stretch = stretch.stretch,
                            .side = roads[0].side});
  }
};

// The paint of a street, and the fresh asphalt that covers bays near a junction.
struct Paint {
  const BayStreet& street;
  std::vector<roads::Marks> marks{};

  explicit Paint(const BayStreet& of) : street(of) {
    for (const RoadStretch& stretch : of.stretches) marks.push_back(of.marks_on(stretch));
  }

  bool covers(Vec2 p) const {
    const double along_m = p.x - street.roads[0].axis.front().x;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const RoadStretch& stretch = street.stretches[i];
      if (along_m < stretch.from_m || along_m > stretch.to_m) continue;
      const double v_m = std::fmod(along_m - stretch.zero_m + 12, 12),
                   u_m = street.roads[0].section.axis_offset_m - p.y;
      return std::ranges::any_of(marks[i], [&](const roads::Mark& mark) {
        return winding_number(mark.ring, {u_m, v_m}) != 0 || winding_number(mark.ring, {u_m, v_m + 12}) != 0 ||
               winding_number(mark.ring, {u_m, v_m - 12}) != 0;
      });
    }
    return true;
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
      ASSERT_TRUE(street.has(roads::StretchKind::kStart) && street.has(roads::StretchKind::kEnd));
      const std::vector<Place> places = street.places();
      EXPECT_GT(places.size(), lane_m < 4 ? 30u : 60u) << lane_m;
      const Paint paint(street);
      std::size_t painted = 0, samples = 0;
      for (const Place& place : places)
        for (const Vec2 p : samples_in(place, street.roads[0])) ++samples, painted += paint.covers(p);
      EXPECT_GT(samples, places.size() * 50);
      EXPECT_EQ(painted, 0u) << lane_m;
    }
}

TEST(StreetPlaces, AreAsManyAsBays) {
  for (const auto& [lane_m, step_m] : {std::pair{2.0, 6.0}, {4.5, 3.0}, {5.0, 2.4}}) {
    const double length_m = static_cast<double>(BayStreet(lane_m, map::DrivingSide::kRight).places().size()) * step_m;
    // 220 m less the junctions and what is not painted before them
    EXPECT_GT(length_m, 165) << lane_m;
    EXPECT_LT(length_m, 206) << lane_m;
  }
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
