#include "compiler/assume/curves/curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::assume {
namespace {

using map::LandCoverClass;
using map::Track;

Track street(std::int64_t id, Polyline axis, std::vector<std::int64_t> nodes = {}) {
  Track track;
  track.id = {{OsmType::kWay, id}, 0};
  for (Vec2& p : axis) p = snapped_to(map::kMapStep_m, p);
  for (std::size_t v = 0; nodes.size() < axis.size(); ++v) nodes.push_back(id * 1000 + static_cast<std::int64_t>(v));
  track.axis = std::move(axis), track.node_ids = std::move(nodes);
  track.surface = LandCoverClass::kResidentialRoad;
  track.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 5.5}}, 2.75};
  return track;
}

Track curved(const map::Features& features, std::size_t index = 0) {
  Report report;
  return curved_tracks(features, report)[index];
}

Track curved(const Track& track) {
  map::Features features;
  features.tracks = {track};
  return curved(features);
}

double turn_deg(const Polyline& axis, std::size_t v) {
  const Vec2 in = axis[v] - axis[v - 1], out = axis[v + 1] - axis[v];
  return std::abs(arctangent2_deg(cross(in, out), dot(in, out)));
}

double most_turn_deg(const Polyline& axis) {
  double most = 0;
  for (std::size_t v = 1; v + 1 < axis.size(); ++v) most = std::max(most, turn_deg(axis, v));
  return most;
}

/// Chords of 20 m that turn by 15 degrees each.
Polyline arc(int chords, double turned_deg = 15, double chord_m = 20) {
  Polyline axis = {{0, 0}};
  for (int c = 0; c < chords; ++c)
    axis.push_back(axis.back() + Vec2{cosine(c * turned_deg), sine(c * turned_deg)} * chord_m);
  return axis;
}

/// A way of random chords and turns, mostly gentle.
Track random_way(std::uint32_t i) {
  const RandomSequence draws(3, StableId{i}, "way");
  Polyline axis = {{0, 0}};
  double heading_deg = 0;
  const std::uint32_t chords = 1 + draws.below(20, 0);
  for (std::uint32_t c = 1; c <= chords; ++c) {
    heading_deg += draws.between(-1, 1, 10 * c) * (draws.below(4, 10 * c + 1) == 0 ? 120 : 40);
    const double long_m = std::pow(2.0, draws.between(0, 7, 10 * c + 2));
    axis.push_back(axis.back() + Vec2{cosine(heading_deg), sine(heading_deg)} * long_m);
  }
  return street(i + 1, axis);
}

std::size_t crossings_of(const Polyline& axis) {
  std::size_t crossings = 0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < axis.size(); ++j)
      if (crossing_shares(axis[i], axis[i + 1], axis[j], axis[j + 1])) ++crossings;
  return crossings;
}

TEST(CurvedTracks, AStraightWayIsAsMapped) {
  const Track way = street(1, {{0, 0}, {30, 0}, {70, 0.5}, {110, 1}});
  const Track made = curved(way);
  EXPECT_EQ(made.axis, way.axis);
  EXPECT_EQ(made.node_ids, way.node_ids);
  EXPECT_EQ(made.assumed, way.assumed);
}

TEST(CurvedTracks, ABendHasNoCorners) {
  const Track way = street(1, arc(6)), made = curved(way);
  EXPECT_NEAR(most_turn_deg(way.axis), 15, 0.1);
  EXPECT_LT(most_turn_deg(made.axis), 9.5);
  EXPECT_TRUE(has(made.assumed, Assumption::kCurves));
}

TEST(CurvedTracks, PassThroughTheirNodes) {
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Track way = random_way(i), made = curved(way);
    ASSERT_EQ(made.axis.size(), made.node_ids.size());
    std::size_t next = 0;
    for (std::size_t v = 0; v < made.axis.size(); ++v)
      if (next < way.axis.size() && made.node_ids[v] == way.node_ids[next]) {
        EXPECT_EQ(made.axis[v], way.axis[next++]) << i;
      }
    EXPECT_EQ(next, way.axis.size()) << i;
  }
}

