#include <gtest/gtest.h>

#include "compiler/map/things/thing_table.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

TEST(PowerLines, HaveTheirConductorsBundlesAndVoltage) {
  const Features f = features_of(R"(
    w1 0:0 90:0 power=line cables=6 wires=quad voltage=110000;380000
    w2 0:5 90:5 power=line circuits=2
    w3 0:9 90:9 power=minor_line
    w4 0:12 90:12 aerialway=chair_lift
    w5 0:15 90:15 aerialway=zip_line)");
  ASSERT_EQ(f.power_lines.size(), 4u);
  EXPECT_EQ(f.power_lines[0].cables, 6);
  EXPECT_EQ(f.power_lines[0].bundle, 4);
  EXPECT_EQ(f.power_lines[0].voltage_kv, 380);
  EXPECT_EQ(f.power_lines[0].node_ids.size(), 2u);
  EXPECT_EQ(f.power_lines[1].cables, 6);
  EXPECT_EQ(f.power_lines[2].cables, 0);
  EXPECT_EQ(f.power_lines[2].kind, PowerLineKind::kMinorLine);
  EXPECT_EQ(f.power_lines[3].kind, PowerLineKind::kAerialway);
}

TEST(PowerLines, BadNumbersAreDiagnosed) {
  Report report;
  const Features f = features_of("w1 0:0 90:0 power=line cables=many voltage=high", report);
  ASSERT_EQ(f.power_lines.size(), 1u);
  EXPECT_EQ(f.power_lines[0].cables, 0);
  EXPECT_EQ(std::ranges::count(report.diagnoses(), Code::kBadTagValue, &Diagnosis::code), 2);
}

// A map with towers at 0:0 and 900:0, the latter outside of it, where two lines meet.
Features towers_of(const std::string& lines) {
  const ThingTable rows = *read_thing_table("tower power=tower tower 18x8x38 ground along 0 size Tower", "things.txt");
  Options options;
  options.things = &rows;
  source::OsmData osm = MapText("n1 0:0 power=tower\nn2 900:0 power=tower\n" + lines).take();
  // nodes of ways have other ids in a MapText
  for (source::NodeRef& node : osm.way_nodes)
    for (const source::Node& tower : osm.nodes)
      if (node.at == tower.at) node.id = tower.id;
  Report report;
  return locate(osm, Plane(kTestOrigin), box_around(300), options, report);
}

TEST(PowerLines, SupportsOutsideOfTheExtentAreKept) {
  const Features f = towers_of("w1 0:0 900:0 power=line");
  ASSERT_EQ(f.things.size(), 1u);
  ASSERT_EQ(f.supports_beyond.size(), 1u);
  EXPECT_EQ(f.supports_beyond[0].id.osm.id, 2);
  EXPECT_TRUE(towers_of("w1 0:0 100:0 power=line").supports_beyond.empty());
}

TEST(PowerLines, ATowerWhereTwoWaysMeetFacesTheMeanOfBoth) {
  const Features f = towers_of("w1 -100:0 0:0 power=line\nw2 0:100 0:0 power=line");
  ASSERT_EQ(f.things.size(), 1u);
  const Vec2 along = f.things[0].way.along;
  EXPECT_NEAR(along.x, along.y, 1e-3);
}

}  // namespace
}  // namespace citykiln::map
