#include "lsystems/reading/read_lsystem.h"

#include <gtest/gtest.h>

#include "tests/lsystems/derived.h"

namespace citykiln::lsystems {
namespace {

std::string lsystem_error_of(const std::string& text) {
  const Result<LSystem> system = read_lsystem(text, "x.lsys");
  return system ? "" : to_string(system.error());
}

struct Mistake {
  const char* text;
  const char* error;
};

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreNamedWithPlaceAndWhatWasExpected) {
  const std::string error = lsystem_error_of(GetParam().text);
  EXPECT_EQ(error.substr(0, error.find(" (in rule ")), GetParam().error);
}

const Mistake kMistakes[] = {
    {"", "x.lsys: expected an axiom, found the end of the file"},
    {"axiom: F /* open", "x.lsys:1:10: expected */ that ends the comment, found the end of the file"},
    // directives
    {"hello", "x.lsys:1:1: expected a production with '->', or a directive, found 'hello'"},
    {"axiom: F\naxiom: G", "x.lsys:2:8: the axiom is given twice"},
    {"n: many", "x.lsys:1:4: 'many' is not defined"},
    {"n: -1", "x.lsys:1:4: expected the number of steps, 0 to 1000000000, found -1"},
    {"angle: 20 30", "x.lsys:1:11: expected the end of the line, found '30'"},
    {"#define 3 4", "x.lsys:1:9: expected the constant's name, found '3'"},
    {"#define r", "x.lsys:1:10: expected a value, found the end of the line"},
    {"#define r ran(1)", "x.lsys:1:11: expected a constant, found a random draw"},
    {"#define r 1\n#define r 2", "x.lsys:2:9: the constant 'r' is defined twice"},
    {"#define r 1/0", "x.lsys:1:11: expected a number; this constant has no value"},
    {"#ignore: +[", "x.lsys:1:12: contexts follow brackets: they cannot be ignored"},
    {"tropism: 0 0 -1", "x.lsys:1:12: expected ',' between the parts x, y and z of the tropism, found '0'"},
    {"module 3", "x.lsys:1:8: expected a module's name, found '3'"},
    {"decomposition:\nmaximum depth: 100", "x.lsys:2:16: expected a depth, 1 to 64, found 100"},
    // modules
    {"axiom: F\nF -> FF  // a branch", "x.lsys:2:10: // is two modules here: use /* */ for comments among modules"},
    {"axiom: F(1", "x.lsys:1:11: expected ')' or ',' after a parameter, found the end of the line"},
    {"axiom: F()", "x.lsys:1:10: expected a value, found ')'"},
    {"axiom: F = G", "x.lsys:1:10: expected the end of the line, found '='"},
    {"axiom: F[+F", "x.lsys:1:9: '[' without ']'"},
    {"axiom: F]", "x.lsys:1:9: ']' without '['"},
    {"axiom: ~(3)", "x.lsys:1:9: expected a letter behind '~', found '('"},
    {"axiom: ?Q(3)", "x.lsys:1:8: there is no query '?Q', only ?P ?H ?S"},
    {"axiom: ?H", "x.lsys:1:8: expected 1 parameter of '?H', found 0"},
    {"axiom: @T(1)", "x.lsys:1:8: expected 4 parameters of '@T', found 1"},
    {"axiom: F(1e999)", "x.lsys:1:10: expected a number that a double can hold"},
    // productions
    {"axiom: F\nplant -> F",
     "x.lsys:2:1: expected one module before the arrow, found 5; `module` declares names of more than one letter"},
    {"axiom: F\n-> F", "x.lsys:2:1: expected one module before the arrow, found 0"},
    {"axiom: F\n[ -> F", "x.lsys:2:1: '[' without ']'"},
    {"axiom: F\n% -> F", "x.lsys:2:1: '%' cannot be rewritten"},
    {"axiom: F\nF(3) -> F", "x.lsys:2:3: expected a parameter's name, found '3'"},
    {"axiom: F\nF(x,x) -> F", "x.lsys:2:6: the parameter 'x' is named twice"},
    {"axiom: F\nF -> F[", "x.lsys:2:7: '[' without ']'"},
    {"axiom: F\nF(x) : x > -> F", "x.lsys:2:12: expected a value, found '-'"},
    {"axiom: F\nF -> (0.5 F", "x.lsys:2:11: expected ')' after the probability, found 'F'"},
    {"axiom: F\nF -> (0.5) F : 0.5", "x.lsys:2:16: the production has a probability already"},
    {"axiom: F\nF -> F <", "x.lsys:2:8: expected a module or the end of the production, found '<'"},
    {"axiom: F\n[A] < F -> F", "x.lsys:2:1: a left context is a path: no brackets and no %"},
    {"axiom: F\nF(x) -> F(x*y)", "x.lsys:2:13: 'y' is not defined"},
    {"axiom: F\nF(x) -> F(f(x))", "x.lsys:2:11: there is no function 'f'"},
    {"axiom: F\nF(x) -> F(min(x))", "x.lsys:2:16: expected ',' and another argument of 'min', found ')'"},
    {"axiom: F\nF(x) -> F((x)", "x.lsys:2:14: expected ')' or ',' after a parameter, found the end of the line"},
    {"axiom: F\nF(x) -> F(1/0)", "x.lsys:2:11: expected a number; this constant has no value"},
    {"axiom: F\n#ignore: +\n+ < F -> G", "x.lsys:3:1: '+' is ignored: it cannot be a context"},
    {"axiom: F\ndecomposition:\nA < F -> F", "x.lsys:3:1: these rules have no contexts"},
    {"axiom: F\nbark: 3", "x.lsys:2:7: expected the bark's name, found '3'"},
    {"axiom: F\ninterpretation:\nF -> ?H(x)", "x.lsys:3:9: 'x' is not defined"},
    {"axiom: F\ninterpretation:\nF -> ?H(0)", "x.lsys:3:6: interpretation rules have no queries"},
};

INSTANTIATE_TEST_SUITE_P(Table, Mistakes, testing::ValuesIn(kMistakes));

TEST(ReadLsystem, ErrorsNameTheRuleInWhichTheyAre) {
  EXPECT_EQ(lsystem_error_of("axiom: A(1)\nA(x) -> F(x)A(y)"), "x.lsys:2:15: 'y' is not defined (in rule A)");
  EXPECT_EQ(lsystem_error_of("axiom: X\nX \xe2\x86\x92 F[+X]F"),
            "x.lsys:2:1: expected a production with '->' instead of '\xe2\x86\x92', found 'X'");
}

TEST(ReadLsystem, RefusesWhatIsNestedTooDeep) {
  const std::string deep = "axiom: F(" + std::string(1000, '(') + "1" + std::string(1000, ')') + ")";
  EXPECT_NE(lsystem_error_of(deep).find("nested deeper than 64"), std::string::npos);
  std::string powers = "axiom: F(2";
  for (int i = 0; i < 1000; ++i) powers += "^2";
  EXPECT_NE(lsystem_error_of(powers + ")").find("nested deeper than 64"), std::string::npos);
}

TEST(ReadLsystem, RefusesAFileOf100MB) {
  const std::string text = "axiom: " + std::string(100'000'000, 'F');
  EXPECT_EQ(lsystem_error_of(text), "x.lsys: expected at most 4194304 bytes, found 100000007");
}

TEST(ReadLsystem, ReadsEachDirective) {
  const LSystem system = system_of(R"(
/* a comment
   of two lines */
Lsystem: 1
#define r1 0.9      // to the line's end
#define r2 (r1 - 0.1) * 2
module seg, internode
#ignore: +-F
derivation length: 7
delta = 22.5
step: 2
width: 0.5
width unit: 0.1
height: 12
bark: furrowed
seed: 9
tropism: 0, 0, -1
elasticity: 0.22
ω : seg A(1, r2)[internode]
p1 : A(l,w) : l > 1 & w < 2 -> !(w)F(l)
  [&(45)A(l*r1, w)]
  A(l*r1,
    w)
A(x) < F > B(y) : x = y --> F(x + y) : 0.5
homomorphism:
maximum depth: 3
seg --> F
endlsystem
this is no longer read
)");
  EXPECT_EQ(system.steps, 7);
  EXPECT_EQ(system.angle_deg, 22.5);
  EXPECT_EQ(system.step, 2);
  EXPECT_EQ(system.width, 0.5);
  EXPECT_EQ(system.width_unit, 0.1);
  EXPECT_EQ(system.height, 12);
  EXPECT_EQ(system.seed, 9u);
  EXPECT_EQ(system.tropism, (Vec3{0, 0, -1}));
  EXPECT_EQ(system.elasticity, 0.22);
  EXPECT_EQ(text_of(system, derive(system, {.steps = 0}).string), "seg A(1,1.6)[ internode ]");
  EXPECT_EQ(system.productions.rules.size(), 2u);
  EXPECT_EQ(system.interpretation.rules.size(), 1u);
  EXPECT_EQ(system.interpretation.most_depth, 3);
}

TEST(ReadLsystem, TakesGivenValuesInThePlaceOfConstants) {
  const std::string text = "#define age 3\n#define twice 2 * age\naxiom: F(age, twice)";
  const Result<LSystem> system = read_lsystem(text, "x.lsys", {{"age", 10}, {"other", 1}});
  ASSERT_TRUE(system);
  EXPECT_EQ(text_of(*system, derive(*system).string), "F(10,20)");
}

TEST(ReadLsystem, TellsRollsFromComments) {
  EXPECT_EQ(grown("module leaf\naxiom: F\nF -> //F [ // & & leaf ] // ff", 1), "//F[//&& leaf ]//ff");
  EXPECT_EQ(grown("// a comment\naxiom: F\nn: 2 // and one\nF -> F//fff", 1), "F//fff");
}

TEST(ReadLsystem, EndsLinesAsAnySystemDoes) { EXPECT_EQ(grown("axiom: F\r\nF -> F\r\n  [+F]\r\n", 1), "F[+F]"); }

TEST(ReadLsystem, KnowsLongNamesFromLettersInARow) {
  EXPECT_EQ(grown("module seg, segment\naxiom: segseg sg segment", 0), "seg seg sg segment");
}

TEST(Expressions, HaveTheirFieldsPriorities) {
  const auto value = [](const std::string& expression) { return grown("axiom: F(" + expression + ")", 0); };
  EXPECT_EQ(value("1 + 2 * 3"), "F(7)");
  EXPECT_EQ(value("-2 ^ 2"), "F(-4)");
  EXPECT_EQ(value("2 ^ 3 ^ 2"), "F(512)");
  EXPECT_EQ(value("7 - 2 - 1"), "F(4)");
  EXPECT_EQ(value("7 % 4 * 2"), "F(6)");
  EXPECT_EQ(value("1 < 2 && 2 >= 3 || !0"), "F(1)");
  EXPECT_EQ(value("1 = 1 & 2 != 2"), "F(0)");
  EXPECT_EQ(value("max(sin(90), sqrt(16)) + floor(2.5)"), "F(6)");
  EXPECT_EQ(value("atan2(1, 1)"), "F(45)");
}

TEST(Expressions, WithParametersAreAsWithTheirValues) {
  // short forms, code and constants are three ways to the same number
  for (const char* expression :
       {"x", "x*3", "3*x", "x+3", "3+x", "x-3", "3-x", "x/3", "(x+1)*(x-1)", "x^2", "-x", "min(x,4)"}) {
    std::string constant, spelled = expression;
    for (std::size_t i = 0; i < spelled.size(); ++i) constant += spelled[i] == 'x' ? '5' : spelled[i];
    EXPECT_EQ(grown("axiom: A(5)\nA(x) -> F(" + std::string(expression) + ")", 1),
              grown("axiom: F(" + constant + ")", 0))
        << expression;
  }
}

}  // namespace
}  // namespace citykiln::lsystems
