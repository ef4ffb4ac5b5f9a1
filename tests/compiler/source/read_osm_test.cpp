#include "compiler/source/read_osm.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/compiler/source/extract_text.h"

namespace citykiln::source {
namespace {

// a square with a hole, a road and a signal; every line one element
constexpr const char* kLines[] = {
    R"(<node id="1" version="1" lon="0" lat="0"/>)",
    R"(<node id="2" version="1" lon="0.003" lat="0"/>)",
    R"(<node id="3" version="1" lon="0.003" lat="0.003"/>)",
    R"(<node id="4" version="1" lon="0" lat="0.003"/>)",
    R"(<node id="5" version="1" lon="0.001" lat="0.001"/>)",
    R"(<node id="6" version="1" lon="0.002" lat="0.001"/>)",
    R"(<node id="7" version="1" lon="0.002" lat="0.002"/>)",
    R"(<node id="8" version="1" lon="0.001" lat="0.002"><tag k="highway" v="traffic_signals"/></node>)",
    R"(<way id="10" version="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/></way>)",
    R"(<way id="11" version="1"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="5"/></way>)",
    R"(<way id="12" version="1"><nd ref="1"/><nd ref="8"/><tag k="highway" v="service"/><tag k="bridge" v="yes"/></way>)",
    R"(<relation id="20" version="1"><member type="way" ref="10" role="outer"/><member type="way" ref="11" role="inner"/>)"
    R"(<tag k="type" v="multipolygon"/><tag k="building" v="yes"/></relation>)",
};

std::string lines() { return fmt::format("{}", fmt::join(kLines, "\n")); }

std::string lines_backwards() {
  std::string text;
  for (auto line = std::rbegin(kLines); line != std::rend(kLines); ++line) text += fmt::format("{}\n", *line);
  return text;
}

double signed_area(std::span<const Location> ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Location a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += a.lon_deg() * b.lat_deg() - b.lon_deg() * a.lat_deg();
  }
  return sum / 2;
}

std::uint64_t count(const Report& report, Code code) {
  const auto counts = report.counts();
  const auto found = counts.find(code);
  return found == counts.end() ? 0 : found->second;
}

TEST(ReadOsm, UnsortedFileGivesTheDataOfTheSortedOne) {
  Report sorted_report, unsorted_report;
  EXPECT_EQ(text_of(read(lines(), sorted_report)), text_of(read(lines_backwards(), unsorted_report)));
  EXPECT_EQ(count(sorted_report, Code::kUnsortedFile), 0u);
  EXPECT_EQ(count(unsorted_report, Code::kUnsortedFile), 1u);
}

TEST(ReadOsm, OuterRingsRunCounterClockwiseAndInnerOnesClockwise) {
  Report report;
  const OsmData data = read(lines(), report);
  ASSERT_EQ(data.areas.size(), 1u);
  const auto rings = data.rings_of(data.areas[0]);
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_TRUE(rings[0].is_outer);
  EXPECT_GT(signed_area(data.points_of(rings[0])), 0);
  EXPECT_FALSE(rings[1].is_outer);
  EXPECT_LT(signed_area(data.points_of(rings[1])), 0);
  EXPECT_EQ(rings[1].part, rings[0].part);
}

TEST(ReadOsm, LastPointOfARingIsNotRepeated) {
  Report report;
  const OsmData data = read(lines(), report);
  ASSERT_EQ(data.rings.size(), 2u);
  for (const AreaRing& ring : data.rings) EXPECT_EQ(ring.points.count, 4u);
}

TEST(ReadOsm, TagsAreSortedByKeyAndFoundByKey) {
  Report report;
  const OsmData data = read(lines(), report);
  const Way& road = data.ways[2];
  ASSERT_EQ(data.tags_of(road.tags).size(), 2u);
  EXPECT_EQ(data.strings[data.tags_of(road.tags)[0].key], "bridge");
  EXPECT_EQ(data.value_of(road.tags, "highway"), "service");
  EXPECT_EQ(data.value_of(road.tags, "layer"), "");
  EXPECT_TRUE(std::is_sorted(data.strings.begin(), data.strings.end()));
}

