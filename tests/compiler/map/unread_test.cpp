#include "compiler/map/unread.h"

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
    w2 0:0 50:0 power=line
    n3 3:4 man_made=tower name=x
    n4 5:4 power=pole
    a5 0:0 40:0 40:30 landuse=unheard_of
    w6 0:0 50:0 highway=unheard_of)",
                                  report);
  EXPECT_EQ(tags, (std::map<std::string, std::string>{{"w1", "man_made=pipeline"},
                                                      {"w2", "power=line"},
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
    w4 9000:0 9050:0 man_made=pipeline)",
                                  report);
  EXPECT_TRUE(tags.empty());
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
