#include "compiler/buildings/styles/style.h"

#include <gtest/gtest.h>

namespace citykiln::buildings {
namespace {

TEST(StyleNamed, IsThatOfARuleFile) {
  EXPECT_EQ(style_named("haussmann"), Style::kHaussmann);
  EXPECT_EQ(style_named("old_town_house"), Style::kOldTownHouse);
  EXPECT_EQ(style_named("haussmann.cga"), std::nullopt);
  EXPECT_EQ(style_named(""), std::nullopt);
}

}  // namespace
}  // namespace citykiln::buildings
