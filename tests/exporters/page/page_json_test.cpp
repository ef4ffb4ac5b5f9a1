#include "exporters/page/page_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace citykiln::exporters {
namespace {

using nlohmann::json;

FeatureRecords some_records() {
  FeatureRecords records;
  FeatureRecord& house = records[{OsmType::kWay, 1001}];
  house.kind = "House", house.name = "</script><img src=x>", house.at = {1.234, -5, 7};
  house.tags.add("building", "house"), house.assumed = bit_of(Assumption::kRoofs);
  house.recipe = {{"storeys", std::int64_t{2}}, {"eaves_m", 6.125}, {"shop", true}, {"roof", std::string("gabled")}};
  records[{OsmType::kNode, -7}].kind = "oak";
  records[{OsmType::kRelation, 1001}].name = "Abbey";
  return records;
}

TEST(PageJson, ARecordIsInTheFileOfItsId) {
  const std::vector<std::string> files = feature_files(some_records(), 10);
  ASSERT_EQ(files.size(), 10U);
  EXPECT_TRUE(json::parse(files[1]).contains("w1001"));
  EXPECT_TRUE(json::parse(files[1]).contains("r1001"));
  EXPECT_TRUE(json::parse(files[7]).contains("n-7"));
  EXPECT_EQ(json::parse(files[0]), json::object());
}

TEST(PageJson, ARecordTellsTagsRecipeAndAssumptions) {
  const json house = json::parse(feature_files(some_records(), 1).front()).at("w1001");
  EXPECT_EQ(house.at("tags").at("building"), "house");
  EXPECT_EQ(house.at("assumed"), json::array({"roofs"}));
  EXPECT_EQ(house.at("recipe"), json::parse(R"({"storeys":2,"eaves_m":6.13,"shop":true,"roof":"gabled"})"));
  EXPECT_EQ(house.at("at").at(0), 1.23);
}

TEST(PageJson, NamesAreSortedAndKeepMarkupAsText) {
  const json names = json::parse(names_json(some_records()));
  EXPECT_EQ(names, json::array({{"</script><img src=x>", "w1001", "House", 1, -5}, {"Abbey", "r1001", "", 0, 0}}));
}

TEST(PageJson, AllFeaturesOfANameAreListed) {
  FeatureRecords records;
  records[{OsmType::kWay, 2}].name = records[{OsmType::kWay, 1}].name = "Mill Lane";
  const json names = json::parse(names_json(records));
  EXPECT_EQ(names.size(), 2U);
  EXPECT_EQ(names.at(0).at(1), "w1");
  EXPECT_EQ(names.at(1).at(1), "w2");
}

TEST(PageJson, NamesInOtherLanguagesAreRowsOfTheirOwn) {
  FeatureRecords records;
  FeatureRecord& tower = records[{OsmType::kWay, 1}];
  tower.name = "東京タワー", tower.tags.add("int_name", "Tokyo Tower"), tower.tags.add("name:en", "Tokyo Tower");
  const json names = json::parse(names_json(records));
  ASSERT_EQ(names.size(), 2U);
  EXPECT_EQ(names.at(0).at(0), "Tokyo Tower");
  EXPECT_EQ(names.at(1).at(0), "東京タワー");
}

TEST(PageJson, TextsThatAreNoUtf8AreReplaced) {
  FeatureRecords records;
  records[{OsmType::kWay, 1}].name = "a\xff";
  EXPECT_EQ(json::parse(names_json(records)).at(0).at(0), "a\xEF\xBF\xBD");
}

TEST(PageJson, ThePageHasTheTextsOfAllCodesAndAssumptions) {
  PageFacts facts;
  facts.title = "town", facts.region_m = {{-1, -2}, {3, 4}};
  const json page = json::parse(page_json(facts, some_records()));
  EXPECT_EQ(page.at("region_m"), json::array({-1, -2, 3, 4}));
  EXPECT_EQ(page.at("assumptions").at("roofs"), "the shapes of roofs");
  EXPECT_TRUE(page.at("codes").contains("MissingNode"));
  EXPECT_EQ(page.at("classes"), (json{{"House", 1}, {"oak", 1}}));
}

TEST(PageJson, SkiesNameTheirTables) {
  PageFacts facts;
  facts.skies = {{.time = "2026-06-21T12:00:00Z", .label = "12:00", .file = "page/skies/0.json"}};
  EXPECT_EQ(json::parse(page_json(facts, {})).at("skies").at(0).at("file"), "page/skies/0.json");
}

TEST(PageJson, LightHasFourDigitsAndItsDirectionAll) {
  const PageSkyTable table{.to_light = {0.123456789, 0, 0.992349}, .light = {1.23456, 0, 0}};
  const json sky = json::parse(sky_json(table));
  EXPECT_EQ(sky.at("light").at(0), 1.235);
  EXPECT_EQ(sky.at("to_light").at(0), 0.123456789);
}

}  // namespace
}  // namespace citykiln::exporters
