#include "compiler/map/tags/unread.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

// The tags of the things that are diagnosed as of an unknown kind, by element.
std::map<std::string, std::string> unknown_kinds(const std::string& text, Report& report) {
  features_of(text, report);
  std::map<std::string, std::string> tags;
  for (const Diagnosis& diagnosis : report.diagnoses())
    if (diagnosis.code == Code::kUnknownKind) tags[to_string(diagnosis.object)] = diagnosis.tag;
  return tags;
}

TEST(Unread, ThingsWithABodyAreNamedByTheirTag) {
  Report report;
  const auto tags = unknown_kinds(R"(
    w1 0:0 50:0 man_made=pipeline
    w2 0:0 50:0 power=cable
    n3 3:4 man_made=tower name=x
    n4 5:4 power=pole
    a5 0:0 40:0 40:30 landuse=unheard_of
    w6 0:0 50:0 highway=unheard_of)",
                                  report);
  EXPECT_EQ(tags, (std::map<std::string, std::string>{{"w1", "man_made=pipeline"},
                                                      {"w2", "power=cable"},
                                                      {"n3", "man_made=tower"},
                                                      {"n4", "power=pole"},
                                                      {"w5", "landuse=unheard_of"},
                                                      {"w6", "highway=unheard_of"}}));
  EXPECT_TRUE(report.balances());
}

TEST(Unread, ElementsWithoutABodyAreCountedAndNoFindings) {
  Report report;
  const auto tags = unknown_kinds(R"(
    a1 0:0 40:0 40:30 boundary=administrative
    n3 3:4 highway=crossing
    n4 3:4 natural=peak
    w5 0:0 9:0 name=nothing)",
                                  report);
  EXPECT_TRUE(tags.empty());
  EXPECT_EQ(report.account("map", "unread").without_body, 4u);
  EXPECT_TRUE(report.balances());
}

TEST(Unread, WhatIsBuiltOrOutsideIsNoFinding) {
  Report report;
  const auto tags = unknown_kinds(R"(
    w1 0:0 50:0 highway=residential
    a2 0:0 40:0 40:30 building=yes amenity=school
    n3 3:4 natural=tree
    w5 0:0 50:0 natural=cliff
    w6 0:9 50:9 man_made=dyke
    n7 3:4 building=entrance
    a8 0:0 40:0 40:30 man_made=bridge layer=1
    w4 9000:0 9050:0 man_made=pipeline
    w9 0:60 50:60 power=line)",
                                  report);
  EXPECT_TRUE(tags.empty());
}

TEST(Unread, WhatMeansNothingToBuildIsNoFinding) {
  Report report;
  const auto tags = unknown_kinds(R"(
    a1 0:0 40:0 40:30 place=island
    n2 3:4 barrier=kerb
    w3 0:9 50:9 barrier=kerb
    w4 0:19 50:19 railway=disused
    n5 3:4 barrier=entrance)",
                                  report);
  EXPECT_TRUE(tags.empty());
  EXPECT_TRUE(report.balances());
}

TEST(Unread, ATowerOfPartsIsMergedAndOneWithoutIsAFinding) {
  Report report;
  const auto tags = unknown_kinds(R"(
    a1 0:0 10:0 10:10 0:10 man_made=tower height=40
    a2 1:1 9:1 9:9 1:9 building:part=yes height=40
    a3 50:0 60:0 60:10 50:10 man_made=tower height=40)",
                                  report);
  EXPECT_EQ(tags, (std::map<std::string, std::string>{{"w3", "man_made=tower"}}));
  EXPECT_EQ(report.account("map", "unread").merged, 1u);
}

TEST(Unread, ARelationOfWaysThatAreBuiltIsMerged) {
  Report report;
  source::OsmData osm = extract(R"(
    w2 0:0 40:0 40:30 waterway=canal
    w3 40:30 0:30 0:0 waterway=canal)");
  osm.relations = {{1, {0, 2}, osm.ways[0].tags}};
  for (const std::int64_t way : {2, 3}) osm.members.push_back({{OsmType::kWay, way}, 0});
  features_of(osm, report);
  EXPECT_EQ(report.account("map", "unread").merged, 1u);
  EXPECT_EQ(report.counts()[Code::kUnknownKind], 0u);
}

TEST(Unread, WaysThatAMultipolygonIsBuiltOfAreMerged) {
  Report report;
  source::OsmData osm = extract(R"(
    r1 0:0 40:0 40:30 0:30 natural=water
    w2 0:0 40:0 40:30 natural=water
    w3 40:30 0:30 0:0
    w4 40:30 0:30 0:0 man_made=pipeline)");
  osm.relations = {{1, {0, 3}, {}}};
  for (const std::int64_t way : {2, 3, 4}) osm.members.push_back({{OsmType::kWay, way}, 0});
  features_of(osm, report);
  EXPECT_EQ(report.account("map", "unread").merged, 1u);
  EXPECT_EQ(report.counts()[Code::kUnknownKind], 1u);
  EXPECT_TRUE(report.balances());
}

}  // namespace
}  // namespace citykiln::map
