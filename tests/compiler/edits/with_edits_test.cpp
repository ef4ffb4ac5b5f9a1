#include "compiler/edits/with_edits.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "compiler/edits/parse_edits.h"
#include "compiler/source/read_osm.h"
#include "tests/scratch_folder.h"

namespace citykiln::edits {
namespace {

// A street with a crossing and a node without tags, two houses that share a wall, a wood with a clearing, and a tree.
constexpr std::string_view kTown = R"(<osm version="0.6">
<node id="1" lon="7.0000" lat="43.0000"/> <node id="2" lon="7.0010" lat="43.0000"><tag k="highway" v="crossing"/></node>
<node id="3" lon="7.0020" lat="43.0000"/>
<node id="11" lon="7.0000" lat="43.0010"/> <node id="12" lon="7.0001" lat="43.0010"/>
<node id="13" lon="7.0001" lat="43.0011"/> <node id="14" lon="7.0000" lat="43.0011"/>
<node id="15" lon="7.0002" lat="43.0010"/> <node id="16" lon="7.0002" lat="43.0011"/>
<node id="21" lon="7.0100" lat="43.0100"/> <node id="22" lon="7.0110" lat="43.0100"/>
<node id="23" lon="7.0110" lat="43.0110"/> <node id="24" lon="7.0100" lat="43.0110"/>
<node id="31" lon="7.0103" lat="43.0103"/> <node id="32" lon="7.0105" lat="43.0103"/> <node id="33" lon="7.0105" lat="43.0105"/>
<node id="99" lon="7.0050" lat="43.0050"><tag k="natural" v="tree"/></node>
<way id="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><tag k="highway" v="residential"/><tag k="name" v="Rue"/></way>
<way id="10"><nd ref="11"/><nd ref="12"/><nd ref="13"/><nd ref="14"/><nd ref="11"/><tag k="building" v="house"/></way>
<way id="11"><nd ref="12"/><nd ref="15"/><nd ref="16"/><nd ref="13"/><nd ref="12"/><tag k="building" v="garage"/><tag k="height" v="3"/></way>
<way id="20"><nd ref="21"/><nd ref="22"/><nd ref="23"/><nd ref="24"/><nd ref="21"/></way>
<way id="30"><nd ref="31"/><nd ref="32"/><nd ref="33"/><nd ref="31"/></way>
<relation id="5"><member type="way" ref="20" role="outer"/><member type="way" ref="30" role="inner"/>
 <tag k="type" v="multipolygon"/><tag k="natural" v="wood"/></relation>
</osm>)";

source::OsmData town() {
  const ScratchFolder folder;
  const std::string path = folder.at("town.osm");
  std::ofstream(path) << kTown;
  Report report;
  return *source::read_osm(path, 1, report);
}

struct Outcome {
  source::OsmData map;
  Report report;
};

Outcome edited(const std::string& text) {
  Outcome outcome;
  const Edits edits = *parse_edits(text, "town.edits");
  EditedMap map = with_edits(town(), edits, outcome.report);
  report_lines(edits, map.had_effect, outcome.report);
  outcome.map = std::move(map.map);
  EXPECT_TRUE(outcome.report.balances());
  return outcome;
}

const source::Way* way_in(const source::OsmData& map, std::int64_t id) {
  const auto found = std::ranges::find(map.ways, id, &source::Way::id);
  return found == map.ways.end() ? nullptr : &*found;
}

const source::Area* area_in(const source::OsmData& map, OsmId id) {
  const auto found = std::ranges::find(map.areas, id, &source::Area::from);
  return found == map.areas.end() ? nullptr : &*found;
}

std::string tag_in(const source::OsmData& map, std::int64_t way, std::string_view key) {
  return std::string(map.value_of(way_in(map, way)->tags, key));
}

std::string points_of(const source::OsmData& map, OsmId area) {
  std::ostringstream text;
  for (const source::AreaRing& ring : map.rings_of(*area_in(map, area))) {
    for (const source::Location at : map.points_of(ring))
      text << at.lon_e7 - 70000000 << ":" << at.lat_e7 - 430000000 << " ";
    text << (ring.is_outer ? "outer " : "inner ");
  }
  return text.str();
}

constexpr OsmId kHouse{OsmType::kWay, 10}, kGarage{OsmType::kWay, 11}, kWood{OsmType::kRelation, 5};

TEST(WithEdits, SetsAndRemovesTagsOfElementsAndTheirAreas) {
  const source::OsmData map =
      edited("building=garage set building=house building:levels=2 zebra=yes remove height").map;
  EXPECT_EQ(tag_in(map, 11, "building"), "house");
  EXPECT_EQ(tag_in(map, 11, "height"), "");
  EXPECT_EQ(map.value_of(area_in(map, kGarage)->tags, "building:levels"), "2");
  EXPECT_EQ(map.value_of(area_in(map, kHouse)->tags, "building:levels"), "");
  EXPECT_EQ(tag_in(map, 1, "name"), "Rue");
  EXPECT_TRUE(std::ranges::is_sorted(map.strings));
  const auto tags = map.tags_of(area_in(map, kGarage)->tags);
  EXPECT_TRUE(std::ranges::is_sorted(tags, {}, &source::Tag::key));
}

TEST(WithEdits, DropsElementsAndTheirAreas) {
  const Outcome outcome = edited("w10,n99,r5 drop");
  EXPECT_EQ(way_in(outcome.map, 10), nullptr);
  EXPECT_EQ(area_in(outcome.map, kHouse), nullptr);
  EXPECT_EQ(area_in(outcome.map, kWood), nullptr);
  EXPECT_EQ(outcome.map.nodes.size(), 1U);
  EXPECT_NE(way_in(outcome.map, 20), nullptr);
  const Account& account = outcome.report.ledger().at("edits/element");
  EXPECT_EQ(account.in, 3U);
  EXPECT_EQ(account.dropped.at(Code::kDroppedByEdit), 3U);
}

TEST(WithEdits, WaysThroughADroppedNodeKeepTheirCourse) {
  const source::OsmData map = edited("n2 drop").map;
  EXPECT_EQ(way_in(map, 1)->nodes.count, 3U);
  EXPECT_EQ(map.nodes.size(), 1U);
}

TEST(WithEdits, ANodeMovesInAllWaysAndAreas) {
  const source::OsmData map = edited("w10 move 0,11.1132").map;
  EXPECT_EQ(points_of(map, kHouse), "0:11000 1000:11000 1000:12000 0:12000 outer ");
  EXPECT_EQ(points_of(map, kGarage), "1000:11000 2000:10000 2000:11000 1000:12000 outer ");
}

TEST(WithEdits, PlacesANode) {
  const source::OsmData map = edited("n13 place 7.0001,43.0015").map;
  EXPECT_EQ(points_of(map, kHouse), "0:10000 1000:10000 1000:15000 0:11000 outer ");
  EXPECT_EQ(map.way_nodes[way_in(map, 11)->nodes.first + 3].at.lat_e7, 430015000);
}

TEST(WithEdits, APlaceFarFromTheNodeHasNoEffect) {
  const Outcome outcome = edited("n13 place 7.1,43.0015");
  EXPECT_EQ(outcome.report.counts()[Code::kEditWithoutEffect], 1U);
}

TEST(WithEdits, MovesTheRingsOfRelations) {
  const source::OsmData map = edited("w30 move 0,11.1132").map;
  EXPECT_EQ(
      points_of(map, kWood),
      "100000:100000 110000:100000 110000:110000 100000:110000 outer 103000:104000 105000:106000 105000:104000 inner ");
}

TEST(WithEdits, MendsAreasWhoseRingsCrossAfterAMove) {
  const source::OsmData map = edited("n13 place 7.00005,43.0005").map;
  EXPECT_NE(area_in(map, kHouse), nullptr);
  for (const source::AreaRing& ring : map.rings_of(*area_in(map, kHouse))) EXPECT_GE(ring.points.count, 3U);
}

TEST(WithEdits, AClosedWayBecomesAnAreaByItsTagsAndIsNoneWithout) {
  EXPECT_EQ(area_in(town(), {OsmType::kWay, 20}), nullptr);
  const source::OsmData map = edited("w20 set natural=water\nw10 remove building").map;
  ASSERT_NE(area_in(map, {OsmType::kWay, 20}), nullptr);
  EXPECT_EQ(map.value_of(area_in(map, {OsmType::kWay, 20})->tags, "natural"), "water");
  EXPECT_EQ(area_in(map, kHouse), nullptr);
  EXPECT_TRUE(std::ranges::is_sorted(map.areas, {}, &source::Area::from));
}

TEST(WithEdits, NodesWithoutTagsCanBeTagged) {
  const source::OsmData map = edited("n3 set highway=turning_circle").map;
  const auto node = std::ranges::find(map.nodes, 3, &source::Node::id);
  ASSERT_NE(node, map.nodes.end());
  EXPECT_EQ(map.value_of(node->tags, "highway"), "turning_circle");
  EXPECT_EQ(node->at.lon_e7, 70020000);
  EXPECT_TRUE(std::ranges::is_sorted(map.nodes, {}, &source::Node::id));
}

TEST(WithEdits, AddsNodesLinesAndAreas) {
  const Outcome outcome = edited(
      "add n 7.003,43.003 natural=tree\nadd w n2 7.001,43.001 highway=footway\n"
      "add w 7.001,43.001 7.002,43.002 highway=footway\nadd a 7.003,43.004 7.003,43.003 7.004,43.003 building=yes");
  const source::OsmData& map = outcome.map;
  EXPECT_EQ(map.nodes.size(), 3U);
  EXPECT_EQ(map.ways.size(), town().ways.size() + 3);
  EXPECT_EQ(map.areas.size(), town().areas.size() + 1);
  std::vector<const source::Way*> footways;
  for (const source::Way& way : map.ways)
    if (map.value_of(way.tags, "highway") == "footway") footways.push_back(&way);
  ASSERT_EQ(footways.size(), 2U);
  if (map.nodes_of(*footways[0])[0].id != 2) std::swap(footways[0], footways[1]);
  EXPECT_EQ(map.nodes_of(*footways[0])[0].id, 2);
  EXPECT_EQ(map.nodes_of(*footways[0])[1].id, map.nodes_of(*footways[1])[0].id);
  EXPECT_EQ(outcome.report.ledger().at("edits/element").split, 4U);
  EXPECT_EQ(outcome.report.ledger().at("edits/line").out, 4U);
}

TEST(WithEdits, FiltersSeeTheMapAsItWasRead) {
  const source::OsmData map =
      edited("w11 set building=house\nbuilding=house set height=9\nadd n 7.1,43 a=b\na=b drop").map;
  EXPECT_EQ(tag_in(map, 10, "height"), "9");
  EXPECT_EQ(tag_in(map, 11, "height"), "3");
  EXPECT_EQ(map.nodes.size(), 3U);
}

TEST(WithEdits, LinesWithoutEffectAreFindingsWithTheirPlace) {
  const Outcome outcome = edited("w10 drop\n  w77 drop\nshop=bakery drop\nadd w n77 7,43 highway=path\n");
  std::vector<std::string> tags;
  for (const Diagnosis& diagnosis : outcome.report.diagnoses()) tags.push_back(diagnosis.tag);
  EXPECT_EQ(tags, (std::vector<std::string>{"town.edits:2:3", "town.edits:3:1", "town.edits:4:1"}));
  EXPECT_EQ(outcome.report.ledger().at("edits/line").out, 1U);
}

std::vector<std::int64_t> fitting(const std::string& filter) {
  const source::OsmData map = edited(filter + " set fits=yes").map;
  std::vector<std::int64_t> ids;
  for (const source::Node& node : map.nodes)
    if (map.value_of(node.tags, "fits") == "yes") ids.push_back(node.id);
  for (const source::Way& way : map.ways)
    if (map.value_of(way.tags, "fits") == "yes") ids.push_back(way.id);
  for (const source::Relation& relation : map.relations)
    if (map.value_of(relation.tags, "fits") == "yes") ids.push_back(relation.id);
  return ids;
}

using Ids = std::vector<std::int64_t>;

TEST(WithEdits, FiltersFitAsTheirPageSays) {
  EXPECT_EQ(fitting("building"), (Ids{10, 11}));
  EXPECT_EQ(fitting("building=*"), (Ids{10, 11}));
  EXPECT_EQ(fitting("building=house,garage"), (Ids{10, 11}));
  EXPECT_EQ(fitting("building!=house"), (Ids{11}));
  EXPECT_EQ(fitting("building=g*"), (Ids{11}));
  EXPECT_EQ(fitting("building=*use"), (Ids{10}));
  EXPECT_EQ(fitting("building=*ara*"), (Ids{11}));
  EXPECT_EQ(fitting("highway"), (Ids{2, 1}));
  EXPECT_EQ(fitting("n/highway"), (Ids{2}));
  EXPECT_EQ(fitting("wr/highway"), (Ids{1}));
  EXPECT_EQ(fitting("a/natural"), (Ids{5}));
  EXPECT_EQ(fitting("highway !n/highway"), (Ids{1}));
  EXPECT_EQ(fitting("building !height"), (Ids{10}));
  EXPECT_EQ(fitting("building box=7.00015,43,7.1,43.1"), (Ids{11}));
  EXPECT_EQ(fitting("natural near=7.005,43.005,5"), (Ids{99}));
  EXPECT_EQ(fitting("near=7.0104,43.0104,30"), (Ids{30, 5}));
  EXPECT_EQ(fitting("building=garage w10,w11"), (Ids{11}));
}

TEST(WithEdits, ARegionCountsWhatIsAddedInIt) {
  const Edits edits = *parse_edits("add n 7.003,43.003 natural=tree\nadd n 7.1,43.003 natural=tree", "a");
  Report report;
  report.limit_to({});
  with_edits(town(), edits, report, [](double lon, double) { return lon < 7.05; });
  EXPECT_TRUE(report.counts(edits.lines[0].added->id));
  EXPECT_FALSE(report.counts(edits.lines[1].added->id));
  EXPECT_EQ(report.ledger().at("edits/element").split, 1U);
}

}  // namespace
}  // namespace citykiln::edits
