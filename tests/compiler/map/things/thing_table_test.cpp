#include "compiler/map/things/thing_table.h"

#include <gtest/gtest.h>

#include <map>

#include "compiler/map/things/locate_things.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

constexpr std::string_view kTable = R"(
# comments and empty lines count as lines

bench   amenity=bench                               bench 1.8x0.6x0.8     ground street 0.5 size Bench  # a comment
post    barrier=bollard|barrier=block               post  0.2x0.2xheight:0.9 in_way along 0 1.5 Bollard
shelter amenity=shelter&shelter_type=bus&covered!=no shelter 3x1.5x2.4    ground platform 1 size Shelter
speed   traffic_sign=maxspeed*|traffic_sign=*274*   sign 0.6x0.1x2.7          pole  along 0   size  Sign
any     tourism=*                                   board 1x0.1x2         wall  any   0   size  Board
)";

ThingTable table() {
  const Result<ThingTable> table = read_thing_table(kTable, "things.txt");
  EXPECT_TRUE(table) << to_string(table.error());
  return *table;
}

// The row and the value of a node with these tags; "" if no row fits.
std::string name_of(const std::string& tags) {
  const ThingTable rows = table();
  Options options;
  options.things = &rows;
  Report report;
  const Features features =
      locate(MapText("n1 0:0 " + tags).take(), Plane(kTestOrigin), box_around(500), options, report);
  return features.things.empty() ? "" : features.things[0].kind + ":" + features.things[0].value;
}

std::string error_of(const std::string& row) {
  const Result<ThingTable> table = read_thing_table("# first\n" + row, "own/things.txt");
  return table ? "" : to_string(table.error());
}

TEST(ThingTable, ColumnsAreRead) {
  const ThingTable rows = table();
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0].rule, "bench");
  EXPECT_EQ(rows[0].depth.default_m, 0.6);
  EXPECT_EQ(rows[0].clear_m, 0.5);
  EXPECT_FALSE(rows[0].detail_m);
  EXPECT_EQ(rows[1].height.key, "height");
  EXPECT_EQ(rows[1].height.default_m, 0.9);
  EXPECT_EQ(rows[1].stand, Stand::kInWay);
  EXPECT_EQ(rows[1].detail_m, 1.5);
  EXPECT_EQ(rows[2].facing, Facing::kPlatform);
  EXPECT_EQ(rows[4].class_name, "Board");
}

TEST(ThingTable, TheFirstRowThatFitsCounts) {
  EXPECT_EQ(name_of("amenity=bench tourism=artwork"), "bench:bench");
  EXPECT_EQ(name_of("barrier=block"), "post:block");
  EXPECT_EQ(name_of("amenity=waste_basket;bench"), "bench:waste_basket;bench");
  EXPECT_EQ(name_of("amenity=shelter"), "");
  EXPECT_EQ(name_of("amenity=shelter shelter_type=bus"), "shelter:shelter");
  EXPECT_EQ(name_of("amenity=shelter shelter_type=bus covered=no"), "");
  EXPECT_EQ(name_of("tourism=artwork"), "any:artwork");
  EXPECT_EQ(name_of("traffic_sign=maxspeed:30"), "speed:maxspeed:30");
  EXPECT_EQ(name_of("traffic_sign=DE:274-50"), "speed:DE:274-50");
  EXPECT_EQ(name_of("traffic_sign=DE:205"), "");
  EXPECT_EQ(name_of("tourism=no"), "");
}

TEST(ThingTable, ABadRowIsOneLineWithFileAndLine) {
  EXPECT_EQ(
      error_of("a b=c d 1x1x1 ground any 0 size"),
      "own/things.txt:2: expected 9 columns (name, tags, rule, size, stands, faces, clears, detail, class), found 8");
  EXPECT_EQ(
      error_of("a b=c d 1x1 ground any 0 size A"),
      "own/things.txt:2: size: expected width x depth x height in metres, such as 1.6x0.5x0.8 or 0.3x0.3xheight:4, "
      "found \"1x1\"");
  EXPECT_EQ(error_of("a b=c d 1x1x0 ground any 0 size A").substr(0, 24), "own/things.txt:2: size: ");
  EXPECT_EQ(error_of("a b d 1x1x1 ground any 0 size A").substr(0, 24), "own/things.txt:2: tags: ");
  EXPECT_EQ(error_of("a b=c d 1x1x1 floor any 0 size A"),
            "own/things.txt:2: stands: expected ground, pole, wall, over_road, in_way, on_roof, through_roof, found "
            "\"floor\"");
  EXPECT_EQ(error_of("a b=c d 1x1x1 ground up 0 size A").substr(0, 25), "own/things.txt:2: faces: ");
  EXPECT_EQ(error_of("a b=c d 1x1x1 ground any -1 size A").substr(0, 26), "own/things.txt:2: clears: ");
  EXPECT_EQ(error_of("a b=c d 1x1x1 ground any 0 big A").substr(0, 26), "own/things.txt:2: detail: ");
  EXPECT_EQ(error_of("a b=c d 1x1x1 ground any 0 size A\na b=c d 1x1x1 ground any 0 size A"),
            "own/things.txt:3: the name \"a\" is used twice");
}

