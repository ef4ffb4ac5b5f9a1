#include "compiler/contract/texts/json_depth.h"

#include <gtest/gtest.h>

#include <string>

namespace citykiln {
namespace {

std::string nested(int levels) { return std::string(levels, '[') + std::string(levels, ']'); }

TEST(JsonDepth, CountsObjectsAndArraysThatAreOpen) {
  EXPECT_FALSE(is_nested_too_deep(nested(kMostJsonLevels)));
  EXPECT_TRUE(is_nested_too_deep(nested(kMostJsonLevels + 1)));
  EXPECT_TRUE(is_nested_too_deep("{\"a\": " + nested(kMostJsonLevels)));
  EXPECT_FALSE(is_nested_too_deep("[" + nested(40) + "," + nested(40) + "]"));
}

TEST(JsonDepth, BracketsInTextsDoNotCount) {
  EXPECT_FALSE(is_nested_too_deep("[\"" + std::string(100, '[') + "\", \"\\\"" + std::string(100, '{') + "\"]"));
  EXPECT_FALSE(is_nested_too_deep(std::string("[\"\\")));
}

}  // namespace
}  // namespace citykiln
