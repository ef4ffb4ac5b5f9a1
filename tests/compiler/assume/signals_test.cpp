#include "compiler/assume/signals.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::assume {
namespace {

using map::LandCoverClass;

map::Track main_street(std::int64_t id, Polyline axis, std::vector<std::int64_t> nodes,
                       LandCoverClass surface = LandCoverClass::kSecondaryRoad) {
  map::Track track;
  track.id = {{OsmType::kWay, id}, 0};
  track.axis = std::move(axis), track.node_ids = std::move(nodes), track.surface = surface;
  return track;
}

// Two main streets that cross at node 5, among houses.
map::Features crossing_of_streets(LandCoverClass second = LandCoverClass::kSecondaryRoad) {
  map::Features features;
  features.tracks = {main_street(1, {{-100, 0}, {0, 0}, {100, 0}}, {1, 5, 2}),
                     main_street(2, {{0, -100}, {0, 0}, {0, 100}}, {3, 5, 4}, second)};
  for (std::int64_t i = 0; i < 4; ++i) {
    map::Footprint house;
    house.id = {{OsmType::kWay, 10 + i}, 0};
    house.polygon.outer = {{20.0 + i, 20}, {30.0 + i, 20}, {30.0 + i, 30}};
    features.footprints.push_back(house);
  }
  return features;
}

std::size_t assumed_signals(const map::Features& features) {
  Report report;
  const WithSignals made = assume_signals(features, report);
  const auto points = std::ranges::count_if(made.tracks, [](const map::Track& track) {
    return std::ranges::any_of(track.points, [](const map::TrackPoint& point) {
      return point.kind == map::TrackPointKind::kSignals && point.vertex == 1;
    });
  });
  EXPECT_EQ(points > 0, made.things.size() > features.things.size());
  return made.things.size() - features.things.size();
}

TEST(AssumeSignals, StandWhereMainStreetsCrossAmongHouses) {
  EXPECT_EQ(assumed_signals(crossing_of_streets()), 1u);
  EXPECT_EQ(assumed_signals(crossing_of_streets(LandCoverClass::kResidentialRoad)), 0u);
  map::Features open = crossing_of_streets();
  open.footprints.clear();
  EXPECT_EQ(assumed_signals(open), 0u);
}

TEST(AssumeSignals, NoneWhereSignalsAreMappedNear) {
  map::Features features = crossing_of_streets();
  map::ThingFeature mapped;
  mapped.id = {{OsmType::kNode, 77}, 0}, mapped.kind = "traffic_signals", mapped.at = {kNoneMapped_m - 10, 0};
  features.things = {mapped};
  EXPECT_EQ(assumed_signals(features), 0u);
  features.things[0].at.x = kNoneMapped_m + 10;
  EXPECT_EQ(assumed_signals(features), 1u);
}

TEST(AssumeSignals, NoneWhereAStreetSplits) {
  map::Features features = crossing_of_streets();
  features.tracks[1] = main_street(2, {{0, 0}, {100, 20}}, {5, 4});
  EXPECT_EQ(assumed_signals(features), 0u);
}

}  // namespace
}  // namespace citykiln::assume
