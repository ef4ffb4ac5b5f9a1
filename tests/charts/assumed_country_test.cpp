#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/contract/derived_id.h"
#include "tests/charts/assumed_lands.h"
#include "tests/charts/assumed_values.h"
#include "tests/scratch_folder.h"

namespace citykiln::charts {
namespace {

constexpr LonLat kSwabia{10, 48}, kUckermark{13.5, 53.3}, kLimerick{-8.6, 52.5};
constexpr const char* kFarmland = R"(<tag k="landuse" v="farmland"/>)";
constexpr const char* kMeadow = R"(<tag k="landuse" v="meadow"/>)";
constexpr const char* kTrack = R"(<tag k="highway" v="track"/>)";
constexpr const char* kTertiary = R"(<tag k="highway" v="tertiary"/>)";
constexpr const char* kTreeRow = R"(<tag k="natural" v="tree_row"/>)";
constexpr const char* kHedge = R"(<tag k="barrier" v="hedge"/>)";

/// The text of a map of 3 km, from places in metres about its middle.
struct CountryMap {
  LonLat middle;
  std::string nodes, ways;
  int next_node = 1, next_way = 1;

  void line(const std::vector<Vec2>& points, const char* tags) {
    std::string refs;
    for (const Vec2 p : points) {
      nodes += fmt::format("<node id=\"{}\" {}/>", next_node, at(p));
      refs += fmt::format("<nd ref=\"{}\"/>", next_node++);
    }
    ways += fmt::format("<way id=\"{}\">{}{}</way>", next_way++, refs, tags);
  }
  void rectangle(Vec2 low, Vec2 high, const char* tags) {
    line({low, {high.x, low.y}, high, {low.x, high.y}, low}, tags);
  }

  Place place() const {
    const LonLat low = lonlat_of({-1500, -1500}), high = lonlat_of({1500, 1500});
    const ScratchFolder folder;
    folder.write("map.osm",
                 fmt::format("<?xml version=\"1.0\"?><osm version=\"0.6\"><bounds minlat=\"{:.8f}\" minlon=\"{:.8f}\" "
                             "maxlat=\"{:.8f}\" maxlon=\"{:.8f}\"/>{}{}</osm>",
                             low.lat_deg, low.lon_deg, high.lat_deg, high.lon_deg, nodes, ways));
    Result<Place> place = read_place(folder.at("map.osm"), {}, 1);
    EXPECT_TRUE(place) << to_string(place.error());
    return std::move(*place);
  }

