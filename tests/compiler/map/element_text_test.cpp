#include "compiler/map/element_text.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

Features located_with(const std::string& text, bool keeps_tags) {
  Report report;
  const source::LonLatBox box{7.41, 43.72, 7.43, 43.74};
  Options options;
  options.keeps_tags = keeps_tags;
  return locate(MapText(text).take(), Plane(kTestOrigin), box, options, report);
}

constexpr const char* kTown = R"(n5 3:4 natural=tree name=Old~Oak
n6 8:4 natural=tree
w12 0:0 10:0 20:0 highway=residential name=Rue~"A"
a20 0:0 40:0 40:40 0:40 building=church name=Saint~Anna
a21 5:5 35:5 35:35 5:35 building:part=yes height=20
a22 60:60 70:60 70:70 60:70 building:part=yes name=Tower)";

TEST(ElementTexts, AreSortedAndOnlyOfElementsThatHaveSome) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const ElementText& text : located_with(kTown, false).texts) {
    names.emplace_back(to_string(text.id), text.name);
    EXPECT_TRUE(text.tags.empty());
  }
  EXPECT_EQ(
      names,
      (std::vector<std::pair<std::string, std::string>>{
          {"n5", "Old Oak"}, {"w12", "Rue \"A\""}, {"w20", "Saint Anna"}, {"w21", "Saint Anna"}, {"w22", "Tower"}}));
}

TEST(ElementTexts, KeepAllTagsWhenAsked) {
  const Features features = located_with(kTown, true);
  const auto tags_of = [&](OsmId id) {
    const ElementText* text = find_text(features.texts, id);
    return text == nullptr ? TagList{} : text->tags;
  };
  EXPECT_EQ(tags_of({OsmType::kNode, 6}), (TagList{{"natural", "tree"}}));
  EXPECT_EQ(tags_of({OsmType::kWay, 12}), (TagList{{"highway", "residential"}, {"name", "Rue \"A\""}}));
  EXPECT_EQ(tags_of({OsmType::kWay, 21}), (TagList{{"building:part", "yes"}, {"height", "20"}}));
  EXPECT_TRUE(tags_of({OsmType::kWay, 99}).empty());
}

TEST(ElementTexts, NamesAreCutBetweenCharacters) {
  std::string name = "x";
  while (name.size() < 2000) name += "é";
  const Features features = located_with("n5 3:4 natural=tree name=" + name, false);
  ASSERT_EQ(features.texts.size(), 1u);
  EXPECT_EQ(features.texts[0].name, name.substr(0, kMostNameBytes - 1));
}

}  // namespace
}  // namespace citykiln::map
