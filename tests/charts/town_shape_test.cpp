#include "tests/charts/town_shape.h"

#include <gtest/gtest.h>

namespace citykiln::charts {
namespace {

const TownValues& values_of(const std::vector<TownValues>& values, TownMeasure measure) {
  return values[static_cast<std::size_t>(measure)];
}

TEST(TownShape, KolmogorovDistanceIsTheLargestDifferenceOfShares) {
  EXPECT_DOUBLE_EQ(kolmogorov_distance({1, 2, 3, 4}, {1, 2, 3, 4}), 0);
  EXPECT_DOUBLE_EQ(kolmogorov_distance({1, 2, 3, 4}, {3, 4, 5, 6}), 0.5);
  EXPECT_DOUBLE_EQ(kolmogorov_distance({1, 2}, {8, 9}), 1);
  EXPECT_DOUBLE_EQ(kolmogorov_distance({}, {1}), 1);
  EXPECT_DOUBLE_EQ(kolmogorov_distance({1, 1, 1, 2}, {1, 2, 2, 2}), 0.5);
}

// four streets about a block of 100 m by 100 m, and a house in it
invent::InventedMap square_map() {
  invent::InventedMap map;
  const Ring corners = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
  for (std::size_t i = 0; i < 4; ++i)
    map.lines.push_back({{corners[i], corners[(i + 1) % 4]}, {{"highway", "residential"}}});
  map.lines.push_back({{{50, 50}, {110, 50}}, {{"highway", "residential"}}});
  map.lines.push_back({{{0, 0}, {50, 50}}, {{"highway", "footway"}}});
  map.areas.push_back(
      {{{{-40, -40}, {-28, -40}, {-28, -30}, {-40, -30}}, {}}, {{"building", "house"}, {"building:levels", "2"}}});
  map.areas.push_back({{{{60, 60}, {64, 60}, {64, 62}, {60, 62}}, {}}, {{"building", "shed"}}});
  return map;
}

TEST(TownShape, MeasuresStreetsBlocksAndBuildingsOfAMap) {
  const TownMap map = town_map_of(square_map(), 300, "square");
  EXPECT_EQ(map.streets.size(), 5u) << "footways are no streets";
  const std::vector<TownValues> values = measure_town(map, 1);
  EXPECT_EQ(values_of(values, TownMeasure::kDegree), (TownValues{1, 3})) << "a dead end and a junction";
  EXPECT_EQ(values_of(values, TownMeasure::kFootprintArea), (TownValues{120})) << "smaller ones are left out";
  EXPECT_EQ(values_of(values, TownMeasure::kHeight), (TownValues{6}));
  ASSERT_EQ(values_of(values, TownMeasure::kBlockArea).size(), 1u);
  EXPECT_NEAR(values_of(values, TownMeasure::kBlockArea)[0], 90 * 90, 1);
  EXPECT_TRUE(values_of(values, TownMeasure::kStreetDensity).empty()) << "one house is no town";
}

TEST(TownShape, AMapThatIsMissingIsAnError) { EXPECT_FALSE(read_town_map("/nowhere/town.osm.pbf", 1)); }

}  // namespace
}  // namespace citykiln::charts