TEST(ReadOsm, TypeIsNotATagOfTheArea) {
  Report report;
  const OsmData data = read(lines(), report);
  EXPECT_EQ(data.value_of(data.areas[0].tags, "type"), "");
  EXPECT_EQ(data.value_of(data.areas[0].tags, "building"), "yes");
  EXPECT_EQ(data.value_of(data.relations[0].tags, "type"), "multipolygon");
}

TEST(ReadOsm, KeepsTheHighestVersionOfDuplicates) {
  const std::string first = R"(<node id="1" version="1" lon="1" lat="1"><tag k="name" v="old"/></node>)";
  const std::string second = R"(<node id="1" version="2" lon="2" lat="2"><tag k="name" v="new"/></node>)";
  for (const std::string& text : {first + second, second + first}) {
    Report report;
    const OsmData data = read(text, report);
    ASSERT_EQ(data.nodes.size(), 1u);
    EXPECT_EQ(data.value_of(data.nodes[0].tags, "name"), "new");
    EXPECT_EQ(count(report, Code::kDuplicateElement), 1u);
    EXPECT_TRUE(report.balances());
  }
}

TEST(ReadOsm, ChoiceBetweenEqualVersionsDoesNotDependOnOrder) {
  const std::string first = R"(<node id="1" version="1" lon="1" lat="1"><tag k="name" v="a"/></node>)";
  const std::string second = R"(<node id="1" version="1" lon="1" lat="1"><tag k="name" v="b"/></node>)";
  Report report;
  EXPECT_EQ(text_of(read(first + second, report)), text_of(read(second + first, report)));
}