 private:
  LonLat lonlat_of(Vec2 p) const {
    constexpr double kDegree_m = 111200;
    return {middle.lon_deg + p.x / kDegree_m / std::cos(middle.lat_deg * std::numbers::pi / 180),
            middle.lat_deg + p.y / kDegree_m};
  }
  std::string at(Vec2 p) const {
    const LonLat place = lonlat_of(p);
    return fmt::format("lat=\"{:.8f}\" lon=\"{:.8f}\"", place.lat_deg, place.lon_deg);
  }
};

constexpr OsmId way_id(std::int64_t id) { return {OsmType::kWay, id}; }

map::Features assumed_without(const Place& place, LeftOut kind, Assumptions on = kAllAssumptions) {
  return guessed(
      place, kind, [](OsmId) { return true; }, on);
}

/// Six fields of 4 ha with a hedge between two rows, a meadow beside them, and a field of its own.
CountryMap six_fields() {
  CountryMap map{kSwabia, {}, {}};
  for (const double y : {0.0, 200.0})
    for (const double x : {0.0, 200.0, 400.0}) map.rectangle({x, y}, {x + 200, y + 200}, kFarmland);
  map.rectangle({600, 0}, {800, 200}, kMeadow);
  map.rectangle({0, 420}, {200, 620}, kFarmland);
  map.line({{0, 200}, {600, 200}}, kHedge);
  return map;
}

TEST(AssumedLands, JoinNeighbouringFieldsOfOneClass) {
  const Place place = six_fields().place();
  const std::vector<Land> lands = lands_of(place.mapped);
  ASSERT_EQ(lands.size(), 1u);
  EXPECT_EQ(lands[0].id.osm, way_id(1));
  EXPECT_EQ(lands[0].fields.size(), 6u);
  ASSERT_EQ(lands[0].outlines.size(), 1u);
  // strips about borders end up to 4 m outside of the land
  EXPECT_NEAR(area_m2(lands[0].outlines[0]), 240000, 1500);
  double borders_m = 0;
  for (const auto& [a, b] : lands[0].borders) borders_m += distance(a, b);
  EXPECT_NEAR(borders_m, 2 * 1400, 100) << "from both sides";
}

TEST(AssumedLands, CloseTheGapOfAHedgeButNotThatOfARoad) {
  for (const double gap_m : {0.0, 6.0, 12.0}) {
    CountryMap map{kSwabia, {}, {}};
    map.rectangle({0, 0}, {200, 200}, kFarmland);
    map.rectangle({200 + gap_m, 0}, {400 + gap_m, 200}, kFarmland);
    EXPECT_EQ(lands_of(map.place().mapped).size(), gap_m > kFieldGap_m ? 0u : 1u) << gap_m;
  }
}

TEST(AssumedLands, DoNotJoinFieldsThatMeetInACorner) {
  CountryMap map{kSwabia, {}, {}};
  map.rectangle({0, 0}, {200, 200}, kFarmland);
  map.rectangle({200, 200}, {400, 400}, kFarmland);
  EXPECT_TRUE(lands_of(map.place().mapped).empty());
}

TEST(AssumedLands, LeaveBordersAndTheirHedgesOut) {
  map::Features features = six_fields().place().mapped;
  EXPECT_EQ(features.barriers.size(), 1u);
  join_fields(features);
  EXPECT_TRUE(features.barriers.empty());
  EXPECT_EQ(std::ranges::count(features.areas, map::LandCoverClass::kFarmland, &map::AreaFeature::surface), 2);
  EXPECT_EQ(std::ranges::count(features.areas, map::LandCoverClass::kMeadow, &map::AreaFeature::surface), 1);
  EXPECT_TRUE(std::ranges::is_sorted(features.areas, {}, &map::AreaFeature::id));
}

TEST(AssumedFields, MeasureMappedFieldsBetweenWays) {
  CountryMap map = six_fields();
  map.line({{100, -50}, {100, 205}}, kTrack);
  const Place place = map.place();
  const std::vector<Sample> sizes = tagged_field_sizes(place), densities = tagged_fields_per_km2(place);
  ASSERT_EQ(sizes.size(), 7u) << "the track divides one field, and cuts too little off another";
  EXPECT_NEAR(median_of(sizes, &Sample::tagged), 4, 0.05);
  EXPECT_NEAR(std::ranges::min_element(sizes, {}, &Sample::tagged)->tagged, 2, 0.05);
  EXPECT_NEAR(densities[0].tagged, 7 / 0.24, 0.3);
  EXPECT_TRUE(tagged_meadow_sizes(place).empty());
}

TEST(AssumedFields, MeasureHowTheirLandIsDivided) {
  const Place place = six_fields().place();
  const ValueKey land{way_id(1), 0};
  const map::Features undivided = assumed_without(place, LeftOut::kFields, kNoAssumptions);
  EXPECT_NEAR(built_field_sizes(undivided).at(land), 24, 0.2);
  EXPECT_NEAR(built_fields_per_km2(undivided).at(land), 1 / 0.24, 0.05);
  const map::Features divided = assumed_without(place, LeftOut::kFields);
  EXPECT_LT(built_field_sizes(divided).at(land), 6);
  EXPECT_GT(built_fields_per_km2(divided).at(land), 4 / 0.24);
}

double balanced_accuracy_of_borders(const Place& place, const map::Features& features) {
  const Values built = built_field_borders(features);
  std::vector<Sample> samples = tagged_field_borders(place);
  EXPECT_GT(samples.size(), 100u);
  for (Sample& sample : samples) sample.assumed = built.at(sample.key);
  return score_of(samples, &Sample::assumed, true).half;
}

TEST(AssumedFields, FindBordersWhereTheyAreMapped) {
  const Place place = six_fields().place();
  map::Features features = place.mapped;
  join_fields(features);
  const map::AreaFeature land = features.areas.front();
  const std::vector<Land> lands = lands_of(place.mapped);
  EXPECT_EQ(balanced_accuracy_of_borders(place, features), 0.5) << "without borders";
  for (const map::AreaFeature* field : lands[0].fields) {
    features.areas.push_back(land);
    features.areas.back().id = field_id(land.id, static_cast<std::uint32_t>(field->id.osm.id));
    features.areas.back().polygon = field->polygon;
  }
  // mapped borders reach up to a look beyond their ends
  EXPECT_GT(balanced_accuracy_of_borders(place, features), 0.95);
}

TEST(AssumedFields, HaveAsManyPlacesAtBordersAsElsewhereAndNoneAtWays) {
  CountryMap map = six_fields();
  map.line({{0, 200}, {600, 200}}, kTrack);
  const std::vector<Sample> samples = tagged_field_borders(map.place());
  const auto is_yes = [](const Sample& sample) { return sample.tagged == 1; };
  EXPECT_EQ(2 * static_cast<std::size_t>(std::ranges::count_if(samples, is_yes)), samples.size());
  EXPECT_TRUE(std::ranges::all_of(samples, [](const Sample& sample) { return std::abs(sample.at.y - 200) > 14; }));
}

/// A road with a row on its left, another 100 m off, and one far away from any row, through farmland.
CountryMap three_roads(LonLat middle, const char* row_tags) {
  CountryMap map{middle, {}, {}};
  map.line({{-600, 0}, {600, 0}}, kTertiary);
  map.line({{-600, 100}, {600, 100}}, kTertiary);
  map.line({{-600, -1000}, {600, -1000}}, kTertiary);
  map.line({{-500, 7}, {600, 7}}, row_tags);
  map.rectangle({-1400, -1400}, {1400, 1400}, kFarmland);
  return map;
}

TEST(AssumedRoadsides, MeasureSidesOfRoadsNearMappedTrees) {
  const Place place = three_roads(kUckermark, kTreeRow).place();
  const std::vector<Sample> samples = tagged_avenues(place);
  ASSERT_EQ(samples.size(), 4u);
  EXPECT_EQ(samples[0].key, (ValueKey{way_id(1), 0}));
  EXPECT_EQ(samples[0].tagged, 1);
  EXPECT_EQ(samples[1].tagged, 0);
  EXPECT_EQ(samples[2].tagged, 0);
  EXPECT_TRUE(tagged_lane_hedges(place).empty());
}

TEST(AssumedRoadsides, LeaveTreesOutAndAssumeAvenues) {
  const Place place = three_roads(kUckermark, kTreeRow).place();
  map::Features features = assumed_without(place, LeftOut::kTrees);
  EXPECT_TRUE(features.tree_rows.empty());
  // whether a way has an avenue is drawn by its id
  for (map::Track& track : features.tracks) track.trees = map::TreeSides::kRight;
  const Values built = built_avenues(features);
  EXPECT_EQ(built.at({way_id(1), 0}), 0);
  EXPECT_EQ(built.at({way_id(1), 1}), 1);
  EXPECT_EQ(built_avenues(assumed_without(place, LeftOut::kTrees, kNoAssumptions)).at({way_id(1), 1}), 0);
}

TEST(AssumedRoadsides, LeaveHedgesOutAndAssumeThemAgain) {
  const Place place = three_roads(kLimerick, kHedge).place();
  const std::vector<Sample> samples = tagged_lane_hedges(place);
  ASSERT_EQ(samples.size(), 4u);
  EXPECT_EQ(samples[0].tagged, 1);
  EXPECT_EQ(samples[1].tagged, 0);
  const Values none = built_lane_hedges(assumed_without(place, LeftOut::kHedges, kNoAssumptions));
  EXPECT_EQ(none.at({way_id(1), 0}), 0);
  const Values built = built_lane_hedges(assumed_without(place, LeftOut::kHedges));
  EXPECT_GT(built.at({way_id(1), 0}), 0.9);
  EXPECT_GT(built.at({way_id(2), 1}), 0.9);
}

TEST(AssumedSamples, HaveSharesOfYesAndMedians) {
  std::vector<Sample> samples(4);
  samples[0].tagged = samples[1].tagged = 1;
  samples[0].assumed = samples[2].assumed = 1;
  EXPECT_EQ(yes_shares_of(samples, &Sample::assumed).of_yes, 0.5);
  EXPECT_EQ(yes_shares_of(samples, &Sample::assumed).of_no, 0.5);
  EXPECT_EQ(yes_shares_of({}, &Sample::assumed).of_yes, 0);
  EXPECT_EQ(median_of(std::span(samples).first(3), &Sample::tagged), 1);
}

}  // namespace
}  // namespace citykiln::charts
