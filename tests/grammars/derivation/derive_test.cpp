#include "grammars/derivation/derive.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/grammars/on_lot.h"

namespace citykiln::grammars {
namespace {

TEST(Derive, WhatNoRuleKnowsIsATerminal) {
  const auto derivation = derived("Lot --> A B.\nA --> extrude(2) comp(f) { top : Roof | side : Wall }");
  EXPECT_EQ(count_named(derivation, "Roof"), 1u);
  EXPECT_EQ(count_named(derivation, "Wall"), 4u);
  EXPECT_EQ(count_named(derivation, "B"), 1u);
  EXPECT_EQ(path_name(derivation, named(derivation, "Wall")[0]->path), "Lot/A/Wall");
}

TEST(Derive, AShapeChangedAfterItsLastSuccessorIsATerminalOfItsRule) {
  const auto derivation = derived("Lot --> A extrude(3)\nA --> color(\"#102030\")");
  ASSERT_EQ(derivation.terminals.size(), 2u);
  EXPECT_EQ(derivation.terminals[0].name, "A");
  EXPECT_EQ(derivation.terminals[1].name, "Lot");
  EXPECT_EQ(derivation.terminals[1].faces.size(), 6u);
}

TEST(Derive, OfALotWithoutCornersMakesNothing) {
  const Program program = program_of("Lot --> extrude(3) innerRectangle() { shape : X. } comp(f) { all : Y. }");
  for (const Ring& ring : {Ring{}, Ring{{0, 0}}, Ring{{0, 0}, {4, 0}}}) {
    const Shape nothing = lot({ring, {}}, 2, 3, StableId{1}, {0, 7});
    EXPECT_TRUE(nothing.faces.empty());
    EXPECT_TRUE(derive(program, nothing, {}).terminals.empty());
  }
}

TEST(Derive, NilLeavesNothing) {
  EXPECT_TRUE(derived("Lot --> NIL").terminals.empty());
  EXPECT_EQ(derived("Lot --> split(x) { { ~1 : A | ~1 : NIL }* }").terminals.size(), 5u);
}

TEST(Derive, ParametersReachTheirRules) {
  EXPECT_EQ(derived("Lot --> split(x) { { ~2 : Tile(split.index, scope.sx) }* }\n"
                    "Tile(n, w) --> with( sum := n + w ) case sum > 4 : print(sum) A else : B")
                .printed,
            (std::vector<std::string>{"5", "6"}));
}

TEST(Derive, SharesAreDrawnAsOften) {
  const auto derivation = derived("Lot --> split(x) { { 0.001 : Tile }* }\nTile --> 30% : A 20% : B else : C");
  EXPECT_NEAR(static_cast<double>(count_named(derivation, "A")), 3000, 200);
  EXPECT_NEAR(static_cast<double>(count_named(derivation, "B")), 2000, 200);
  EXPECT_NEAR(static_cast<double>(count_named(derivation, "C")), 5000, 200);
}

// ---- ids and random numbers

const char* const kHouse =
    "attr h = rand(6, 12)\n"
    "Lot --> extrude(h) comp(f) { side : Facade | top : Roof }\n"
    "Facade --> split(y) { { ~3 : Floor }* }\n"
    "Floor --> split(x) { { ~2 : Tile }* }\n"
    "Tile --> 50% : color(rand, rand, rand) A else : extrude(rand(0.1, 0.3)) B\n"
    "Roof --> X";

TEST(Identity, NoTwoTerminalsShareOne) {
  const auto derivation = derived(kHouse);
  std::set<StableId> ids;
  EXPECT_GT(derivation.terminals.size(), 50u);
  for (const Terminal& terminal : derivation.terminals) EXPECT_TRUE(ids.insert(terminal.id).second);
}

bool same(const Terminal& a, const Terminal& b) { return a.id == b.id && a.name == b.name && a.faces == b.faces; }

TEST(Identity, TheSameArgumentsGiveTheSameBytes) {
  const auto a = derived(kHouse), b = derived(kHouse);
  ASSERT_FALSE(a.terminals.empty());
  ASSERT_EQ(a.terminals.size(), b.terminals.size());
  for (std::size_t i = 0; i < a.terminals.size(); ++i) EXPECT_TRUE(same(a.terminals[i], b.terminals[i]));
  EXPECT_EQ(a.appearances, b.appearances);
}

TEST(Identity, AsksForNothingElse) {
  const std::string text =
      "Lot --> extrude(rand(3, 6)) comp(f) { all : split(x) { { ~2 : report(\"n\", 1) Tile }* } }\n"
      "Tile --> 50% : A. else : B.";
  DeriveOptions without;
  without.ids = false;
  Derivation a = derived(text), b = derived(text, 10, 8, without);
  ASSERT_EQ(a.terminals.size(), b.terminals.size());
  EXPECT_EQ(a.steps, b.steps);
  for (std::size_t i = 0; i < a.terminals.size(); ++i) {
    EXPECT_EQ(a.terminals[i].name, b.terminals[i].name);
    EXPECT_EQ(a.terminals[i].faces, b.terminals[i].faces);
    EXPECT_NE(a.terminals[i].id, StableId{});
    EXPECT_EQ(b.terminals[i].id, StableId{});
  }
  for (const Reported& reported : a.reports) EXPECT_NE(reported.shape, StableId{});
}

TEST(Chance, OfAShapeDoesNotDependOnItsSiblings) {
  // the second program draws more numbers before the same pieces, and derives them in another order
  const char* const kTiles = "Tile --> t(0, 0, rand) A\nOther --> 50% : t(0, 0, rand) C else : D D D\n";
  const auto plain = derived(std::string("Lot --> split(x) { ~1 : Tile | ~1 : Tile }\n") + kTiles);
  const auto busy =
      derived(std::string("Lot --> split(x) { ~1 : { Tile Other Other } | ~1 : { Tile Other } }\n") + kTiles);
  const auto a = named(plain, "A"), b = named(busy, "A");
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(same(*a[i], *b[i]));
}

TEST(Chance, DiffersBetweenBuildingsAndSeeds) {
  const Program program = program_of(kHouse);
  std::set<double> heights;
  for (std::uint64_t id = 1; id <= 20; ++id)
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      DeriveOptions options;
      options.seed = seed;
      const auto derivation = derive(program, lot_of(10, 8, id), options);
      heights.insert(named(derivation, "X").at(0)->faces[0].outer[0].z);
    }
  EXPECT_EQ(heights.size(), 100u);
}

TEST(Chance, IsTheSameAtAnyTolerance) {
  DeriveOptions coarse;
  coarse.tolerance_m = 0.05;
  const auto full = derived(kHouse), cut = derived(kHouse, 10, 8, coarse);
  EXPECT_EQ(full.shapes, cut.shapes);
  EXPECT_EQ(full.steps, cut.steps);
  std::set<StableId> ids;
  for (const Terminal& terminal : full.terminals) ids.insert(terminal.id);
  for (const Terminal& terminal : cut.terminals) EXPECT_EQ(ids.contains(terminal.id), !terminal.simplified);
}

// ---- context queries

TEST(ContextQuery, PrismsAnswerInsideOverlapsTouches) {
  DeriveOptions options;
  // a neighbour along the whole west side, half as high, and one that stands in the north east corner
  options.answer_context_query = answer_from_neighbours(
      {{{{{-5, 0}, {0, 0}, {0, 8}, {-5, 8}}, {}}, 0, 5}, {{{{9, 7}, {12, 7}, {12, 12}, {9, 12}}, {}}, 0, 20}});
  const char* const kRules =
      "Lot --> extrude(5) comp(f) { left : L | back : B | front : F | all : NIL }\n"
      "L --> case touches() : Touches case inside() : LInside else : LFree\n"
      "B --> case inside() : BInside case overlaps() : BOverlaps else : BFree\n"
      "F --> case inside() || overlaps() || touches() : FMeets else : FFree";
  const auto derivation = derived(kRules, 10, 8, options);
  EXPECT_EQ(count_named(derivation, "LInside"), 1u);
  EXPECT_EQ(count_named(derivation, "BOverlaps"), 1u);
  EXPECT_EQ(count_named(derivation, "FMeets"), 1u);
}

// Exactly one of several adjacent pieces has the entrance.
TEST(ContextQuery, EntrancesAreInOnePieceOfTheirWall) {
  DeriveOptions options;
  options.answer_context_query = answer_from_entrances({{2, 0}, {7.5, 0.25}});
  const auto derivation = derived(
      "Lot --> extrude(5) comp(f) { side : split(x) { { 1 : Piece }* } | all : NIL }\n"
      "Piece --> case has_entrance() : Door. else : Wall.",
      10, 8, options);
  std::vector<double> middles;
  for (const Terminal& terminal : derivation.terminals)
    if (terminal.name == "Door") middles.push_back(terminal.scope.centre().x);
  std::sort(middles.begin(), middles.end());
  EXPECT_EQ(middles, (std::vector<double>{2.5, 7.5}));
  EXPECT_EQ(count_named(derivation, "Wall"), 34u);
}

// Equal pieces are not copied where only some are lit.
TEST(ContextQuery, PiecesAreLitWhereTheirPlaceSays) {
  DeriveOptions options;
  options.answer_context_query = [](ContextQuery query, const Shape& shape) {
    return query == ContextQuery::kIsLit && shape.scope.centre().x < 3;
  };
  const auto derivation = derived(
      "Lot --> extrude(5) comp(f) { front : split(x) { { 1 : Piece }* } | all : NIL }\n"
      "Piece --> case is_lit() : Lit. else : case has_entrance() : Door. else : Dark.",
      10, 8, options);
  EXPECT_EQ(count_named(derivation, "Lit"), 3u);
  EXPECT_EQ(count_named(derivation, "Dark"), 7u);
}

// ---- limits

TEST(Derive, RulesThatCallThemselvesTwiceEndSoon) {
  const Program program = program_of("Lot --> A(1)\nA(n) --> A(n + 1) A(n + 1)");
  const Derivation derivation = derive(program, lot_of(10, 8), {});
  EXPECT_LT(derivation.shapes, 10 * kMostDepthHits);
  const std::vector<RuleFault> faults = rule_faults(program, derivation);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_TRUE(
      faults[0].text.ends_with(":2:1, rule A: the limit of depth is reached; the rule calls itself without end"))
      << faults[0].text;
  EXPECT_GE(faults[0].times, kMostDepthHits);
}

TEST(Derive, FaultsNameTheDefinitionThatHasThem) {
  const Program program = program_of(
      "attr n = 0\nf(x) = x / n\nLot --> A\nA --> extrude(f(1) + 3)\n"
      "comp(f) { side : split(x) { { -1 : W. }* } | top : R. }");
  std::vector<std::string> texts;
  for (const RuleFault& fault : rule_faults(program, derive(program, lot_of(10, 8), {}))) texts.push_back(fault.text);
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_TRUE(texts[0].ends_with(":2:10, function f: division by zero")) << texts[0];
  EXPECT_TRUE(texts[1].ends_with(", rule A: a size of -1 in a repeated group; it counts as 0")) << texts[1];
}

TEST(Limits, DepthEndsEndlessRulesAndSaysWhere) {
  const Program program = program_of("Lot --> A\nA --> t(0, 1, 0) A");
  const auto derivation = derive(program, lot_of(10, 8), {});
  ASSERT_EQ(derivation.limits.size(), 1u);
  EXPECT_EQ(limit_line(program, derivation.limits[0]),
            "test.cga:2:1: the limit of depth ended 1 shapes, the first of rule A");
  EXPECT_EQ(derivation.terminals.size(), 1u);
}

TEST(Limits, ShapesEndRulesThatMultiply) {
  DeriveOptions options;
  options.limits.shapes = 1000;
  const auto derivation = derived("Lot --> A A A\nA --> A A A", 10, 8, options);
  ASSERT_FALSE(derivation.limits.empty());
  EXPECT_LT(derivation.terminals.size(), 2000u);
}

TEST(Limits, ASplitIntoTooManyIsNotMade) {
  DeriveOptions options;
  options.limits.shapes = 1000;
  const auto derivation = derived("Lot --> split(x) { { 0.001 : A }* }", 10, 8, options);
  ASSERT_EQ(derivation.limits.size(), 1u);
  EXPECT_EQ(derivation.limits[0].kind, LimitKind::kShapes);
  EXPECT_EQ(derivation.terminals.size(), 1u);
}

TEST(Limits, StepsEndLongWork) {
  DeriveOptions options;
  options.limits.steps = 20'000;
  const auto derivation =
      derived("f(x) = case x <= 0 : 1 else : f(x - 1) + f(x - 1)\nLot --> extrude(f(40)) A", 10, 8, options);
  ASSERT_FALSE(derivation.limits.empty());
  EXPECT_EQ(derivation.limits[0].kind, LimitKind::kSteps);
}

TEST(Limits, TheDeepestProgramFitsTheStack) {
  // nested rules and blocks with recursive functions in nested parentheses, each to its limit
  std::string blocks, ends, open, close;
  for (int i = 0; i < 30; ++i) blocks += "{ ", ends += " }";
  for (int i = 0; i < 28; ++i) open += "max(0, -", close += ")";
  const std::string text = "f(x) = 1 + " + open + "f(x)" + close + "\nLot --> " + blocks + "Lot print(f(1))" + ends;
  const auto derivation = derived(text);
  ASSERT_FALSE(derivation.limits.empty());
  EXPECT_EQ(derivation.limits[0].kind, LimitKind::kDepth);
}

TEST(Limits, AreTheSameAtAnyTolerance) {
  const Program program =
      program_of("Lot --> extrude(9) comp(f) { side : A }\nA --> split(x) { ~1 : A | ~1 : B | ~1 : A }");
  DeriveOptions options;
  options.limits.shapes = 5000;
  const auto full = derive(program, lot_of(10, 8), options);
  options.tolerance_m = 0.5;
  const auto cut = derive(program, lot_of(10, 8), options);
  ASSERT_EQ(full.limits.size(), 1u);
  ASSERT_EQ(cut.limits.size(), 1u);
  EXPECT_EQ(full.limits[0].times, cut.limits[0].times);
}

}  // namespace
}  // namespace citykiln::grammars
