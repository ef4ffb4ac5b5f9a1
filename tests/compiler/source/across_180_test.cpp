#include "compiler/source/across_180.h"

#include <gtest/gtest.h>

#include "tests/compiler/source/extract_text.h"

namespace citykiln::source {
namespace {

constexpr const char* kFiji =
    R"(<node id="1" lat="-16.8" lon="179.9999"/><node id="2" lat="-16.8" lon="-179.9999"/>)"
    R"(<node id="3" lat="-16.7999" lon="-179.9999"/><node id="4" lat="-16.7999" lon="179.9999"/>)"
    R"(<way id="7"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="yes"/></way>)";

TEST(Across180, AMapOnBothSidesIsOneNarrowMap) {
  Report report;
  const OsmData data = read(kFiji, report);
  EXPECT_NEAR(data.node_box.west, 179.9999, 1e-6);
  EXPECT_NEAR(data.node_box.east, 180.0001, 1e-6);
  ASSERT_EQ(data.areas.size(), 1u);
  for (const Location& point : data.ring_points) EXPECT_NEAR(point.lon_deg(), 180, 0.001);
}

TEST(Across180, OtherMapsStayAsTheyAre) {
  Report report;
  const OsmData wide = read(R"(<node id="1" lat="0" lon="-120"/><node id="2" lat="0" lon="100"/>)"
                            R"(<way id="7"><nd ref="1"/><nd ref="2"/><tag k="highway" v="road"/></way>)",
                            report);
  EXPECT_NEAR(wide.node_box.west, -120, 1e-6);
  EXPECT_NEAR(wide.node_box.east, 100, 1e-6);
}

}  // namespace
}  // namespace citykiln::source
