#include "lsystems/rewriting/derive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/lsystems/derived.h"

namespace citykiln::lsystems {
namespace {

TEST(Derive, RewritesAllModulesAtOnce) {
  // the book's first system, Fibonacci's words
  const std::string text = "axiom: b\na -> ab\nb -> a";
  EXPECT_EQ(grown(text, 3), "aba");
  EXPECT_EQ(grown(text, 5), "abaababa");
}

TEST(Derive, ComputesParameters) {
  // the book, section 1.10.1
  const std::string text = R"(
axiom: B(2)A(4,4)
p1: A(x,y) : y <= 3 -> A(x*2,x+y)
p2: A(x,y) : y > 3 -> B(x)A(x/y,0)
p3: B(x) : x < 1 -> C
p4: B(x) : x >= 1 -> B(x-1))";
  EXPECT_EQ(grown(text, 1), "B(1)B(4)A(1,0)");
  EXPECT_EQ(grown(text, 2), "B(0)B(3)A(2,1)");
  EXPECT_EQ(grown(text, 3), "CB(2)A(4,3)");
  EXPECT_EQ(grown(text, 4), "CB(1)A(8,7)");
}

TEST(Derive, TellsModulesApartByTheirNumberOfParameters) {
  EXPECT_EQ(grown("axiom: F F(1) F(1,2)\nF(x) -> G(x)", 1), "FG(1)F(1,2)");
}

TEST(Derive, KeepsWhatNoRuleFits) { EXPECT_EQ(grown("axiom: A(1)B\nA(x) : x > 1 -> C", 3), "A(1)B"); }

TEST(Derive, TakesTheFirstRuleThatFits) {
  EXPECT_EQ(grown("axiom: A(5)\nA(x) : x > 4 -> B\nA(x) : x > 3 -> C\nA(x) -> D", 1), "B");
  EXPECT_EQ(grown("axiom: A(4)\nA(x) : x > 4 -> B\nA(x) : x > 3 -> C\nA(x) -> D", 1), "C");
}

TEST(Derive, ErasesWithAnEmptySuccessor) {
  EXPECT_EQ(grown("axiom: ABA\nA -> *", 1), "B");
  EXPECT_EQ(grown("axiom: ABA\nA ->", 1), "B");
}

TEST(Contexts, CarryASignal) {
  // the book, section 1.8: a signal moves from the base to the top
  const std::string text = "axiom: baaaaaaa\nb < a -> b\nb -> a";
  EXPECT_EQ(grown(text, 1), "abaaaaaa");
  EXPECT_EQ(grown(text, 3), "aaabaaaa");
}

TEST(Contexts, LookPastBranches) {
  // the book, section 1.8: BC < S > G[H]M fits S in ABC[DE][SG[HI[JK]L]MNO]
  const std::string string = "axiom: ABC[DE][SG[HI[JK]L]MNO]\n";
  EXPECT_EQ(grown(string + "BC < S > G[H]M -> x", 1), "ABC[DE][xG[HI[JK]L]MNO]");
  EXPECT_EQ(grown(string + "BC < S > GM -> x", 1), "ABC[DE][xG[HI[JK]L]MNO]");
  EXPECT_EQ(grown(string + "AC < S > G -> x", 1), "ABC[DE][SG[HI[JK]L]MNO]");
  EXPECT_EQ(grown(string + "C < S > G[I]M -> x", 1), "ABC[DE][SG[HI[JK]L]MNO]");
  EXPECT_EQ(grown(string + "C < S > GH -> x", 1), "ABC[DE][SG[HI[JK]L]MNO]");
  EXPECT_EQ(grown(string + "E < S -> x", 1), "ABC[DE][SG[HI[JK]L]MNO]");
  EXPECT_EQ(grown(string + "S > G[H[I]] -> x", 1), "ABC[DE][SG[HI[JK]L]MNO]");
  EXPECT_EQ(grown(string + "S > G[HI[J]L] -> x", 1), "ABC[DE][xG[HI[JK]L]MNO]");
}

TEST(Contexts, TryEachBranch) {
  EXPECT_EQ(grown("axiom: A[B][C]D\nA > [C]D -> x", 1), "x[B][C]D");
  EXPECT_EQ(grown("axiom: A[B][C]D\nA > [B][C] -> x", 1), "x[B][C]D");
  EXPECT_EQ(grown("axiom: A[B][C]D\nA > [C][B] -> x", 1), "A[B][C]D");
  // a branch after the next module does not match
  EXPECT_EQ(grown("axiom: AB[C]D\nA > [C] -> x", 1), "AB[C]D");
}

TEST(Contexts, EndWhereTheBranchEnds) {
  EXPECT_EQ(grown("axiom: [AB]C\nB > C -> x", 1), "[AB]C");
  EXPECT_EQ(grown("axiom: A[B]C\nB < C -> x\nA < C -> y", 1), "A[B]y");
}

TEST(Contexts, IgnoreWhatTheFileSays) {
  const std::string rules = "axiom: A+F[-B]F-C\nA < C -> x\nA < B -> y\nA > C -> z\n";
  EXPECT_EQ(grown(rules, 1), "A+F[-B]F-C");
  EXPECT_EQ(grown(rules + "#ignore: +-F", 1), "z+F[-y]F-x");
  EXPECT_EQ(grown(rules + "#consider: ABC", 1), "z+F[-y]F-x");
}

TEST(Contexts, LendTheirParameters) {
  EXPECT_EQ(grown("axiom: A(1)B(2)[C(3)]D(4)\nA(a) < B(b) > [C(c)]D(d) : a + d = 5 -> E(a,b,c,d)", 1),
            "A(1)E(1,2,3,4)[C(3)]D(4)");
  EXPECT_EQ(grown("axiom: A(1)B(2)C\nA(a)B(b) < C -> D(a,b)", 1), "A(1)B(2)D(1,2)");
}

TEST(Chance, FallsByTheSharesOfTheProductions) {
  // 30,000 draws: each count within four standard deviations
  const std::string text = "axiom: " + std::string(30'000, 'A') + "\nA -> (0.33) B\nA -> (0.33) C\nA -> (0.34) D";
  const LSystem system = system_of(text);
  auto counts = counts_of(system, derive(system, {.steps = 1}).string);
  EXPECT_NEAR(static_cast<double>(counts["B"]), 9'900, 330);
  EXPECT_NEAR(static_cast<double>(counts["D"]), 10'200, 330);
  EXPECT_EQ(counts["A"], 0u);
}

TEST(Chance, SharesNeedNotAddUpToOne) {
  const LSystem system = system_of("axiom: " + std::string(10'000, 'A') + "\nA -> B : 3\nA -> C : 1\nA -> D : 0");
  auto counts = counts_of(system, derive(system, {.steps = 1}).string);
  EXPECT_NEAR(static_cast<double>(counts["B"]), 7'500, 180);
  EXPECT_EQ(counts["B"] + counts["C"], 10'000u);
}

TEST(Chance, IsEachPlantsAndEachSeedsOwn) {
  const LSystem system = system_of("axiom: AAAAAAAAAAAAAAAAAAAA\nA -> (1) B\nA -> (1) C\n");
  DeriveOptions options{.steps = 1, .seed = 1, .plant = StableId{1}};
  const auto grown_with = [&](std::uint64_t seed, std::uint64_t plant) {
    options.seed = seed;
    options.plant = StableId{plant};
    return derive(system, options).string.kinds;
  };
  EXPECT_EQ(grown_with(1, 1), grown_with(1, 1));
  EXPECT_NE(grown_with(1, 1), grown_with(2, 1));
  EXPECT_NE(grown_with(1, 1), grown_with(1, 2));
}

TEST(Chance, OfParametersIsUniformAndNormal) {
  const LSystem system = system_of("axiom: " + std::string(10'000, 'A') + "\nA -> B(ran(2), nran(5, 3))");
  const Derivation derivation = derive(system, {.steps = 1});
  double uniform = 0, normal = 0, square = 0;
  for (std::size_t i = 0; i < derivation.string.values.size(); i += 2) {
    uniform += derivation.string.values[i] / 10'000;
    normal += derivation.string.values[i + 1] / 10'000;
    square += (derivation.string.values[i + 1] - 5) * (derivation.string.values[i + 1] - 5) / 10'000;
  }
  EXPECT_NEAR(uniform, 1, 0.03);
  EXPECT_NEAR(normal, 5, 0.12);
  EXPECT_NEAR(square, 9, 0.6);
}

TEST(Cutting, TakesTheRestOfTheBranch) {
  const std::string text = "axiom: A[BCD[E]F]G\nC -> %";
  EXPECT_EQ(grown(text, 1), "A[B%D[E]F]G");
  EXPECT_EQ(grown(text, 2), "A[B]G");
  EXPECT_EQ(grown("axiom: AB%C[D]\n", 1), "AB");
}

TEST(Decomposition, FollowsEachStepToItsDepth) {
  const std::string text = "axiom: A\nA -> AB\ndecomposition:\nmaximum depth: 2\nB -> bC\nC -> cD\nD -> d";
  EXPECT_EQ(grown(text, 1), "AbcD");
  EXPECT_EQ(grown(text, 2), "AbcDbcd");
}

TEST(Interpretation, LeavesTheDerivationAlone) {
  const LSystem system = system_of("axiom: A(2)\nA(x) -> A(x+1)B\ninterpretation:\nA(x) -> F(x)B\nB -> [f]");
  const Derivation derivation = derive(system, {.steps = 2});
  EXPECT_EQ(text_of(system, derivation.string), "A(4)BB");
  EXPECT_EQ(text_of(system, interpret(system, derivation.string).string), "F(4)B[f][f]");
}

TEST(Limits, CutAnExplosiveSystemAtAWholeString) {
  const LSystem system = system_of("axiom: F\nn: 40\nF -> FFFFFFFFFF");
  const Derivation derivation = derive(system);
  ASSERT_TRUE(derivation.limit_exceeded);
  EXPECT_EQ(limit_line(system, *derivation.limit_exceeded),
            "x.lsys: stopped at step 7: the string would have more than 8000000 symbols");
  EXPECT_EQ(derivation.steps, 6);
  EXPECT_EQ(derivation.string.kinds.size(), 1'000'000u);
}

TEST(Limits, CutWhatWouldNeverEnd) {
  const LSystem still = system_of("axiom: F\nn: 1000000000\nF -> F");
  EXPECT_EQ(derive(still).limit_exceeded->kind, LimitKind::kSteps);
  const LSystem empty = system_of("axiom: F\nn: 1000000000\nF -> ");
  EXPECT_EQ(derive(empty).limit_exceeded->kind, LimitKind::kSteps);
  DeriveOptions options;
  options.limits.written = 10'000;
  const Derivation derivation = derive(system_of("axiom: FFFFFFFFFF\nn: 100000\nF -> F"), options);
  EXPECT_EQ(derivation.limit_exceeded->kind, LimitKind::kWritten);
  EXPECT_LE(derivation.written, 10'000u);
  EXPECT_EQ(derivation.string.kinds.size(), 10u);
}

TEST(Limits, CutTooManyConditions) {
  // ten thousand rules that never fit, and a string that never grows
  std::string text = "axiom: AAAAAAAAAA\nn: 100000\n";
  for (int i = 0; i < 10'000; ++i) text += "A : 1 > 2 -> B\n";
  DeriveOptions options;
  options.limits.work = 10'000'000;
  EXPECT_EQ(derive(system_of(text + "A -> A"), options).limit_exceeded->kind, LimitKind::kWork);
}

TEST(Limits, HoldForDecompositionAndNumbers) {
  DeriveOptions options;
  options.limits.symbols = 1'000;
  const LSystem system = system_of("axiom: F\nn: 4\ndecomposition:\nmaximum depth: 60\nF -> FF");
  EXPECT_EQ(derive(system, options).limit_exceeded->kind, LimitKind::kSymbols);
  EXPECT_LE(derive(system, options).string.kinds.size(), 1'000u);
  const LSystem wide = system_of("axiom: A\nn: 20\nA -> AB(1,2,3,4,5,6,7,8,9,10)A");
  EXPECT_LE(derive(wide, options).string.values.size(), 4'000u);
}

TEST(Limits, AreNamedIfTheInterpretationForAQueryExceedsThem) {
  DeriveOptions options;
  options.limits.symbols = 1'000;
  const LSystem large = system_of("axiom: F?H(0)\ninterpretation:\nmaximum depth: 9\nF -> FFFFFFFFFF");
  const Derivation derivation = derive(large, options);
  ASSERT_TRUE(derivation.limit_exceeded);
  EXPECT_EQ(derivation.limit_exceeded->kind, LimitKind::kSymbols);
  EXPECT_EQ(limit_line(large, *derivation.limit_exceeded),
            "x.lsys: stopped at step 0: the string would have more than 1000 symbols");
  options.limits.work = 50;
  std::string text = "axiom: F?H(0)\ninterpretation:\n";
  for (int i = 0; i < 100; ++i) text += "F : 1 > 2 -> G\n";
  const Derivation slow = derive(system_of(text), options);
  ASSERT_TRUE(slow.limit_exceeded);
  EXPECT_EQ(slow.limit_exceeded->kind, LimitKind::kWork);
}

TEST(Troubles, StandForNumbersWithoutValue) {
  const LSystem system = system_of("axiom: A(0)A(2)A(0)\nA(x) -> F(1/x)G(sqrt(0-x)) ");
  const Derivation derivation = derive(system, {.steps = 1});
  EXPECT_EQ(text_of(system, derivation.string), "F(0)G(0)F(0.5)G(0)F(0)G(0)");
  ASSERT_EQ(derivation.warnings.size(), 2u);
  EXPECT_EQ(warning_line(system, derivation.warnings[0]),
            "x.lsys:2:11: no number comes of this: 0 stands for it (2 times)");
  EXPECT_EQ(derivation.warnings[1].times, 1u);
}

TEST(Troubles, AreManyAtMost) {
  std::string text = "axiom: A(0)\nA(x) -> ";
  for (int i = 0; i < 300; ++i) text += "B(1/x)";
  const Derivation derivation = derive(system_of(text), {.steps = 1});
  EXPECT_EQ(derivation.warnings.size(), 101u);
  EXPECT_EQ(derivation.warnings.back().times, 200u);
}

TEST(Troubles, InConditionsAreFalse) {
  EXPECT_EQ(grown("axiom: A(0)\nA(x) : sqrt(x - 1) -> B", 1), "A(0)");
  EXPECT_EQ(grown("axiom: A(0)\nA(x) -> (1/x) B\nA(x) -> (sqrt(x-1)) C", 1), "A(0)");
}

}  // namespace
}  // namespace citykiln::lsystems
