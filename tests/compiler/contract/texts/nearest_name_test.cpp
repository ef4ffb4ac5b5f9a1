#include "compiler/contract/texts/nearest_name.h"

#include <gtest/gtest.h>

#include <vector>

namespace citykiln {
namespace {

const std::vector<std::string> kVerbs = {"compile", "bake", "preview", "inspect", "check", "chart"};

TEST(NearestName, FindsALetterSwappedLeftOutAddedOrReplaced) {
  for (const char* typed : {"complie", "compil", "comppile", "compule"})
    EXPECT_EQ(nearest_name(typed, kVerbs), "compile") << typed;
}

TEST(NearestName, PrefersTheFewestErrors) { EXPECT_EQ(nearest_name("chark", kVerbs), "chart"); }

TEST(NearestName, FindsNothingWhereAThirdOfTheLettersIsWrong) {
  for (const char* typed : {"", "frobnicate", "bakery", "x"}) EXPECT_EQ(nearest_name(typed, kVerbs), "") << typed;
}

TEST(NearestName, TellsShortNamesWithOneErrorApart) {
  EXPECT_EQ(nearest_name("--lod", std::vector<std::string>{"--lods", "--look"}), "--lods");
}

}  // namespace
}  // namespace citykiln
