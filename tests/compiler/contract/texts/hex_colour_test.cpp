#include "compiler/contract/texts/hex_colour.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

using Colour = std::array<std::uint8_t, 3>;

TEST(HexColour, HasTwoDigitsForEachComponent) {
  EXPECT_EQ(hex_colour(Colour{0, 15, 255}), "#000fff");
  EXPECT_EQ(hex_colour(Colour{0xa0, 0x0b, 0xc1}), "#a00bc1");
}

TEST(HexColour, IsEmptyWithoutColour) { EXPECT_EQ(hex_colour(std::nullopt), ""); }

}  // namespace
}  // namespace citykiln
