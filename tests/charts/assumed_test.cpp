#include <gtest/gtest.h>

#include "tests/charts/assumed_values.h"
#include "tests/charts/chart.h"
#include "tests/scratch_folder.h"

namespace citykiln::charts {
namespace {

constexpr const char* kStreets = R"(<?xml version="1.0"?><osm version="0.6">
 <bounds minlat="47.999" minlon="9.998" maxlat="48.001" maxlon="10.002"/>
 <node id="1" lat="48.0000" lon="9.9990"/><node id="2" lat="48.0000" lon="10.0010"/>
 <node id="3" lat="48.0005" lon="9.9990"/><node id="4" lat="48.0005" lon="10.0010"/>
 <node id="5" lat="48.00056" lon="9.9990"/><node id="6" lat="48.00056" lon="10.0010"/>
 <node id="11" lat="48.0002" lon="10.0000"/><node id="12" lat="48.0002" lon="10.0002"/>
 <node id="13" lat="48.0003" lon="10.0002"/><node id="14" lat="48.0003" lon="10.0000"/>
 <node id="21" lat="47.99996" lon="9.9992"><tag k="highway" v="street_lamp"/></node>
 <node id="22" lat="47.99996" lon="9.9996"><tag k="highway" v="street_lamp"/></node>
 <node id="23" lat="47.99996" lon="10.0000"><tag k="highway" v="street_lamp"/></node>
 <way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/><tag k="sidewalk" v="left"/>
  <tag k="width" v="7"/><tag k="lit" v="yes"/></way>
 <way id="2"><nd ref="3"/><nd ref="4"/><tag k="highway" v="residential"/><tag k="sidewalk:left" v="separate"/></way>
 <way id="3"><nd ref="5"/><nd ref="6"/><tag k="highway" v="footway"/></way>
 <way id="4"><nd ref="11"/><nd ref="12"/><nd ref="13"/><nd ref="14"/><nd ref="11"/><tag k="building" v="house"/>
  <tag k="height" v="9"/><tag k="building:levels" v="2"/></way>
</osm>)";

constexpr OsmId way(std::int64_t id) { return {OsmType::kWay, id}; }

Place streets() {
  const ScratchFolder folder;
  folder.write("streets.osm", kStreets);
  Result<Place> place = read_place(folder.at("streets.osm"), {}, 1);
  EXPECT_TRUE(place) << to_string(place.error());
  return std::move(*place);
}

map::Features without(const Place& place, LeftOut kind) {
  return guessed(
      place, kind, [](OsmId) { return true; }, kNoAssumptions);
}

TEST(ChartOfAssumptions, ReadsPavementsOfEachSide) {
  const std::vector<Sample> samples = tagged_pavements(streets());
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_EQ(samples[0].tagged, 1);
  EXPECT_EQ(samples[1].tagged, 0);
  EXPECT_EQ(samples[2].key, (ValueKey{way(2), 0}));
  EXPECT_EQ(samples[2].tagged, 1);
}

TEST(ChartOfAssumptions, FindsPavementsThatAreWaysOfTheirOwn) {
  const Place place = streets();
  Values built = built_pavements(place.mapped);
  EXPECT_NEAR(built.at({way(1), 0}), 1, 1e-9);
  EXPECT_NEAR(built.at({way(1), 1}), 0, 1e-9);
  EXPECT_NEAR(built.at({way(2), 0}), 1, 1e-9);
  EXPECT_NEAR(built.at({way(2), 1}), 0, 1e-9);
  built = built_pavements(without(place, LeftOut::kPavements));
  EXPECT_NEAR(built.at({way(1), 0}), 0, 1e-9);
  EXPECT_NEAR(built.at({way(2), 0}), 1, 1e-9);
}

TEST(ChartOfAssumptions, LeavesOutTagsOfOneKindAtSomeElements) {
  const Place place = streets();
  EXPECT_EQ(built_widths(place.mapped).at({way(1), 0}), 7);
  EXPECT_NE(built_widths(without(place, LeftOut::kWidths)).at({way(1), 0}), 7);
  EXPECT_EQ(built_widths(without(place, LeftOut::kLamps)).at({way(1), 0}), 7);
  const auto elsewhere = guessed(
      place, LeftOut::kWidths, [](OsmId id) { return id != way(1); }, kNoAssumptions);
  EXPECT_EQ(built_widths(elsewhere).at({way(1), 0}), 7);
}

TEST(ChartOfAssumptions, MeasuresMappedLampsOfAStreet) {
  const Place place = streets();
  const std::vector<Sample> spacings = tagged_lamp_spacings(place), sides = tagged_lamp_sides(place);
  ASSERT_EQ(spacings.size(), 1u);
  EXPECT_NEAR(spacings[0].tagged, 29.8, 0.3);
  ASSERT_EQ(sides.size(), 1u);
  EXPECT_EQ(sides[0].tagged, 0);
  EXPECT_EQ(built_lit(without(place, LeftOut::kLamps)).at({way(1), 0}), 0);
  EXPECT_EQ(built_lamps_per_km(without(place, LeftOut::kLamps)).at({way(1), 0}), 0);
}

TEST(ChartOfAssumptions, HasHeightsAndStoreysOfBuildings) {
  const Place place = streets();
  ASSERT_EQ(tagged_heights(place).size(), 1u);
  EXPECT_NEAR(tagged_heights(place)[0].tagged, 9, 0.01);
  EXPECT_EQ(tagged_storeys(place)[0].tagged, 2);
  EXPECT_NE(built_heights(without(place, LeftOut::kHeights)).at({way(4), 0}), 9);
}

std::vector<Sample> samples_of(const std::vector<double>& tagged) {
  std::vector<Sample> samples;
  for (const double value : tagged)
    samples.push_back({.key = {}, .at = {static_cast<double>(samples.size()) * kBlock_m, 0}, .tagged = value});
  return samples;
}

TEST(AssumedSamples, ScoreErrorsByMedianAndNinetiethPercentile) {
  const std::vector<Sample> samples = samples_of({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  const Score score = score_of(samples, &Sample::assumed, false);
  EXPECT_EQ(score.half, 5);
  EXPECT_EQ(score.tenths, 9);
}

TEST(AssumedSamples, ScoreYesAndNoByBalancedAccuracy) {
  std::vector<Sample> samples = samples_of({1, 1, 1, 0});
  for (Sample& sample : samples) sample.assumed = 1;
  EXPECT_EQ(score_of(samples, &Sample::assumed, true).half, 0.5);
  EXPECT_EQ(score_of(std::span(samples).first(3), &Sample::assumed, true).half, 1);
  samples[3].assumed = 0, samples[0].assumed = 0;
  EXPECT_NEAR(score_of(samples, &Sample::assumed, true).half, (2.0 / 3 + 1) / 2, 1e-12);
}

TEST(AssumedSamples, TakeConstantsFromOtherPlacesAndMeansFromOtherBlocks) {
  std::vector<std::vector<Sample>> places = {samples_of({1, 2, 3}), samples_of({7, 8, 9})};
  set_constants(places, false);
  EXPECT_EQ(places[0][0].constant, 8);
  EXPECT_EQ(places[1][0].constant, 2);
  set_means(places[0]);
  EXPECT_EQ(places[0][0].mean, 2);
  EXPECT_EQ(places[0][1].mean, 2);
}

TEST(ChartOfAssumptions, AsksForMaps) {
  EXPECT_EQ(to_string(chart_assumed({}).error()), "chart assumed: needs maps (--map FILE)");
}

}  // namespace
}  // namespace citykiln::charts
