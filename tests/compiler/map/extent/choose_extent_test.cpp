#include "compiler/map/extent/choose_extent.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

using source::LonLatBox;

// Some 40 nodes near kTestOrigin, which is 7.42, 43.73.
source::OsmData village() {
  std::string text;
  for (int i = 0; i < 10; ++i)
    text += fmt::format("w{} {}:0 {}:50 {}:100 {}:150 highway=residential\n", i + 1, i * 20, i * 20, i * 20, i * 20);
  return extract(text);
}

source::OsmData village_with_stray_node() {
  source::OsmData osm = village();
  osm.way_nodes[7].at.lon_e7 += 100000000;
  return osm;
}

TEST(ChooseExtent, OneStrayNodeIsLeftOutAndNamed) {
  const source::OsmData osm = village_with_stray_node();
  Report report;
  const auto box = choose_extent(osm, {}, report);
  ASSERT_TRUE(box);
  EXPECT_LT(box->east - box->west, 0.01);
  ASSERT_EQ(report.diagnoses().size(), 1u);
  EXPECT_EQ(report.diagnoses()[0].code, Code::kStrayNode);
  EXPECT_EQ(report.diagnoses()[0].object, (OsmId{OsmType::kNode, osm.way_nodes[7].id}));
  EXPECT_NEAR(report.diagnoses()[0].size, 10, 0.1);
}

TEST(ChooseExtent, AFarTownIsNoStray) {
  // 40 nodes of 80, ten kilometres away
  source::OsmData osm = village();
  for (std::size_t i = 20; i < osm.way_nodes.size(); ++i) osm.way_nodes[i].at.lat_e7 += 1000000;
  Report report;
  const auto box = choose_extent(osm, {}, report);
  ASSERT_TRUE(box);
  EXPECT_GT(box->north - box->south, 0.1);
  EXPECT_TRUE(report.diagnoses().empty());
}

TEST(ChooseExtent, ABoxFarLargerThanTheMapIsClippedToIt) {
  const source::OsmData osm = village();
  Report report;
  const LonLatBox map = *choose_extent(osm, {}, report);
  const auto box = choose_extent(osm, LonLatBox{-20, 30, 20, 60}, report);
  ASSERT_TRUE(box);
  EXPECT_EQ(*box, map);
  EXPECT_EQ(report.counts().at(Code::kBoxClipped), 1u);
}

TEST(ChooseExtent, ABoxALittleLargerThanTheMapIsKept) {
  Report report;
  const LonLatBox asked{7.415, 43.725, 7.43, 43.735};
  const auto box = choose_extent(village(), asked, report);
  ASSERT_TRUE(box);
  EXPECT_EQ(*box, asked);
  EXPECT_TRUE(report.diagnoses().empty());
}

TEST(ChooseExtent, ABoxBesideTheMapIsAnErrorThatStatesTheMapsBox) {
  Report report;
  const auto box = choose_extent(village(), LonLatBox{8, 44, 8.1, 44.1}, report);
  ASSERT_FALSE(box);
  EXPECT_NE(to_string(box.error()).find("7.4200,43.7300"), std::string::npos) << to_string(box.error());
  EXPECT_EQ(to_string(box.error()).find("swapped"), std::string::npos);
}

TEST(ChooseExtent, ABoxInTheOtherOrderIsAnErrorThatSaysSo) {
  Report report;
  const auto box = choose_extent(village(), LonLatBox{43.72, 7.41, 43.74, 7.43}, report);
  ASSERT_FALSE(box);
  EXPECT_NE(to_string(box.error()).find("swapped? Try 7.4100,43.7200,7.4300,43.7400"), std::string::npos)
      << to_string(box.error());
}

TEST(ChooseExtent, AnAreaThatWouldTakeHoursIsRefused) {
  const source::OsmData osm = village();
  EXPECT_TRUE(check_worth_baking({{0, 0}, {1024, 1024}}, osm, false));
  // a box that a user or a header states may hold few nodes
  EXPECT_TRUE(check_worth_baking({{0, 0}, {60000, 60000}}, osm, true));
  EXPECT_FALSE(check_worth_baking({{0, 0}, {60000, 60000}}, osm, false));
  EXPECT_FALSE(check_worth_baking({{0, 0}, {600000, 1024}}, osm, true));
}

}  // namespace
}  // namespace citykiln::map