TEST(ThingTable, OwnRowsComeFirstAndReplaceThoseOfTheirName) {
  const ThingTable own = *read_thing_table("post a=b x 1x1x1 ground any 0 size P", "own");
  const ThingTable all = merged(own, table());
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[0].rule, "x");
  EXPECT_EQ(all[1].name, "bench");
}

TEST(LocateThings, NodesOfAWayKnowItAndItsDirection) {
  const ThingTable rows = table();
  Options options;
  options.things = &rows;
  Report report;
  source::OsmData osm = MapText(R"(
    n1 50:0 barrier=bollard direction=backward height=1.2
    n2 10:9 amenity=bench direction=SW colour=red
    n3 95:0 amenity=bench
    n4 9000:0 amenity=bench
    n5 9:0 natural=tree amenity=bench
    w1 10:0 50:0 90:0 highway=residential)")
                            .take();
  // nodes of ways have other ids in a MapText
  for (source::NodeRef& node : osm.way_nodes)
    if (node.at == osm.nodes[0].at) node.id = 1;
  const Features features = locate(osm, Plane(kTestOrigin), box_around(500), options, report);
  ASSERT_EQ(features.things.size(), 3u);
  const ThingFeature &bollard = features.things[0], &bench = features.things[1];
  EXPECT_EQ(bollard.kind, "post");
  EXPECT_EQ(bollard.height_m, 1.2001953125);
  EXPECT_EQ(bollard.facing, -1);
  EXPECT_EQ(bollard.way.id.osm.id, 1);
  EXPECT_NEAR(bollard.way.along.x, 1, 1e-6);
  EXPECT_TRUE(bollard.is_in_way);
  EXPECT_EQ(bench.bearing_deg, 225);
  EXPECT_EQ(bench.colour, (Srgb{0xb2, 0x32, 0x28}));
  EXPECT_EQ(bench.way.id.osm.type, OsmType::kNone);
  EXPECT_EQ(report.account("map", "thing").dropped.at(Code::kOutsideBounds), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(LocateThings, LinesAndAreasAreThings) {
  const ThingTable rows = table();
  Options options;
  options.things = &rows;
  Report report;
  const source::OsmData osm = MapText(R"(
    w1 10:0 16:0 barrier=bollard
    w2 30:0 33:0 amenity=bench
    w3 40:0 43:0 43:1 40:1 40:0 amenity=bench
    w4 60:0 72:0 72:9 60:9 60:0 building=yes amenity=bench
    a4 60:0 72:0 72:9 60:9 building=yes amenity=bench)")
                                  .take();
  const Features features = locate(osm, Plane(kTestOrigin), box_around(500), options, report);
  std::map<std::int64_t, int> things;
  for (const ThingFeature& thing : features.things) {
    ++things[thing.id.osm.id];
    EXPECT_TRUE(thing.along);
  }
  EXPECT_EQ(things, (std::map<std::int64_t, int>{{1, 4}, {2, 1}, {3, 1}})) << "way 4 is a building";
  EXPECT_TRUE(report.balances());
  EXPECT_EQ(report.account("map", "thing").split, 3u);
}

TEST(LocateThings, DigitsAreThoseOfTheSpeedElseOfTheSign) {
  EXPECT_EQ(digits_of("50", ""), "50");
  EXPECT_EQ(digits_of("30 mph", "DE:274-50"), "30");
  EXPECT_EQ(digits_of("", "DE:274[60]"), "60");
  EXPECT_EQ(digits_of("", "DE:274-50"), "50");
  EXPECT_EQ(digits_of("none", ""), "");
  EXPECT_EQ(digits_of("", "stop"), "");
  EXPECT_EQ(digits_of("123456", ""), "");
}

}  // namespace
}  // namespace citykiln::map
