#include "grammars/derivation/evaluate.h"

#include <gtest/gtest.h>

#include "grammars/language/builtin.h"
#include "tests/grammars/on_lot.h"

namespace citykiln::grammars {
namespace {

/// The text that print(expression) prints, on a lot of 10 by 8.
std::string printed(const std::string& expression, const std::string& declarations = "") {
  const Derivation derivation = derived(declarations + "\nLot --> print(" + expression + ")");
  return derivation.printed.empty() ? "nothing" : derivation.printed.front();
}

struct Worth {
  const char* expression;
  const char* value;
};

class Expressions : public testing::TestWithParam<Worth> {};

TEST_P(Expressions, AreWorthWhatCgaSays) { EXPECT_EQ(printed(GetParam().expression), GetParam().value); }

const Worth kWorths[] = {
    {"1 + 2 * 3 - 4 / 8", "6.5"},
    {"(1 + 2) * 3", "9"},
    {"-2 * -3", "6"},
    {"7 % 3", "1"},
    {"-7 % 3", "-1"},
    {"1 < 2 && 2 <= 2 || false", "true"},
    {"!(1 == 1)", "false"},
    {"1 != 2", "true"},
    {"\"a\" + 1 + true", "a1true"},
    {"\"a\" == \"a\"", "true"},
    {"\"a\" < \"b\"", "true"},
    {"abs(-3)", "3"},
    {"ceil(1.2)", "2"},
    {"floor(-1.2)", "-2"},
    {"rint(2.5)", "3"},
    {"round(2.4)", "2"},
    {"sqrt(9)", "3"},
    {"pow(2, 10)", "1024"},
    {"min(3, 2)", "2"},
    {"max(3, 2)", "3"},
    {"clamp(5, 0, 3)", "3"},
    {"sin(90)", "1"},
    {"cos(180)", "-1"},
    {"atan2(1, 1)", "45"},
    {"rint(acos(0.5) * 1000)", "60000"},
    {"exp(0)", "1"},
    {"ln(1)", "0"},
    {"log10(1)", "0"},
    {"float(\"2.5\") + 1", "3.5"},
    {"bool(1)", "true"},
    {"str(0.1)", "0.1"},
    {"sel(true, \"x\", \"y\")", "x"},
    {"len(\"house\")", "5"},
    {"substring(\"house\", 1, 3)", "ou"},
    {"find(\"house\", \"us\")", "2"},
    {"find(\"house\", \"x\", 0)", "-1"},
    {"count(\"banana\", \"an\")", "2"},
    {"replace(\"banana\", \"an\", \"o\")", "booa"},
    {"scope.sx", "10"},
    {"scope.sy", "0"},
    {"scope.sz", "8"},
    {"geometry.area", "80"},
    {"geometry.area()", "80"},
    {"geometry.nFaces", "1"},
    {"geometry.isRectangular", "true"},
    {"geometry.isConcave", "false"},
    {"material.color.r", "1"},
    {"inside()", "false"},
    {"rand(3, 3)", "3"},
    {"p(1)", "true"},
    {"p(0)", "false"},
};

INSTANTIATE_TEST_SUITE_P(Table, Expressions, testing::ValuesIn(kWorths));

TEST(Evaluate, FunctionsChooseByCaseChanceAndLocals) {
  const std::string functions =
      "f(x) = with( twice := x * 2 ) case twice > 4 : \"many\" case twice > 2 : \"some\" else : \"few\"\n"
      "sure = 100% : 1 else : 2\nnever = 0% : 1 else : 2\nnested(x) = case x > 0 : case x > 1 : \"a\" else : \"b\" "
      "else : \"c\"";
  EXPECT_EQ(printed("f(1) + f(2) + f(3)", functions), "fewsomemany");
  EXPECT_EQ(printed("sure + never", functions), "3");
  EXPECT_EQ(printed("nested(2) + nested(1) + nested(0)", functions), "abc");
}

TEST(Evaluate, AttributesAreGivenOrSetOrTheirOwn) {
  const std::string rules = "attr a = 1\nconst twice = a * 2\nLot --> print(twice) set(a, 5) X\nX --> print(a)";
  EXPECT_EQ(derived(rules).printed, (std::vector<std::string>{"2", "5"}));
  DeriveOptions options;
  options.attributes["a"] = 3.0;
  options.attributes["twice"] = 100.0;  // constants cannot be replaced
  EXPECT_EQ(derived(rules, 10, 8, options).printed, (std::vector<std::string>{"6", "5"}));
}

TEST(Evaluate, RandomAttributesKeepTheirValue) {
  const auto printed = derived("attr a = rand(1, 2)\nLot --> print(a) X X\nX --> print(a)").printed;
  EXPECT_EQ(printed[0], printed[1]);
  EXPECT_EQ(printed[0], printed[2]);
}

TEST(Evaluate, FunctionsMayCallThemselvesAHundredTimes) {
  EXPECT_EQ(printed("sum(100)", "sum(n) = case n <= 0 : 0 else : n + sum(n - 1)"), "5050");
}

TEST(Evaluate, WarnsOfWhatHasNoValue) {
  EXPECT_EQ(first_warning("Lot --> extrude(1 / 0)"), "test.cga:1:19: division by zero");
  EXPECT_EQ(first_warning("Lot --> extrude(\"a\" * 2)"), "test.cga:1:17: expected a float, found a string");
  EXPECT_EQ(first_warning("Lot --> case 1 : A else : B"), "test.cga:1:14: expected a bool, found a float");
  EXPECT_EQ(first_warning("f = f\nLot --> extrude(f)"), "test.cga:1:5: values refer to each other without end");
  EXPECT_EQ(first_warning("attr a = b\nattr b = a\nLot --> extrude(a)"),
            "test.cga:1:6: the attribute's value refers to itself");
  EXPECT_EQ(first_warning("Lot --> extrude(pow(10, 300) * pow(10, 300))"),
            "test.cga:1:30: the value is not a number or too large");
  EXPECT_EQ(first_warning("Lot --> print(1 == \"1\")"), "test.cga:1:17: compares a float with a string");
}

TEST(Evaluate, EveryFunctionOfTheTableIsFiniteOnZeros) {
  EXPECT_GT(builtin_functions().size(), 30u);
  for (const BuiltinRow& row : builtin_functions()) {
    std::string arguments;
    for (const char letter : std::string(row.arguments)) {
      if (letter == '/') break;
      arguments += arguments.empty() ? "" : ", ";
      arguments += letter == 's' ? "\"\"" : letter == 'b' ? "false" : "0";
    }
    EXPECT_NE(printed(std::string(row.name) + "(" + arguments + ")"), "nothing") << row.name;
  }
}

}  // namespace
}  // namespace citykiln::grammars
