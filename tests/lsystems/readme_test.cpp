// Checks statements of lsystems/notation.md.
#include <gtest/gtest.h>

#include "lsystems/rewriting/turtle.h"
#include "tests/lsystems/derived.h"

namespace citykiln::lsystems {
namespace {

std::string readme() { return text_of_tree("lsystems/notation.md"); }

std::vector<std::string> examples() {
  std::vector<std::string> found;
  const std::string text = readme(), fence = "```lsys\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
    at += fence.size();
    found.push_back(text.substr(at, text.find("```", at) - at));
  }
  return found;
}

TEST(Readme, ExamplesDeriveWithoutWarnings) {
  ASSERT_EQ(examples().size(), 12u);
  for (const std::string& text : examples()) {
    const LSystem system = system_of(text);
    const Plant plant = grow(system);
    EXPECT_FALSE(plant.derivation.limit_exceeded) << text;
    EXPECT_FALSE(plant.skeleton.segments.empty() && plant.skeleton.polygons.empty()) << text;
    for (const auto* warnings : {&plant.derivation.warnings, &plant.skeleton.warnings})
      for (const Warning& warning : *warnings) ADD_FAILURE() << warning_line(system, warning) << "\n" << text;
  }
}

TEST(Readme, ListsEveryFunctionAndSymbol) {
  const std::string text = readme();
  for (const char* name : {
#define FUNCTION(name, arity, op, code) name,
#include "lsystems/operations.inc"
#define SYMBOL(name, op, text) name,
#include "lsystems/turtle_symbols.inc"
       })
    EXPECT_NE(text.find(name), std::string::npos) << name;
}

TEST(Readme, LimitsAreAsStated) {
  EXPECT_EQ(Limits{}.symbols, 8'000'000u);
  EXPECT_EQ(Limits{}.written, 400'000'000u);
  EXPECT_EQ(Limits{}.steps, 100'000u);
  EXPECT_EQ(kTextLimit, 4u << 20);
}

}  // namespace
}  // namespace citykiln::lsystems
