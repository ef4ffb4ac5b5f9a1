#include "compiler/contract/texts/parse.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

TEST(Trimmed, HasNoBlanksAtItsEnds) {
  EXPECT_EQ(trimmed(" \t a b\t\r"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \r\t "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Split, KeepsEmptyParts) {
  EXPECT_EQ(split("a;;b;", ';'), (std::vector<std::string_view>{"a", "", "b", ""}));
  EXPECT_EQ(split("", ';'), (std::vector<std::string_view>{""}));
}

TEST(NumbersIn, AreExactlyAsManyAsWanted) {
  EXPECT_EQ(numbers_in<double>("1.5/-2", '/', 2), (std::vector<double>{1.5, -2}));
  EXPECT_FALSE(numbers_in<double>("1.5/-2", '/', 3));
  EXPECT_FALSE(numbers_in<double>("1.5/", '/', 2));
  EXPECT_FALSE(number_in<double>("1 "));
  EXPECT_FALSE(number_in<double>("inf"));
}

}  // namespace
}  // namespace citykiln
