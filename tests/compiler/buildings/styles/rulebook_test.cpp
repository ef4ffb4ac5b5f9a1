#include "compiler/buildings/styles/rulebook.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/buildings/styles/style.h"

namespace citykiln::buildings {
namespace {

std::vector<Style> all_styles() {
  std::vector<Style> styles;
  for (int i = 0; i < static_cast<int>(Style::kCount); ++i) styles.push_back(static_cast<Style>(i));
  return styles;
}

TEST(Rulebook, ShipsARuleFileForEveryStyle) {
  const auto texts = rules_for(all_styles(), shipped_rules());
  ASSERT_TRUE(texts) << to_string(texts.error());
  EXPECT_EQ(parse_rulebook(*texts).size(), all_styles().size() - 1);
}

TEST(Rulebook, IncludesImportedFiles) {
  const std::vector<RuleText> available = {{"barn.cga", "import \"parts/a.cga\"\nBuilding --> A"},
                                           {"other.cga", "Building --> NIL"},
                                           {"parts/a.cga", "A --> NIL"}};
  const std::vector<Style> barn = {Style::kBarn};
  const auto texts = rules_for(barn, available);
  ASSERT_TRUE(texts) << to_string(texts.error());
  ASSERT_EQ(texts->size(), 2u);
  EXPECT_EQ((*texts)[0].name, "barn.cga");
  EXPECT_EQ((*texts)[1].name, "parts/a.cga");
}

TEST(Rulebook, ReportsErrorsInOneLine) {
  const std::vector<Style> barn = {Style::kBarn};
  const auto none = rules_for(barn, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(to_string(none.error()), "barn.cga: there is no such rule file");
  const auto bad = rules_for(barn, std::vector<RuleText>{{"barn.cga", "Building -->\n  split(x) { 1 }"}});
  ASSERT_FALSE(bad);
  EXPECT_TRUE(to_string(bad.error()).starts_with("barn.cga:2:")) << to_string(bad.error());
}

TEST(Rulebook, ContainsOnlyNeededFilesSorted) {
  const std::vector<RuleText> available = {
      {"shop.cga", "Building --> NIL"}, {"garage.cga", "Building --> NIL"}, {"barn.cga", "Building --> NIL"}};
  const auto texts = rules_for(std::vector{Style::kShop, Style::kBarn}, available);
  ASSERT_TRUE(texts) << to_string(texts.error());
  ASSERT_EQ(texts->size(), 2u);
  EXPECT_EQ((*texts)[0].name, "barn.cga");
  EXPECT_EQ((*texts)[1].name, "shop.cga");
}

TEST(Rulebook, ListsTheStylesOfBuildingsSortedAndUnique) {
  std::vector<Building> buildings(4);
  buildings[0].style = Style::kVilla, buildings[1].style = Style::kOldTownHouse, buildings[2].style = Style::kVilla;
  buildings[3].style = Style::kPlain;
  const std::vector<Style> styles = styles_of(buildings);
  EXPECT_EQ(styles.size(), 3u);
  EXPECT_TRUE(std::is_sorted(styles.begin(), styles.end()));
}

}  // namespace
}  // namespace citykiln::buildings
