#include "compiler/contract/findings/assumption_names.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

TEST(AssumptionNames, AreInTheOrderOfTheBits) {
  EXPECT_TRUE(names_in(kNoAssumptions).empty());
  EXPECT_EQ(names_in(bit_of(Assumption::kHeights) | bit_of(Assumption::kPavements)),
            (std::vector<std::string>{"pavements", "heights"}));
}

TEST(AssumptionNames, OfUnknownBitsAreNone) {
  EXPECT_TRUE(names_in(static_cast<Assumptions>(~kAllAssumptions)).empty());
}

TEST(AssumptionNames, AreListedWithTheirBits) {
  EXPECT_TRUE(bits_text().starts_with("1 pavements, 2 lamps, 4 heights"));
}

}  // namespace
}  // namespace citykiln