TEST(ReadOsm, DeletedElementsAreDropped) {
  Report report;
  const OsmData data = read(R"(<node id="1" version="2" visible="false"/>
    <node id="1" version="1" visible="true" lon="1" lat="1"><tag k="name" v="gone"/></node>)",
                            report);
  EXPECT_TRUE(data.nodes.empty());
  EXPECT_EQ(count(report, Code::kDeletedElement), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(ReadOsm, NodesWithoutAPlaceAreDropped) {
  Report report;
  const OsmData data = read(R"(<node id="1" version="1"><tag k="name" v="nowhere"/></node>)", report);
  EXPECT_TRUE(data.nodes.empty());
  EXPECT_EQ(count(report, Code::kNodeWithoutPlace), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(ReadOsm, MissingNodesAreLeftOutOfTheWay) {
  Report report;
  const OsmData data = read(R"(<node id="1" version="1" lon="0" lat="0"/><node id="3" version="1" lon="1" lat="0"/>
    <way id="10" version="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><tag k="highway" v="path"/></way>
    <way id="11" version="1"><nd ref="2"/><nd ref="3"/></way>)",
                            report);
  ASSERT_EQ(data.ways.size(), 1u);
  EXPECT_EQ(data.nodes_of(data.ways[0]).size(), 2u);
  EXPECT_EQ(size_sum(report, Code::kMissingNode), 3);
  EXPECT_EQ(count(report, Code::kWayTooShort), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(ReadOsm, ClosedWayIsClosedAroundItsMissingNodes) {
  Report report;
  const OsmData data = read(R"(<node id="2" version="1" lon="1" lat="0"/><node id="3" version="1" lon="1" lat="1"/>
    <node id="4" version="1" lon="0" lat="1"/>
    <way id="10" version="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="yes"/></way>)",
                            report);
  ASSERT_EQ(data.areas.size(), 1u);
  EXPECT_EQ(data.rings[0].points.count, 3u);
}

TEST(ReadOsm, HolesOfAMissingOuterRingDoNotBecomeAreas) {
  Report report;
  std::string text = lines();
  const std::size_t outer = text.find("<way id=\"10\"");
  text.erase(outer, text.find('\n', outer) - outer);
  const OsmData data = read(text, report);
  EXPECT_TRUE(data.areas.empty());
  EXPECT_EQ(count(report, Code::kMissingMember), 1u);
  EXPECT_EQ(count(report, Code::kIncompleteArea), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(ReadOsm, SelfCrossingAreaIsMendedAndDiagnosed) {
  Report report;
  const OsmData data = read(R"(<node id="1" version="1" lon="0" lat="0"/><node id="2" version="1" lon="1" lat="1"/>
    <node id="3" version="1" lon="1" lat="0"/><node id="4" version="1" lon="0" lat="1"/>
    <way id="10" version="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="yes"/></way>)",
                            report);
  ASSERT_EQ(data.areas.size(), 1u);
  EXPECT_EQ(data.areas[0].rings.count, 2u);
  EXPECT_EQ(data.ways.size(), 1u);
  EXPECT_EQ(count(report, Code::kAreaMended), 1u);
  EXPECT_EQ(report.ledger().at("source/area").in, 1u);
  EXPECT_TRUE(report.balances());
}

TEST(ReadOsm, OldMultipolygonTakesTheTagsOfItsOuterWay) {
  Report report;
  std::string text = lines();
  const std::string tag = R"(<tag k="building" v="yes"/>)";
  text.erase(text.find(tag), tag.size());
  const std::size_t end_of_outer = text.find("</way>", text.find("<way id=\"10\""));
  text.insert(end_of_outer, tag);
  const OsmData data = read(text, report);
  ASSERT_EQ(data.areas.size(), 1u);
  EXPECT_EQ(data.areas[0].from, (OsmId{OsmType::kRelation, 20}));
  EXPECT_EQ(data.value_of(data.areas[0].tags, "building"), "yes");
  EXPECT_EQ(report.ledger().at("source/area").merged, 1u);
  EXPECT_TRUE(report.balances());
}

TEST(ReadOsm, NegativeIdsAreSortedAsNumbers) {
  Report report;
  const OsmData data = read(
      R"(<node id="-1" lon="1" lat="1"><tag k="a" v="b"/></node><node id="-2" lon="1" lat="2"><tag k="a" v="b"/></node>)",
      report);
  ASSERT_EQ(data.nodes.size(), 2u);
  EXPECT_EQ(data.nodes[0].id, -2);
  EXPECT_EQ(count(report, Code::kUnsortedFile), 0u);
}

TEST(ReadOsm, EmptyMapIsNoError) {
  Report report;
  const OsmData data = read("", report);
  EXPECT_TRUE(data.nodes.empty() && data.ways.empty() && data.areas.empty() && data.relations.empty());
  EXPECT_EQ(data.node_box, LonLatBox{});
  EXPECT_FALSE(data.header_box);
}

TEST(ReadOsm, HeaderBoxIsTheBoundsElement) {
  Report report;
  const OsmData data = read(R"(<bounds minlon="1" minlat="2" maxlon="3" maxlat="4"/>)", report);
  EXPECT_EQ(data.header_box, (LonLatBox{1, 2, 3, 4}));
}

std::string osm_error_of(const std::string& name, std::string_view bytes) {
  const ScratchFolder folder;
  const std::string path = folder.write(name, bytes);
  Report report;
  const Result<OsmData> data = read_osm(path, 1, report);
  if (data) return "no error";
  const std::string line = to_string(data.error());
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_TRUE(line.starts_with(path)) << line;
  return line.substr(path.size());
}

TEST(ReadOsmErrors, MissingFile) {
  Report report;
  const Result<OsmData> data = read_osm("/nowhere/town.osm", 1, report);
  ASSERT_FALSE(data);
  EXPECT_EQ(to_string(data.error()), "/nowhere/town.osm: no such file");
}

TEST(ReadOsmErrors, Folder) {
  Report report;
  const Result<OsmData> data = read_osm("/tmp", 1, report);
  ASSERT_FALSE(data);
  EXPECT_EQ(to_string(data.error()), "/tmp: not a file");
}

TEST(ReadOsmErrors, EmptyFile) {
  for (const char* name : {"a.osm", "a.osm.pbf", "a.osm.gz", "a.osm.bz2"})
    EXPECT_EQ(osm_error_of(name, ""), ": the file is empty");
}

TEST(ReadOsmErrors, XmlCutInTheMiddleNamesLineAndColumn) {
  const std::string whole = osm(lines());
  EXPECT_EQ(osm_error_of("a.osm", whole.substr(0, whole.size() / 2)),
            ":11:1: malformed XML: unclosed token; the file is cut off: load it again");
}

TEST(ReadOsmErrors, XmlCutAnywhereIsAnError) {
  const std::string whole = osm(lines());
  for (std::size_t size = 1; size + 8 < whole.size(); size += 7) {
    EXPECT_NE(osm_error_of("a.osm", whole.substr(0, size)), "no error") << size;
  }
}

TEST(ReadOsmErrors, XmlThatIsNotOsm) {
  EXPECT_EQ(osm_error_of("a.osm", "<gpx version=\"1.1\"></gpx>"), ": Unknown top-level element: gpx");
}

TEST(ReadOsmErrors, MalformedNumbers) {
  EXPECT_NE(osm_error_of("a.osm", osm(R"(<node id="x" version="1" lon="0" lat="0"/>)")), "no error");
  EXPECT_NE(osm_error_of("a.osm", osm(R"(<node id="1" version="1" lon="east" lat="0"/>)")), "no error");
}

TEST(ReadOsmErrors, TextNamedPbf) {
  EXPECT_EQ(osm_error_of("a.osm.pbf", "Dear reader, this is no map."),
            ": expected OSM PBF data as the file's name says, found something else");
  EXPECT_EQ(osm_error_of("a.osm.pbf", osm(lines())), ": expected OSM PBF data as the file's name says, found XML");
}

TEST(ReadOsmErrors, XmlNamedCompressed) {
  EXPECT_EQ(osm_error_of("a.osm.gz", osm(lines())), ": expected gzip data as the file's name says, found XML");
  EXPECT_EQ(osm_error_of("a.osm.bz2", osm(lines())), ": expected bzip2 data as the file's name says, found XML");
}

TEST(ReadOsmErrors, UnknownSuffix) {
  EXPECT_EQ(osm_error_of("a.txt", osm(lines())), ": unknown suffix; expected .osm, .osm.gz, .osm.bz2 or .osm.pbf");
}

// ---- of two descriptions the richer one

constexpr const char* kSquare =
    R"(<node id="1" lon="0" lat="0"/><node id="2" lon="0.003" lat="0"/><node id="3" lon="0.003" lat="0.003"/>)"
    R"(<node id="4" lon="0" lat="0.003"/><node id="5" lon="0.001" lat="0.001"/><node id="6" lon="0.002" lat="0.001"/>)"
    R"(<node id="7" lon="0.002" lat="0.002"/><node id="8" lon="0.001" lat="0.002"/>)";

std::string outer_way(std::string_view tags) {
  return fmt::format(R"(<way id="10"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/>{}</way>)", tags);
}

std::string with_hole(std::string_view outer_tags, std::string_view relation_tags) {
  return kSquare + outer_way(outer_tags) +
         R"(<way id="11"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="5"/></way>)" +
         fmt::format(R"(<relation id="20"><member type="way" ref="10" role="outer"/><member type="way" ref="11" )"
                     R"(role="inner"/><tag k="type" v="multipolygon"/>{}</relation>)",
                     relation_tags);
}

TEST(ReadOsm, OfAnElementThatOccursTwiceTheOneWithTagsIsKept) {
  const std::string house = R"(<tag k="building" v="house"/><tag k="name" v="a name that is long"/>)";
  const std::string tree = R"(<node id="9" lon="0.001" lat="0.001"><tag k="natural" v="tree"/></node>)";
  const std::string bare = R"(<node id="9" lon="0.001" lat="0.001"/>)";
  for (const bool tagged_first : {true, false}) {
    Report report;
    const std::string ways = tagged_first ? outer_way(house) + outer_way("") : outer_way("") + outer_way(house);
    const OsmData data = read(kSquare + (tagged_first ? tree + bare : bare + tree) + ways, report);
    ASSERT_EQ(data.ways.size(), 1u);
    EXPECT_EQ(data.value_of(data.ways[0].tags, "building"), "house");
    EXPECT_EQ(data.nodes.size(), 1u);
    EXPECT_EQ(count(report, Code::kDuplicateElement), 2u);
    EXPECT_TRUE(report.balances());
  }
}

TEST(ReadOsm, AHigherVersionIsKeptEvenIfItSaysLess) {
  Report report;
  const OsmData data =
      read(std::string(kSquare) + R"(<node id="9" version="1" lon="0" lat="0"><tag k="natural" v="tree"/></node>)"
                                  R"(<node id="9" version="2" lon="0" lat="0"/>)",
           report);
  EXPECT_EQ(data.nodes.size(), 0u);
}

TEST(ReadOsm, AWayAndAMultipolygonOfItThatAreOneThingAreOneArea) {
  const std::string water = R"(<tag k="natural" v="water"/>)", reservoir = R"(<tag k="landuse" v="reservoir"/>)";
  const std::string flats = R"(<tag k="building" v="apartments"/><tag k="height" v="12"/>)",
                    building = R"(<tag k="building" v="yes"/>)";
  for (const auto& [way, relation] :
       {std::pair(water, water), std::pair(reservoir, water), std::pair(flats, building)}) {
    Report report;
    const OsmData data = read(with_hole(way, relation), report);
    ASSERT_EQ(data.areas.size(), 1u) << way;
    EXPECT_EQ(data.areas[0].from, (OsmId{OsmType::kRelation, 20}));
    EXPECT_EQ(data.rings_of(data.areas[0]).size(), 2u);
    EXPECT_EQ(report.account("source", "area").merged, 1u);
    EXPECT_TRUE(report.balances());
    if (way == flats) {
      EXPECT_EQ(data.value_of(data.areas[0].tags, "height"), "12");
    }
  }
}

TEST(ReadOsm, AWayAndAMultipolygonThatAreTwoThingsAreTwoAreas) {
  Report report;
  const OsmData data =
      read(with_hole(R"(<tag k="landuse" v="residential"/>)", R"(<tag k="natural" v="wood"/>)"), report);
  EXPECT_EQ(data.areas.size(), 2u);
}

TEST(ReadOsm, AnIslandThatIsARelationIsAHoleOfItsLake) {
  const std::string island =
      R"(<way id="11"><nd ref="5"/><nd ref="6"/><nd ref="7"/></way><way id="12"><nd ref="7"/><nd ref="8"/><nd ref="5"/></way>)"
      R"(<relation id="20"><member type="way" ref="11" role="outer"/><member type="way" ref="12" role="outer"/>)"
      R"(<tag k="type" v="multipolygon"/><tag k="place" v="island"/></relation>)";
  const std::string lake =
      R"(<relation id="21"><member type="way" ref="10" role="outer"/><member type="relation" ref="20" role="inner"/>)"
      R"(<tag k="type" v="multipolygon"/><tag k="natural" v="water"/></relation>)";
  Report report;
  const OsmData data = read(kSquare + outer_way("") + island + lake, report);
  ASSERT_EQ(data.areas.size(), 2u);
  ASSERT_EQ(data.areas[1].rings.count, 2u);
  EXPECT_FALSE(data.rings_of(data.areas[1])[1].is_outer);
  EXPECT_TRUE(report.balances());
}

// ---- files that hold no map

std::string error_of_file(const std::string& name, const std::string& bytes) {
  const ScratchFolder folder;
  Report report;
  const Result<OsmData> data = read_osm(folder.write(name, bytes), 1, report);
  return data ? "no error" : data.error().message;
}

TEST(ReadOsm, AnswersWithoutNodesSayWhichQueryGivesThem) {
  std::string ways;
  for (int id = 1; id < 4; ++id)
    ways += fmt::format(R"(<way id="{}"><center lat="48" lon="11"/><nd ref="1"/><nd ref="2"/><tag k="a" v="b"/></way>)",
                        id);
  EXPECT_NE(error_of_file("a.osm", osm(ways)).find("out geom;"), std::string::npos);
  EXPECT_NE(error_of_file("a.osm", osm(R"(<node id="9" lat="48" lon="11"><tag k="a" v="b"/></node>)" + ways))
                .find("out center"),
            std::string::npos);
}

TEST(ReadOsm, ChangeFilesAreNamedAsSuch) {
  const std::string changes =
      R"(<osmChange version="0.6"><create><node id="1" lat="48" lon="11"/></create></osmChange>)";
  for (const char* name : {"a.osc", "a.osm", "a.osc.gz"})
    EXPECT_NE(error_of_file(name, changes).find("holds changes of a map"), std::string::npos) << name;
}

}  // namespace
}  // namespace citykiln::source