TEST(CurvedTracks, KeepToTheDistanceFromTheMap) {
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Track way = random_way(i), made = curved(way);
    for (const Vec2 p : made.axis) EXPECT_LE(distance_to_polyline(way.axis, p), kMostInTheOpen_m + 0.04) << i;
  }
}

TEST(CurvedTracks, HaveNoNewCrossings) {
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Track way = random_way(i);
    EXPECT_LE(crossings_of(curved(way).axis), crossings_of(way.axis)) << i;
  }
}

TEST(CurvedTracks, AReversedWayHasTheSameCurve) {
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Track way = random_way(i);
    Track back = way;
    std::ranges::reverse(back.axis);
    std::ranges::reverse(back.node_ids);
    Polyline again = curved(back).axis;
    std::ranges::reverse(again);
    EXPECT_EQ(curved(way).axis, again) << i;
  }
}

TEST(CurvedTracks, NodesHaveIdsOfTheirOwn) {
  const Track made = curved(street(1, arc(6)));
  const std::set<std::int64_t> ids(made.node_ids.begin(), made.node_ids.end());
  EXPECT_EQ(ids.size(), made.node_ids.size());
}

TEST(CurvedTracks, MarkedNodesKeepTheirPlaces) {
  Track way = street(1, arc(6));
  way.points = {{.vertex = 2, .kind = map::TrackPointKind::kZebra}, {.vertex = 6, .kind = map::TrackPointKind::kStop}};
  const Track made = curved(way);
  EXPECT_EQ(made.axis[made.points[0].vertex], way.axis[2]);
  EXPECT_EQ(made.axis[made.points[1].vertex], way.axis[6]);
}

TEST(CurvedTracks, ASharpCornerStays) {
  const Track way = street(1, {{0, 0}, {40, 0}, {40, 40}});
  EXPECT_EQ(curved(way).axis, way.axis);
}

TEST(CurvedTracks, TwoWaysGoOnInEachOther) {
  const Polyline axis = arc(6);
  map::Features features;
  features.tracks = {street(1, {axis.begin(), axis.begin() + 4}, {1, 2, 3, 4}),
                     street(2, {axis.begin() + 3, axis.end()}, {4, 5, 6, 7})};
  const Track first = curved(features, 0), second = curved(features, 1);
  Polyline both = first.axis;
  both.insert(both.end(), second.axis.begin() + 1, second.axis.end());
  EXPECT_EQ(both, curved(street(3, axis)).axis);
}

TEST(CurvedTracks, AtAJunctionOnlyTheWayThatRunsThroughIsCurved) {
  const Polyline axis = arc(2);
  map::Features features;
  features.tracks = {street(1, axis, {1, 2, 3}), street(2, {axis[1], axis[1] + Vec2{0, -40}}, {2, 9})};
  EXPECT_LT(most_turn_deg(curved(features, 0).axis), 9.5);
  EXPECT_EQ(curved(features, 1).axis, features.tracks[1].axis);
}

TEST(CurvedTracks, ACrossingOfTwoWaysKeepsItsDirections) {
  const Polyline axis = arc(2);
  map::Features features;
  features.tracks = {street(1, axis, {1, 2, 3}),
                     street(2, {axis[1] + Vec2{0, 40}, axis[1], axis[1] + Vec2{5, -40}}, {8, 2, 9})};
  EXPECT_EQ(curved(features, 0).axis, features.tracks[0].axis);
  EXPECT_EQ(curved(features, 1).axis, features.tracks[1].axis);
}

