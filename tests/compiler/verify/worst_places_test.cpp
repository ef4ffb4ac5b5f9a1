#include "compiler/verify/worst_places.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::verify {
namespace {

const map::Plane kPlane({7, 43});

outputs::Finding finding(Code code, std::int64_t way, double size) {
  return {{code, {OsmType::kWay, way}, size}, LonLat{7.001, 43.001}, {}};
}

TEST(WorstPlaces, AreTheLargestOfEachKindAndOneOfEachObject) {
  const std::vector<outputs::Finding> findings = {finding(Code::kTooSteep, 1, 0.2), finding(Code::kTooSteep, 2, 0.4),
                                                  finding(Code::kTooSteep, 1, 0.3), finding(Code::kTooSteep, 3, 0.1),
                                                  finding(Code::kHeightRaised, 4, 9)};
  const auto kinds = worst_places({}, {}, findings, kPlane, 2);
  ASSERT_EQ(kinds.size(), 2u);
  EXPECT_EQ(kinds[0].name, "TooSteep");
  EXPECT_EQ(kinds[0].count, 3u);
  ASSERT_EQ(kinds[0].worst.size(), 2u);
  EXPECT_EQ(kinds[0].worst[0].size, 0.4);
  EXPECT_EQ(kinds[0].worst[1].size, 0.3);
  EXPECT_NEAR(kinds[0].worst[0].at->x, kPlane.forward({7.001, 43.001}).x, 1e-6);
  EXPECT_EQ(kinds[1].name, "HeightRaised");
}

TEST(WorstPlaces, LeaveOutWhatIsNoDefect) {
  const std::vector<outputs::Finding> findings = {finding(Code::kOutsideBounds, 1, 0),
                                                  finding(Code::kUnknownKind, 2, 0)};
  EXPECT_TRUE(worst_places({}, {}, findings, kPlane, 5).empty());
}

TEST(WorstPlaces, BeginWithGuaranteesThatDoNotHold) {
  CheckResults results;
  results.footing.test(false, {"w9 by 2 m", {3, 4}, {{OsmType::kWay, 9}}, 2, "glb/0_0_L0.glb"});
  results.clearances.shortfalls = {{1.5, {OsmType::kWay, 5}, {OsmType::kWay, 6}, {1, 2}, "w5: bridge=yes"}};
  results.clearances.contradictions = {{2, {OsmType::kWay, 6}, {OsmType::kWay, 5}, {1, 2}}};
  const std::vector<Earthwork> earthworks = {{{OsmType::kWay, 7}, "stream", 6, {}},
                                             {{OsmType::kWay, 7}, "stream", -2, {}}};
  const std::vector<outputs::Finding> findings = {finding(Code::kTooSteep, 1, 0.2)};
  const auto kinds = worst_places(results, earthworks, findings, kPlane, 5);
  std::vector<std::string> names;
  for (const PlacesOfKind& kind : kinds) names.push_back(kind.name);
  EXPECT_EQ(names, (std::vector<std::string>{"broken guarantee", "missing clearance", "LayersContradict",
                                             "cut of a stream", "fill of a stream", "TooSteep"}));
  EXPECT_FALSE(kinds[3].worst[0].is_usual);
  EXPECT_TRUE(kinds[4].worst[0].is_usual);
  EXPECT_EQ(kinds[1].worst[0].text, "w5 over w6 (w5: bridge=yes)");
  EXPECT_EQ(kinds[0].worst[0].file, "glb/0_0_L0.glb");
  EXPECT_EQ(kinds[0].worst[0].at, (Vec2{3, 4}));
}

TEST(WorstPlaces, HaveWaysIntoWallsAndBlankWalls) {
  CheckResults results;
  results.ways_into_walls = {{{OsmType::kWay, 5}, {OsmType::kWay, 6}, 12, {1, 2}}};
  results.blank_walls = {{{OsmType::kWay, 6}, 30, {3, 4}}, {{OsmType::kWay, 7}, 40, {5, 6}}};
  const auto kinds = worst_places(results, {}, {}, kPlane, 1);
  ASSERT_EQ(kinds.size(), 2u);
  EXPECT_EQ(kinds[0].name, "way into a wall");
  EXPECT_EQ(kinds[0].worst[0].text, "w5 into w6");
  EXPECT_EQ(kinds[1].name, "blank wall");
  EXPECT_EQ(kinds[1].count, 2u);
  EXPECT_EQ(kinds[1].worst[0].size, 40);
}

}  // namespace
}  // namespace citykiln::verify
