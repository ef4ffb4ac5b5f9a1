#include "compiler/ground/water/grown_widths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::ground {
namespace {

const Box2 kExtent{{0, 0}, {20000, 20000}};

map::Waterway stream_along(std::int64_t id, Polyline axis) {
  map::Waterway water;
  water.id = {{OsmType::kWay, id}, 0};
  water.axis = std::move(axis);
  water.width_m = 2, water.least_width_m = 1, water.most_width_m = 4;
  return water;
}

TEST(GrownWidths, GrowDownstreamAndWhereStreamsMeet) {
  const std::vector<double> widths = grown_widths_m(
      std::vector{stream_along(1, {{1000, 9000}, {1000, 8000}}), stream_along(2, {{1000, 8000}, {1000, 7000}}),
                  stream_along(3, {{3000, 8000}, {1000, 7000}}), stream_along(4, {{1000, 7000}, {1000, 1000}})},
      kExtent);
  EXPECT_LT(widths[0], widths[1]);
  EXPECT_LT(widths[1], widths[3]);
  EXPECT_LT(widths[2], widths[3]);
  // half a kilometre above the middle of the first
  EXPECT_NEAR(widths[0], kWidthAtOneKilometre_m * 0.7071, 0.07);
  for (const double width : widths) EXPECT_EQ(width, std::floor(width * 8) / 8);
}

TEST(GrownWidths, StayInTheirRangeAndTaggedOnesStay) {
  map::Waterway tagged = stream_along(2, {{1000, 8999}, {1000, 8000}});
  tagged.width_m = 0.7, tagged.least_width_m = tagged.most_width_m = 0;
  const std::vector<double> widths =
      grown_widths_m(std::vector{stream_along(1, {{1000, 9000}, {1000, 8999}}), tagged,
                                 stream_along(3, {{1000, 8000}, {1000, 19000}, {2000, 1000}})},
                     kExtent);
  EXPECT_EQ(widths, (std::vector{1.0, 0.7, 4.0}));
}

TEST(GrownWidths, AWaterwayThatComesFromOutsideBeginsWithItsWidth) {
  const std::vector<double> widths = grown_widths_m(std::vector{stream_along(1, {{0, 5000}, {100, 5000}})}, kExtent);
  EXPECT_NEAR(widths[0], 2, 0.125);
}

TEST(GrownWidths, PartsOfWhatPartsAndACircle) {
  const std::vector<double> widths = grown_widths_m(
      std::vector{stream_along(1, {{1000, 9000}, {1000, 5000}}), stream_along(2, {{1000, 5000}, {1100, 4900}}),
                  stream_along(3, {{1000, 5000}, {900, 4900}}), stream_along(4, {{5000, 5000}, {6000, 5000}}),
                  stream_along(5, {{6000, 5000}, {5000, 5000}})},
      kExtent);
  // an arm has half of the 4 km above it
  EXPECT_NEAR(widths[1], kWidthAtOneKilometre_m * 1.43, 0.07);
  EXPECT_EQ(widths[1], widths[2]);
  EXPECT_LT(widths[3], widths[4]);
}

}  // namespace
}  // namespace citykiln::ground
