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

TEST(Across180, MultipolygonsAreAssembledAcrossIt) {
  const std::string relation =
      R"(<node id="11" lat="-16.79998" lon="179.99995"/><node id="12" lat="-16.79998" lon="-179.99995"/>)"
      R"(<node id="13" lat="-16.79993" lon="-179.99995"/><node id="14" lat="-16.79993" lon="179.99995"/>)"
      R"(<way id="8"><nd ref="11"/><nd ref="12"/><nd ref="13"/><nd ref="14"/><nd ref="11"/></way>)"
      R"(<relation id="9"><member type="way" ref="7" role="outer"/><member type="way" ref="8" role="inner"/>)"
      R"(<tag k="type" v="multipolygon"/><tag k="natural" v="water"/></relation>)";
  Report report;
  const OsmData data = read(kFiji + relation, report);
  ASSERT_EQ(data.areas.size(), 2u);
  EXPECT_EQ(data.areas[1].rings.count, 2u);
  for (const Location& point : data.ring_points) EXPECT_NEAR(point.lon_deg(), 180, 0.001);
  EXPECT_TRUE(report.balances());
  EXPECT_EQ(report.counts().count(Code::kBrokenArea), 0u);
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
