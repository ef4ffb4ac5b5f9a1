#include "compiler/things/contact_masts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/things/facing.h"

namespace citykiln::things {
namespace {

using map::LandCoverClass;
using map::ThingRole;

ground::GradedTerrain flat_land() {
  map::Heightfield field{{-1024, -1024}, {16, 16}, 129, 129, {}, 0};
  field.heights.assign(129 * 129, static_cast<std::int32_t>(10 / map::kHeightQuantum_m));
  return ground::GradedTerrain(std::move(field));
}

map::Track rails(std::int64_t id, Polyline axis, LandCoverClass surface = LandCoverClass::kRailway) {
  map::Track track;
  track.id = {{OsmType::kWay, id}, 0};
  for (std::size_t i = 0; i < axis.size(); ++i) track.node_ids.push_back(100 * id + static_cast<std::int64_t>(i));
  track.axis = std::move(axis);
  track.surface = surface, track.is_rail = true, track.has_contact_line = true;
  return track;
}

struct Line {
  map::Features features;
  std::vector<ground::LandCoverPolygon> cover;
  std::vector<structures::Span> bridges;

  explicit Line(std::vector<map::Track> tracks) {
    features.extent = {{-1024, -1024}, {1024, 1024}};
    features.tracks = std::move(tracks);
  }
  void add_cover(LandCoverClass surface, Vec2 low, Vec2 high) {
    cover.push_back({.id = {{OsmType::kWay, 900 + static_cast<std::int64_t>(cover.size())}, 0},
                     .surface = surface,
                     .area_m2 = 500,
                     .rings = {{low, {high.x, low.y}, high, {low.x, high.y}}}});
  }
  ContactLines lines(Report& report) const {
    static const ground::GradedTerrain land = flat_land();
    return plan_contact_lines(features, {.cover = cover, .roads = {}, .bridges = bridges, .ground = land}, report);
  }
  ContactLines lines() const {
    Report report;
    return lines(report);
  }
};

std::size_t count_of(const ContactLines& lines, ThingRole role) {
  return static_cast<std::size_t>(
      std::ranges::count_if(lines.masts, [&](const Thing& mast) { return map::role_of(mast.form.kind) == role; }));
}

TEST(ContactTracks, SpansAreShorterInCurves) {
  Polyline arc;
  for (int i = 0; i <= 60; ++i) arc.push_back({300 * std::sin(i * 0.02), 300 - 300 * std::cos(i * 0.02)});
  map::Features features;
  features.tracks = {rails(1, {{0, 0}, {600, 0}}), rails(2, arc), rails(3, {{0, 0}, {600, 0}}, LandCoverClass::kTram)};
  const TrackIndex index = index_tracks(features, {}, {});
  EXPECT_EQ(longest_span_m(index.tracks[0], 300), kRailSpan_m);
  EXPECT_EQ(longest_span_m(index.tracks[2], 300), kTramSpan_m);
  // the height of the arc is span² / (8 · 300)
  EXPECT_NEAR(longest_span_m(index.tracks[1], 180), std::sqrt(8 * 300 * kCurveOffset_m), 5);
  for (const ContactTrack& track : index.tracks) {
    const std::vector<double> stations = stations_of(track);
    for (std::size_t i = 1; i < stations.size(); ++i) {
      const double middle_m = (stations[i - 1] + stations[i]) / 2;
      EXPECT_LE(stations[i] - stations[i - 1], longest_span_m(track, middle_m) + 0.01);
      EXPECT_GE(stations[i] - stations[i - 1], longest_span_m(track, middle_m) * 0.7);
    }
  }
}

TEST(ContactMasts, StandBesideOneTrack) {
  Report report;
  const ContactLines lines = Line({rails(1, {{0, 0}, {600, 0}})}).lines(report);
  EXPECT_EQ(lines.masts.size(), 10u);
  EXPECT_EQ(lines.supports.size(), 10u);
  for (const Thing& mast : lines.masts) {
    EXPECT_EQ(map::role_of(mast.form.kind), ThingRole::kContactMast);
    EXPECT_EQ(mast.at.y, 3.25) << "on the northern side";
    EXPECT_LT(unit_vector(mast.direction).y, -0.99) << "it faces the track";
    EXPECT_EQ(mast.form.capacity, 13);
  }
  for (const ContactSupport& support : lines.supports) {
    EXPECT_NEAR(support.contact.z, 10 + kRailWire_m, 0.01);
    EXPECT_NEAR(std::abs(support.contact.y), kStagger_m, 0.01);
  }
  EXPECT_EQ(report.assumed(Assumption::kMasts), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(ContactMasts, StandOutsideOfTwoTracksAtTheSameStations) {
  const ContactLines lines = Line({rails(1, {{0, 0}, {600, 0}}), rails(2, {{620, 4}, {-20, 4}})}).lines();
  EXPECT_EQ(lines.masts.size(), 20u);
  for (const Thing& mast : lines.masts) EXPECT_TRUE(mast.at.y == -3.25 || mast.at.y == 7.25);
  EXPECT_EQ(lines.supports.size(), 20u);
}

TEST(ContactMasts, AreAPortalOverThreeTracks) {
  const ContactLines lines =
      Line({rails(1, {{0, 0}, {600, 0}}), rails(2, {{0, 4.5}, {600, 4.5}}), rails(3, {{0, 9}, {600, 9}})}).lines();
  EXPECT_EQ(count_of(lines, ThingRole::kContactPortal), 10u);
  EXPECT_EQ(count_of(lines, ThingRole::kContactHanger), 30u);
  EXPECT_EQ(count_of(lines, ThingRole::kContactMast), 0u);
  EXPECT_EQ(lines.supports.size(), 30u);
}

TEST(ContactMasts, ArePolesOnBothSidesOfATramway) {
  Line tramway(
      {rails(1, {{0, 0}, {300, 0}}, LandCoverClass::kTram), rails(2, {{0, 3}, {300, 3}}, LandCoverClass::kTram)});
  tramway.add_cover(LandCoverClass::kResidentialRoad, {-10, -6}, {310, 9});
  const ContactLines lines = tramway.lines();
  EXPECT_EQ(count_of(lines, ThingRole::kContactPole), 18u);
  EXPECT_EQ(lines.cross_wires.size(), 9u);
  for (const Thing& pole : lines.masts) EXPECT_TRUE(pole.at.y < -6 || pole.at.y > 9);
  tramway.add_cover(LandCoverClass::kBuilding, {-10, 9}, {310, 30});
  const ContactLines beside_houses = tramway.lines();
  EXPECT_EQ(beside_houses.cross_wires.size(), 0u);
  EXPECT_EQ(count_of(beside_houses, ThingRole::kContactPole), 0u) << "6 m and 3 m are too far for an arm";
}

TEST(ContactMasts, StandOnTheOtherSideOfAWall) {
  Line line({rails(1, {{0, 0}, {600, 0}})});
  line.add_cover(LandCoverClass::kBuilding, {0, 2}, {600, 20});
  for (const Thing& mast : line.lines().masts) EXPECT_EQ(mast.at.y, -3.25);
  line.add_cover(LandCoverClass::kRiver, {0, -20}, {600, -2});
  Report report;
  EXPECT_TRUE(line.lines(report).masts.empty());
  EXPECT_EQ(report.counts().at(Code::kNoPlaceForThing), 10u);
}

TEST(ContactMasts, AreNotInTunnelsAndWithoutAContactLine) {
  map::Track tunnel = rails(1, {{0, 0}, {600, 0}}), third_rail = rails(2, {{0, 50}, {600, 50}});
  tunnel.passage = map::Passage::kTunnel, third_rail.has_contact_line = false;
  EXPECT_TRUE(Line({tunnel, third_rail}).lines().masts.empty());
}

TEST(ContactMasts, GiveWayToMappedMasts) {
  Line line({rails(1, {{0, 0}, {600, 0}})});
  line.features.things = {{.id = {{OsmType::kNode, 5}, 0}, .at = {300, -4}, .kind = "catenary_mast", .value = ""}};
  const ContactLines lines = line.lines();
  EXPECT_TRUE(lines.replaced.contains({OsmType::kNode, 5}));
  const auto mapped = std::ranges::find(lines.masts, OsmId{OsmType::kNode, 5}, [](const Thing& t) { return t.id.osm; });
  ASSERT_NE(mapped, lines.masts.end());
  EXPECT_EQ(mapped->form.capacity, 16);
  for (const Thing& mast : lines.masts)
    EXPECT_TRUE(mast.id.osm.type == OsmType::kNode || distance(mast.at, {300, -4}) > kMappedMasts_m - 8);
  EXPECT_EQ(std::ranges::count(lines.supports, 300, &ContactSupport::along_m), 1);
}

structures::Span bridge_over(double top_m) {
  structures::Span bridge;
  bridge.id = {{OsmType::kWay, 50}, 0};
  bridge.surface = LandCoverClass::kResidentialRoad;
  bridge.axis = {{300, -40}, {300, 40}};
  bridge.section.lanes = {{.width_m = 8}};
  bridge.section.axis_offset_m = 4;
  bridge.profile = {{0, top_m, 0}, {80, top_m, 0}};
  return bridge;
}

TEST(ContactMasts, WiresPassBelowABridge) {
  Line line({rails(1, {{0, 0}, {600, 0}})});
  line.bridges = {bridge_over(10 + 8.0)};
  const ContactLines lines = line.lines();
  double lowest_m = 100;
  for (const ContactSupport& support : lines.supports)
    if (std::abs(support.along_m - 300) < 8) lowest_m = std::min(lowest_m, support.contact.z + support.messenger_m);
  EXPECT_LT(lowest_m, 18 - 0.4);
  for (const ContactSupport& support : lines.supports) EXPECT_GE(support.contact.z, 10 + kLeastWire_m);
  for (const Thing& mast : lines.masts) EXPECT_GT(std::abs(mast.at.x - 300), 5.5) << "none below the deck";
  line.bridges = {bridge_over(10 + 5.0)};
  for (const ContactSupport& support : line.lines().supports) EXPECT_GT(std::abs(support.along_m - 300), 5);
}

// Tracks in any order give the same masts, and what lies beyond the radius changes none.
TEST(ContactMasts, DependOnNothingBeyondTheRadius) {
  const std::vector<map::Track> base = {rails(3, {{0, 0}, {400, 0}}), rails(4, {{-100, 4.5}, {300, 4.5}}),
                                        rails(7, {{300, 4.5}, {700, 4.5}})};
  const auto near_origin = [](const ContactLines& lines) {
    std::vector<std::pair<ObjectId, Vec2>> masts;
    for (const Thing& mast : lines.masts)
      if (mast.at.x < 200) masts.emplace_back(mast.id, mast.at);
    return masts;
  };
  const auto expected = near_origin(Line(base).lines());
  EXPECT_FALSE(expected.empty());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RandomSequence random(seed, stable_id(ObjectId{}), "masts");
    std::vector<map::Track> tracks = base;
    const double x = 200 + kContactRadius_m + random.unit(0) * 50, y = 9 + random.unit(1) * 4;
    tracks.push_back(rails(1, {{x, y}, {x + 300, y}}));
    std::ranges::rotate(tracks, tracks.begin() + static_cast<std::ptrdiff_t>(seed % 4));
    Line changed(tracks);
    changed.add_cover(LandCoverClass::kLake, {x, -50}, {x + 50, 50});
    EXPECT_EQ(near_origin(changed.lines()), expected);
  }
}

// Whatever the tracks: no mast is in the clear space of one.
TEST(ContactMasts, KeepClearOfEveryTrack) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const RandomSequence random(seed, stable_id(ObjectId{}), "tracks");
    std::vector<map::Track> tracks;
    for (std::uint32_t i = 0; i < 8; ++i) {
      const auto coordinate = [&](std::uint32_t k) { return random.unit(8 * i + k) * 400 - 200; };
      const bool is_tram = random.unit(8 * i + 6) < 0.3;
      tracks.push_back(rails(i + 1, {{coordinate(0), coordinate(1)}, {coordinate(2), coordinate(3)}},
                             is_tram ? LandCoverClass::kTram : LandCoverClass::kRailway));
    }
    const Line line(tracks);
    for (const Thing& mast : line.lines().masts) {
      const ThingRole role = map::role_of(mast.form.kind);
      if (role != ThingRole::kContactMast && role != ThingRole::kContactPole) continue;
      for (const map::Track& track : tracks)
        EXPECT_GE(distance_to_polyline(track.axis, mast.at),
                  (track.surface == LandCoverClass::kTram ? kPoleClear_m : kMastClear_m) - 0.01);
    }
  }
}

}  // namespace
}  // namespace citykiln::things
