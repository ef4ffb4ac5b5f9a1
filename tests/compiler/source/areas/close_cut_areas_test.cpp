#include "compiler/source/areas/close_cut_areas.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/compiler/source/extract_text.h"

namespace citykiln::source {
namespace {

constexpr const char* kWaterTag = R"(<tag k="natural" v="water"/>)";
constexpr const char* kRiverTags = R"(<tag k="natural" v="water"/><tag k="water" v="river"/>)";
constexpr const char* kRoadTag = R"(<tag k="highway" v="residential"/>)";
constexpr const char* kHouseTag = R"(<tag k="building" v="yes"/>)";

struct Place {
  int x, y;
};
using Places = std::vector<Place>;

struct SketchMember {
  Places line;  // empty: the member is missing
  bool is_inner = false;
};

// A map of 100 x 100 units of 0.0001° at the equator, turned by quarters and then mirrored.
struct Sketch {
  int quarters = 0;
  bool mirrored = false;
  bool has_box = true;
  std::string nodes, ways;
  int last_id = 0;

  Location location(Place at) const {
    for (int i = 0; i < quarters; ++i) at = {100 - at.y, at.x};
    if (mirrored) at.x = 100 - at.x;
    return {100000000 + at.x * 1000, at.y * 1000};
  }

  // Nodes are shared by place, so that lines meet.
  int add(const Places& line, const std::string& tags = "") {
    const int id = ++last_id;
    std::string refs;
    for (const Place at : line) {
      const int node = 1000000 + (at.x + 500) * 1000 + at.y + 500;
      const Location place = location(at);
      nodes += fmt::format(R"(<node id="{}" version="1" lon="{:.7f}" lat="{:.7f}"/>)", node, place.lon_deg(),
                           place.lat_deg());
      refs += fmt::format(R"(<nd ref="{}"/>)", node);
    }
    ways += fmt::format(R"(<way id="{}" version="1">{}{}</way>)", id, refs, tags);
    return id;
  }

  void house(Place at) { add({at, {at.x + 2, at.y}, {at.x + 2, at.y + 2}, {at.x, at.y + 2}, at}, kHouseTag); }

  std::string area(const std::vector<SketchMember>& members, const std::string& tags) {
    std::string text;
    int missing = 900;
    for (const SketchMember& member : members)
      text += fmt::format(R"(<member type="way" ref="{}" role="{}"/>)",
                          member.line.empty() ? ++missing : add(member.line), member.is_inner ? "inner" : "outer");
    return fmt::format(R"(<relation id="7" version="1">{}<tag k="type" v="multipolygon"/>{}</relation>)", text, tags);
  }

