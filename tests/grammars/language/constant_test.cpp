#include "grammars/language/constant.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/grammars/on_lot.h"

namespace citykiln::grammars {
namespace {

bool is_constant(const Program& program, const std::string& name) {
  return program.functions[program.function_of.find(name)->second].is_constant;
}

TEST(Constants, AreFunctionsOfAttributesAlone) {
  const Program program = program_of(
      "attr height = rand(6, 12)\n"
      "attr moved = 1\n"
      "storey = height / 3\n"
      "two = case storey > 2 : 2 * storey else : max(storey, 1)\n"
      "wide = scope.sx\n"
      "drawn = rand(0, 1)\n"
      "shared = 50% : 1 else : 2\n"
      "changed = moved + 1\n"
      "given(n) = n + 1\n"
      "circle = 1 + circle_again\n"
      "circle_again = circle\n"
      "of_wide = wide + storey\n"
      "Lot --> set(moved, 2) extrude(two) Block.");
  for (const char* name : {"storey", "two"}) EXPECT_TRUE(is_constant(program, name)) << name;
  for (const char* name : {"wide", "drawn", "shared", "changed", "given", "circle", "circle_again", "of_wide"})
    EXPECT_FALSE(is_constant(program, name)) << name;
}

std::uint64_t steps_of(const std::string& height, int times) {
  std::string uses;
  for (int i = 0; i < times; ++i) uses += " extrude(" + height + ")";
  return derived("attr height = 9\nstorey = height / 3 + 1\nLot -->" + uses + " Block.").steps;
}

// Each use takes five steps more than the literal 4, one for each node of the function's value and one for the call.
// The attribute takes one step once.
TEST(Constants, CountTheStepsOfEachUse) {
  for (int times = 1; times < 5; ++times)
    EXPECT_EQ(steps_of("storey", times) - steps_of("4", times), static_cast<std::uint64_t>(1 + 5 * times));
}

TEST(Constants, RaiseTheirWarningsEachTime) {
  const Derivation derivation =
      derived("attr none = 0\nbad = 1 / none\nLot --> split(x) { { ~2 : Tile(bad) }* }\nTile(n) --> Wall.");
  ASSERT_EQ(derivation.warnings.size(), 1u);
  EXPECT_EQ(derivation.warnings.front().times, 5u);
}

}  // namespace
}  // namespace citykiln::grammars