TEST(CurvedTracks, KeepFromBuildings) {
  map::Features features;
  features.tracks = {street(1, arc(6))};
  const Track free = curved(features);
  // beside the outer side of the second chord, as near as a kerb may be
  const Vec2 a = features.tracks[0].axis[1], b = features.tracks[0].axis[2], out = unit(left_of(b - a)) * -1.0;
  map::Footprint house;
  house.id = {{OsmType::kWay, 50}, 0};
  const Vec2 from = a + (b - a) * 0.3 + out * 3.3, to = a + (b - a) * 0.7 + out * 3.3;
  house.polygon.outer = {from, from + out * 8, to + out * 8, to};
  features.footprints = {house};
  const Track beside = curved(features);
  EXPECT_LT(beside.axis.size(), free.axis.size());
  for (std::size_t v = 0; v + 1 < beside.axis.size(); ++v)
    for (const Vec2 corner : {from, to})
      EXPECT_GT(distance_to_segment(beside.axis[v], beside.axis[v + 1], corner), 3.25);
}

TEST(CurvedTracks, WhatLiesBeyondTheRadiusChangesNothing) {
  map::Features features;
  Polyline axis = {{-800, 5}, {-556, 0}, {-300, 0}, {-50, 20}, {0, 0}, {50, -10}, {300, 0}, {556, 0}, {800, 5}};
  features.tracks = {street(1, axis)};
  const auto middle = [&](const Track& track) {
    Polyline kept;
    for (const Vec2 p : track.axis)
      if (std::abs(p.x) < 20) kept.push_back(p);
    return kept;
  };
  const Polyline before = middle(curved(features));
  map::Footprint house;
  house.id = {{OsmType::kWay, 50}, 0};
  house.polygon.outer = {{620, 0}, {640, 0}, {640, 10}, {620, 10}};
  features.footprints = {house};
  features.tracks[0].axis[0] = {-800, 300};
  EXPECT_EQ(middle(curved(features)), before);
}

TEST(CurvedTracks, StairsAndWaysThroughBuildingsStay) {
  Track stairs = street(1, arc(6)), passage = stairs;
  stairs.surface = LandCoverClass::kSteps, passage.is_through_building = true;
  EXPECT_EQ(curved(stairs).axis, stairs.axis);
  EXPECT_EQ(curved(passage).axis, passage.axis);
}

map::Barrier hedge(Polyline axis) {
  map::Barrier barrier;
  barrier.id = {{OsmType::kWay, 1}, 0};
  for (Vec2& p : axis) p = snapped_to(map::kMapStep_m, p);
  barrier.axis = std::move(axis), barrier.kind = map::BarrierKind::kHedge;
  return barrier;
}

TEST(CurvedBarriers, ABendOfManyPointsIsCurved) {
  const std::vector<map::Barrier> mapped = {hedge(arc(6, 12, 6))};
  EXPECT_GT(curved_barriers(mapped)[0].axis.size(), mapped[0].axis.size());
}

TEST(CurvedBarriers, CornersOfLotsStay) {
  const std::vector<map::Barrier> mapped = {hedge({{0, 0}, {10, 0}, {19, 3}, {28, 0}, {40, 0}})};
  EXPECT_EQ(curved_barriers(mapped), mapped);
}

TEST(CurvedWaterways, RiversAreCurvedAndCulvertsAndNarrowStreamsAreNot) {
  map::Waterway river, culvert, stream;
  river.id = {{OsmType::kWay, 1}, 0}, culvert.id = {{OsmType::kWay, 2}, 0}, stream.id = {{OsmType::kWay, 3}, 0};
  for (const Vec2 p : arc(6, 25)) river.axis.push_back(snapped_to(map::kMapStep_m, p));
  culvert.axis = stream.axis = river.axis;
  for (Vec2& p : culvert.axis) p.y += 1000;
  for (Vec2& p : stream.axis) p.y += 2000;
  culvert.passage = map::Passage::kTunnel;
  river.width_m = culvert.width_m = kWideWater_m, stream.width_m = kWideWater_m / 2;
  const std::vector<map::Waterway> mapped = {river, culvert, stream}, made = curved_waterways(mapped);
  EXPECT_LT(most_turn_deg(made[0].axis), 12);
  EXPECT_EQ(made[1].axis, culvert.axis);
  EXPECT_EQ(made[2].axis, stream.axis);
}

}  // namespace
}  // namespace citykiln::assume