  OsmData read_with(const std::string& relation, Report& report) const {
    const char* bounds = R"(<bounds minlon="10" minlat="0" maxlon="10.01" maxlat="0.01"/>)";
    return read((has_box ? bounds : "") + nodes + ways + relation, report);
  }
};

const Area* area_in(const OsmData& data) {
  const auto found =
      std::ranges::find_if(data.areas, [](const Area& area) { return area.from.type == OsmType::kRelation; });
  return found == data.areas.end() ? nullptr : &*found;
}

bool crosses_left_of(Location a, Location b, Location at) {
  if ((a.lat_e7 > at.lat_e7) == (b.lat_e7 > at.lat_e7)) return false;
  const double t = (double{1} * at.lat_e7 - a.lat_e7) / (double{1} * b.lat_e7 - a.lat_e7);
  return a.lon_e7 + t * (double{1} * b.lon_e7 - a.lon_e7) < at.lon_e7;
}

bool holds(const OsmData& data, Location at) {
  const Area* area = area_in(data);
  bool is_inside = false;
  if (!area) return false;
  for (const AreaRing& ring : data.rings_of(*area)) {
    const auto points = data.points_of(ring);
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
      is_inside ^= crosses_left_of(points[j], points[i], at);
  }
  return is_inside;
}

std::vector<Location> points_of_area(const OsmData& data) {
  std::vector<Location> points;
  if (const Area* area = area_in(data))
    for (const AreaRing& ring : data.rings_of(*area))
      points.insert(points.end(), data.points_of(ring).begin(), data.points_of(ring).end());
  return points;
}

std::uint64_t count_of(const Report& report, Code code) {
  const auto counts = report.counts();
  const auto found = counts.find(code);
  return found == counts.end() ? 0 : found->second;
}

void expect_diagnosed_only(const OsmData& data, const Report& report) {
  EXPECT_FALSE(area_in(data));
  EXPECT_EQ(count_of(report, Code::kIncompleteArea), 1u);
  EXPECT_EQ(count_of(report, Code::kAreaClosed), 0u);
  EXPECT_TRUE(report.balances());
}

const Places kShore = {{-10, 60}, {50, 40}, {110, 60}};

TEST(CloseCutAreas, ALakeCutOnOneSideLiesOppositeTheRoad) {
  Sketch map;
  map.add({{1, 20}, {99, 20}}, kRoadTag);
  Report report;
  const OsmData data = map.read_with(map.area({{kShore}, {}}, kWaterTag), report);
  EXPECT_TRUE(holds(data, map.location({50, 80})));
  EXPECT_FALSE(holds(data, map.location({50, 20})));
  EXPECT_EQ(count_of(report, Code::kAreaClosed), 1u);
  EXPECT_EQ(size_sum(report, Code::kAreaClosed), 0.5);
  EXPECT_EQ(count_of(report, Code::kIncompleteArea), 0u);
  EXPECT_TRUE(report.balances());
}

TEST(CloseCutAreas, TheAreaIsClosedOutOfSightOfTheBox) {
  Sketch map;
  map.house({50, 10});
  Report report;
  const OsmData data = map.read_with(map.area({{kShore}, {}}, kWaterTag), report);
  EXPECT_TRUE(holds(data, map.location({-20, 80})));
  EXPECT_TRUE(holds(data, map.location({50, 140})));
  EXPECT_FALSE(holds(data, map.location({50, 160})));
}

TEST(CloseCutAreas, ALakeCutOnTwoOppositeSidesLiesBetweenTheHouses) {
  Sketch map;
  map.house({50, 10});
  map.house({50, 90});
  Report report;
  const OsmData data =
      map.read_with(map.area({{{{-5, 25}, {105, 30}}}, {}, {{{-5, 75}, {105, 70}}}, {}}, kWaterTag), report);
  EXPECT_TRUE(holds(data, map.location({50, 50})));
  EXPECT_FALSE(holds(data, map.location({50, 10})));
  EXPECT_FALSE(holds(data, map.location({50, 90})));
}

TEST(CloseCutAreas, IslandsStayHoles) {
  Sketch map;
  map.house({49, 69});
  Report report;
  const Places island = {{40, 60}, {60, 60}, {60, 80}, {40, 80}, {40, 60}};
  const OsmData data = map.read_with(map.area({{kShore}, {}, {island, true}}, kWaterTag), report);
  ASSERT_TRUE(area_in(data));
  EXPECT_EQ(area_in(data)->rings.count, 2u);
  EXPECT_TRUE(holds(data, map.location({50, 90})));
  EXPECT_FALSE(holds(data, map.location({50, 70})));
  EXPECT_FALSE(holds(data, map.location({50, 20})));
}

TEST(CloseCutAreas, AnIslandCutByTheBoxSaysWhereTheLakeIs) {
  Sketch map;
  Report report;
  const OsmData data =
      map.read_with(map.area({{kShore}, {}, {{{40, 105}, {50, 80}, {60, 105}}, true}, {{}, true}}, kWaterTag), report);
  EXPECT_TRUE(holds(data, map.location({20, 80})));
  EXPECT_FALSE(holds(data, map.location({50, 95})));
  EXPECT_FALSE(holds(data, map.location({50, 20})));
}

TEST(CloseCutAreas, AMapInALakeWithOneIslandIsWaterAroundIt) {
  Sketch map;
  Report report;
  const Places island = {{40, 60}, {60, 60}, {60, 80}, {40, 80}, {40, 60}};
  const OsmData data = map.read_with(map.area({{}, {island, true}}, kWaterTag), report);
  EXPECT_TRUE(holds(data, map.location({2, 2})));
  EXPECT_TRUE(holds(data, map.location({98, 98})));
  EXPECT_FALSE(holds(data, map.location({50, 70})));
}

TEST(CloseCutAreas, AnIslandWhoseLakeIsElsewhereDoesNotBecomeALake) {
  Sketch map;
  for (int x = 5; x < 95; x += 10) map.house({x, 10});
  Report report;
  const Places island = {{40, 60}, {60, 60}, {60, 80}, {40, 80}, {40, 60}};
  expect_diagnosed_only(map.read_with(map.area({{}, {island, true}}, kWaterTag), report), report);
}

TEST(CloseCutAreas, ARiverThatCrossesTheBoxLiesBetweenItsBanks) {
  Sketch map;
  Report report;
  const OsmData data =
      map.read_with(map.area({{{{-5, 45}, {105, 30}}}, {}, {{{-5, 55}, {105, 40}}}, {}}, kRiverTags), report);
  EXPECT_TRUE(holds(data, map.location({50, 43})));
  EXPECT_FALSE(holds(data, map.location({50, 10})));
  EXPECT_FALSE(holds(data, map.location({50, 90})));
}

TEST(CloseCutAreas, AGapInsideTheMapIsNotClosed) {
  Sketch map;
  map.add({{1, 20}, {99, 20}}, kRoadTag);
  Report report;
  const OsmData data = map.read_with(map.area({{{{-10, 60}, {30, 45}, {50, 40}}}, {}}, kWaterTag), report);
  expect_diagnosed_only(data, report);
}

TEST(CloseCutAreas, AMapWithoutABoxIsDiagnosed) {
  Sketch map{.has_box = false, .nodes = {}, .ways = {}};
  map.add({{1, 20}, {99, 20}}, kRoadTag);
  Report report;
  expect_diagnosed_only(map.read_with(map.area({{kShore}, {}}, kWaterTag), report), report);
}

TEST(CloseCutAreas, AnAreaThatCouldLieOnBothSidesIsNotClosed) {
  Sketch without;
  Report report;
  expect_diagnosed_only(without.read_with(without.area({{kShore}, {}}, kWaterTag), report), report);
  Sketch both;
  both.house({50, 10});
  both.house({50, 90});
  Report contradicted;
  expect_diagnosed_only(both.read_with(both.area({{kShore}, {}}, kWaterTag), contradicted), contradicted);
}

TEST(CloseCutAreas, BridgesSayNothing) {
  Sketch map;
  map.add({{20, 70}, {20, 99}}, R"(<tag k="highway" v="primary"/><tag k="bridge" v="yes"/>)");
  Report report;
  expect_diagnosed_only(map.read_with(map.area({{kShore}, {}}, kWaterTag), report), report);
}

TEST(CloseCutAreas, BuildingsAreNotClosed) {
  Sketch map;
  map.add({{1, 20}, {99, 20}}, kRoadTag);
  Report report;
  expect_diagnosed_only(map.read_with(map.area({{kShore}, {}}, kHouseTag), report), report);
}

TEST(CloseCutAreas, OneHouseSaysNothingAboutAWood) {
  Sketch map;
  map.house({50, 10});
  Report report;
  expect_diagnosed_only(map.read_with(map.area({{kShore}, {}}, R"(<tag k="landuse" v="forest"/>)"), report), report);
}

TEST(CloseCutAreas, WoodsLieWhereFieldsAreNot) {
  Sketch map;
  map.add({{60, 5}, {90, 5}, {90, 25}, {60, 25}, {60, 5}}, R"(<tag k="landuse" v="meadow"/>)");
  map.add({{0, 57}, {50, 40}, {50, 5}, {5, 5}, {0, 57}}, R"(<tag k="landuse" v="farmland"/>)");
  Report report;
  const OsmData data = map.read_with(map.area({{kShore}, {}}, R"(<tag k="landuse" v="forest"/>)"), report);
  EXPECT_TRUE(holds(data, map.location({50, 80})));
  EXPECT_FALSE(holds(data, map.location({50, 20})));
}

TEST(CloseCutAreas, EndsNearASideAreLedOn) {
  Sketch map;
  map.house({50, 10});
  Report report;
  const OsmData data = map.read_with(map.area({{{{4, 55}, {50, 57}, {96, 55}}}, {}}, kWaterTag), report);
  EXPECT_TRUE(holds(data, map.location({1, 80})));
  EXPECT_FALSE(holds(data, map.location({1, 30})));
}

TEST(CloseCutAreas, NeitherTheOrderOfMembersNorTheDirectionOfWaysMatters) {
  const Places west = {{-10, 60}, {20, 45}, {50, 40}}, east = {{50, 40}, {80, 50}, {110, 60}};
  const Places island = {{40, 60}, {60, 60}, {60, 80}, {40, 80}, {40, 60}};
  std::vector<SketchMember> members = {{west}, {east}, {}, {island, true}};
  const auto points = [](const std::vector<SketchMember>& in_order) {
    Sketch map;
    map.house({50, 10});
    Report report;
    const OsmData data = map.read_with(map.area(in_order, kWaterTag), report);
    EXPECT_TRUE(holds(data, map.location({50, 90})));
    return points_of_area(data);
  };
  const std::vector<Location> expected = points(members);
  for (int order = 0; order < 4; ++order)
    for (unsigned turned = 0; turned < 8; ++turned) {
      std::vector<SketchMember> changed = members;
      for (const std::size_t member : {0u, 1u, 3u})
        if (turned >> (member < 3 ? member : 2) & 1) std::ranges::reverse(changed[member].line);
      std::ranges::rotate(changed, changed.begin() + order);
      EXPECT_EQ(points(changed), expected) << order << " " << turned;
    }
}

TEST(CloseCutAreas, MirroredAndTurnedMapsHaveTheSameLake) {
  for (int quarters = 0; quarters < 4; ++quarters)
    for (const bool mirrored : {false, true}) {
      Sketch map{.quarters = quarters, .mirrored = mirrored, .nodes = {}, .ways = {}};
      map.house({10, 5});
      Report report;
      // a bay, whose shore leaves the box twice, and a lake around the corner
      const OsmData data = map.read_with(
          map.area({{{{-10, 60}, {30, 45}, {30, -5}, {60, -5}, {60, 30}, {110, 20}}}, {}}, kWaterTag), report);
      EXPECT_TRUE(holds(data, map.location({45, 20}))) << quarters << mirrored;
      EXPECT_TRUE(holds(data, map.location({95, 95}))) << quarters << mirrored;
      EXPECT_TRUE(holds(data, map.location({5, 95}))) << quarters << mirrored;
      EXPECT_FALSE(holds(data, map.location({10, 10}))) << quarters << mirrored;
      EXPECT_FALSE(holds(data, map.location({90, 10}))) << quarters << mirrored;
    }
}

TEST(CloseCutAreas, ClosingRingsAreNoWaysAndNoMembersOfTheMap) {
  Sketch map;
  map.house({50, 10});
  Report report;
  const OsmData data = map.read_with(map.area({{kShore}, {}}, kWaterTag), report);
  EXPECT_EQ(data.ways.size(), 2u);
  ASSERT_EQ(data.relations.size(), 1u);
  EXPECT_EQ(data.relations[0].members.count, 2u);
  EXPECT_EQ(report.ledger().at("source/way").in, 2u);
}

TEST(CloseCutAreas, AreasWhoseWaysAreCutThemselvesAreClosed) {
  for (const bool has_box : {true, false}) {
    Sketch sketch;
    sketch.has_box = has_box;
    sketch.add({{0, 20}, {100, 20}}, kRoadTag);
    sketch.add({{0, 0}, {100, 0}}), sketch.add({{0, 100}, {100, 100}});
    sketch.house({50, 30});
    Report report;
    const OsmData data = sketch.read_with(sketch.area({{{{0, 60}, {50, 50}, {100, 60}}}}, kWaterTag), report);
    const Area* lake = area_in(data);
    ASSERT_NE(lake, nullptr) << has_box;
    for (const Location at : data.points_of(data.rings_of(*lake)[0])) EXPECT_GE(at.lat_e7, 50000);
    EXPECT_EQ(report.counts().at(Code::kAreaClosed), 1u);
    EXPECT_TRUE(report.balances());
  }
}

TEST(CloseCutAreas, AnOpenAreaInsideTheBoxStaysBroken) {
  Sketch sketch;
  sketch.house({5, 5});
  Report report;
  const OsmData data = sketch.read_with(sketch.area({{{{40, 40}, {60, 40}, {60, 60}, {40, 60}}}}, kWaterTag), report);
  EXPECT_EQ(area_in(data), nullptr);
  EXPECT_EQ(report.counts().at(Code::kBrokenArea), 1u);
}

}  // namespace
}  // namespace citykiln::source
