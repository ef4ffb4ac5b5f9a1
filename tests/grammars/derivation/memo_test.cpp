// Copies of equal shapes agree with their own derivations.
#include "grammars/derivation/memo.h"

#include <gtest/gtest.h>

#include "tests/grammars/on_lot.h"
#include "tests/grammars/rule_files.h"

namespace citykiln::grammars {
namespace {

// Away from the origin and turned, so that all rounding errors differ.
Shape turned_lot() {
  Ring ring;
  for (const Vec2 p : {Vec2{0, 0}, Vec2{18.3, 0}, Vec2{18.3, 12.1}, Vec2{0, 12.1}})
    ring.push_back({3071.7 + 0.8 * p.x - 0.6 * p.y, -811.3 + 0.6 * p.x + 0.8 * p.y});
  return lot({ring, {}}, 117.3, 0, StableId{9}, {0, 2});
}

Derivation derived_with(bool copies, const Program& program, const Shape& first, double tolerance_m = 0) {
  DeriveOptions options;
  options.memoise = copies;
  options.tolerance_m = tolerance_m;
  return derive(program, first, options);
}

double farthest_m(const Face& a, const Face& b) {
  if (a.outer.size() != b.outer.size() || a.holes.size() != b.holes.size()) return 1e9;
  double farthest_m = 0;
  for (std::size_t i = 0; i < a.outer.size(); ++i) farthest_m = std::max(farthest_m, length(a.outer[i] - b.outer[i]));
  return farthest_m;
}

double farthest_m(const Terminal& a, const Terminal& b) {
  if (a.faces.size() != b.faces.size()) return 1e9;
  double far_m = length(a.scope.centre() - b.scope.centre());
  for (std::size_t i = 0; i < a.faces.size(); ++i) far_m = std::max(far_m, farthest_m(a.faces[i], b.faces[i]));
  return far_m;
}

double apart(const std::optional<TextureProjection>& a, const std::optional<TextureProjection>& b) {
  if (a.has_value() != b.has_value()) return 1e9;
  if (!a) return 0;
  return length(a->origin - b->origin) + length(a->u_per_m - b->u_per_m) + length(a->v_per_m - b->v_per_m);
}

void expect_same(const Derivation& a, const Derivation& b) {
  EXPECT_EQ(a.shapes, b.shapes);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.appearances, b.appearances);
  EXPECT_EQ(a.printed, b.printed);
  EXPECT_EQ(a.warnings.size(), b.warnings.size());
  EXPECT_EQ(a.reports.size(), b.reports.size());
  for (std::size_t i = 0; i < std::min(a.reports.size(), b.reports.size()); ++i)
    EXPECT_TRUE(a.reports[i].shape == b.reports[i].shape && a.reports[i].value == b.reports[i].value);
  ASSERT_EQ(a.terminals.size(), b.terminals.size());
  for (std::size_t i = 0; i < a.terminals.size(); ++i) {
    const Terminal &x = a.terminals[i], &y = b.terminals[i];
    ASSERT_TRUE(x.id == y.id && x.name == y.name && x.appearance == y.appearance && x.path == y.path &&
                x.simplified == y.simplified)
        << i;
    ASSERT_LT(farthest_m(x, y), 4 * kSame_m) << i << " " << path_name(a, x.path);
    ASSERT_LT(apart(x.texture, y.texture), 4 * kSame_m) << i << " " << path_name(a, x.path);
    ASSERT_NEAR(x.error_m, y.error_m, 64 * kSame_m) << i;
  }
}

TEST(Copies, AreWhatTheirOwnDerivationsWouldBe) {
  const Result<Program> program = read_rules("old_town_house.cga", shipped);
  ASSERT_TRUE(program) << to_string(program.error());
  for (const double tolerance_m : {0.0, 0.02, 0.1, 0.5, 2.5}) {
    SCOPED_TRACE(tolerance_m);
    expect_same(derived_with(true, *program, turned_lot(), tolerance_m),
                derived_with(false, *program, turned_lot(), tolerance_m));
  }
}

struct CopiedRule {
  const char* name;
  const char* tile;
};

struct Tiles : testing::TestWithParam<CopiedRule> {};

TEST_P(Tiles, AreTheSameWithoutCopies) {
  const Program program =
      program_of(std::string("attr tint = rand\nattr gap = 0.1\n"
                             "Lot --> tileUV(0, 2, 2) setupProjection(0, scope.xz, 3, 3) extrude(9.3) comp(f) { side : "
                             "Facade | all : Roof. }\n"
                             "Facade --> split(y) { { ~3 : split(x) { { ~2 : Tile }* } }* }\n"
                             "Niche --> extrude(-0.2) comp(f) { front : NIL | all : reverseNormals() Block. }\n") +
                 GetParam().tile);
  DeriveOptions options;
  for (const double tolerance_m : {0.0, 0.15, 0.4, 3.0}) {
    SCOPED_TRACE(tolerance_m);
    expect_same(derived_with(true, program, turned_lot(), tolerance_m),
                derived_with(false, program, turned_lot(), tolerance_m));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Table, Tiles,
    testing::Values(
        CopiedRule{"Niches", "Tile --> setback(0.3) { all = Frame. | remainder : Niche }"},
        // adjacent tiles are divided at the same heights
        CopiedRule{"Borders",
                   "Tile --> split(y) { ~1 : A. | 1.07 : split(x) { ~1 : B. | 0.41 : A. | ~2 : Niche } | ~1.3 : A. }"},
        // faces without area, whose scopes have no axes
        CopiedRule{"Flat",
                   "Tile --> primitiveCube() comp(f) { all : B }\nB --> extrude(0.2) split(x) { ~1 : X. | ~2 : Y. }"},
        CopiedRule{"Chance",
                   "Tile --> setback(0.3) { all = Frame. | remainder : 50% : Niche else : t(0, 0, rand) X. }"},
        CopiedRule{
            "ChanceBetweenWays",
            "Tile --> setback(0.3) { all = Frame. | remainder : A }\n"
            "A --> extrude(-0.2) comp(f) { front : NIL | back : split(x) { ~1 : Pane | ~1 : Pane } | all : X. }\n"
            "Pane --> 40% : color(tone, 0, 0) Glass. 30% : color(0, 1, 0) split(y) { ~1 : Glass. | 0.1 : Bar. }\n"
            "  else : case p(0.5) : t(0, 0, 0.1) Blind. else : NIL\n"
            "tone = 50% : 0.25 else : 0.5"},
        CopiedRule{"ChanceOfTheBuilding", "Tile --> color(tint, 0, 0) setback(0.3) { all = F. | remainder : Niche }"},
        CopiedRule{"ThePlace", "Tile --> setback(0.3) { all = F. | remainder : t(0, 0, scope.ty / 100) Niche }"},
        CopiedRule{"TheIndex",
                   "Tile --> setback(0.3) { all = F. | remainder : case split.index % 2 == 0 : Niche else : X. }"},
        CopiedRule{"AnIndexOfItsOwn",
                   "Tile --> setback(0.3) { all = F. | remainder : split(y) { { ~0.5 : T }* } }\n"
                   "T --> t(0, 0, split.index / 10) extrude(0.1) comp(f) { all : X. }"},
        CopiedRule{"TheParent", "Tile --> setback(0.3) { all = F. | remainder : s('0.5, '0.5, '1) center(xy) Niche }"},
        CopiedRule{"Attributes",
                   "Tile --> setback(0.3) { all = F. | remainder : set(gap, split.index / 5) A }\n"
                   "A --> extrude(gap) comp(f) { all : X. }"},
        CopiedRule{"Textures",
                   "Tile --> setback(0.3) { all = projectUV(0) F. | remainder : A }\n"
                   "A --> tileUV(0, 1, 1) extrude(0.2) comp(f) { front : X. | top : tileUV(0, 3, 1) Y. | all : "
                   "projectUV(0) Z. }"},
        CopiedRule{"TheWorld",
                   "Tile --> setback(0.3) { all = F. | remainder : A }\n"
                   "A --> setupProjection(0, world.xy, 1, 1) projectUV(0) extrude(0.2) comp(f) { all : X. }"},
        CopiedRule{"Reports",
                   "Tile --> setback(0.3) { all = F. | remainder : report(\"area\", scope.sx) print(\"x\") A }\n"
                   "A --> report(\"a\", 1) extrude(0.2) comp(f) { all : report(\"b\", true) X. }"},
        CopiedRule{"Assets",
                   "Tile --> setback(0.3) { all = F. | remainder : A }\n"
                   "A --> [ i(\"lamp\") L. ] extrude(0.2) comp(f) { all : X. }"},
        CopiedRule{"Troubles",
                   "Tile --> setback(0.3) { all = F. | remainder : A }\n"
                   "A --> extrude(1 / 0) extrude(0.2) comp(f) { all : X. }"},
        CopiedRule{"Up",
                   "Tile --> setback(0.3) { all = F. | remainder : r(scopeCenter, 10, 0, 0) A }\n"
                   "A --> extrude(world.up, 0.2) comp(f) { vertical : X. | all : alignScopeToGeometry() Y. }"},
        CopiedRule{
            "Axes",
            "Tile --> setback(0.3) { all = F. | remainder : A }\n"
            "A --> alignScopeToAxes() s('1.1, '1, '1) comp(f) { all : B }\nB --> extrude(0.2) comp(f) { all : X. }"}),
    [](const auto& row) { return std::string(row.param.name); });

// Random choices between a few branches do not prevent copies.
TEST(Copies, AreMadeOfWhatTheDiceChooseToo) {
  const Program program = program_of(
      "Lot --> extrude(12) comp(f) { side : split(y) { { ~3 : split(x) { { 2 : Tile }* } }* } | all : Roof. }\n"
      "Tile --> setback(0.3) { all = Frame. | remainder : A }\n"
      "A --> extrude(-0.2) comp(f) { front : NIL | back : B | all : X. }\n"
      "B --> 90% : Glass. else : color(1, 0, 0) Glass.");
  const Derivation derivation = derived_with(true, program, turned_lot());
  // of 25 windows a few are the first of their kind
  EXPECT_GT(derivation.copied * 2, derivation.shapes);
}

TEST(Copies, AreAlikeBesideTheStreetWhereNobodyAsksForIt) {
  const auto copied = [](const std::string& of_tile) {
    const Program program = program_of(
        "Lot --> extrude(6) comp(f) { side : split(x) { { ~2 : Tile }* } | all : Roof. }\n"
        "Tile --> setback(0.3) { all = Frame. | remainder : extrude(0.2) " +
        of_tile + " }");
    const Shape first = lot({{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {}}, 0, 0, StableId{1}, {0});
    DeriveOptions options;
    options.ids = false;
    const Derivation with = derive(program, first, options);
    options.memoise = false;
    expect_same(with, derive(program, first, options));
    return with.copied;
  };
  EXPECT_GT(copied("comp(f) { front : A. | all : B. }"), copied("comp(f) { street : A. | all : B. }"));
}

TEST(Copies, LimitsEndThemAsTheyEndRules) {
  const Program program = program_of(
      "Lot --> extrude(9.3) comp(f) { side : Facade | all : Roof. }\n"
      "Facade --> split(y) { { ~1 : split(x) { { ~1 : Tile }* } }* }\n"
      "Tile --> setback(0.1) { all : F. | remainder : extrude(0.2) comp(f) { all : X. } }");
  for (const std::uint64_t most : {100u, 731u, 1500u}) {
    DeriveOptions options;
    options.limits.shapes = most;
    const Derivation copied = derive(program, turned_lot(), options);
    options.memoise = false;
    const Derivation own = derive(program, turned_lot(), options);
    expect_same(copied, own);
    ASSERT_EQ(own.limits.size(), 1u);
    ASSERT_EQ(copied.limits.size(), own.limits.size());
    for (std::size_t i = 0; i < own.limits.size(); ++i) EXPECT_EQ(copied.limits[i].times, own.limits[i].times);
  }
}

TEST(Copies, EndWhereTheirOwnDerivationsWouldBeTooDeep) {
  const Program program = program_of(
      "Lot --> extrude(6) comp(f) { side : split(x) { { ~2 : Tile | ~2 : Inner }* } | all : Roof. }\nInner --> Tile\n"
      "Tile --> setback(0.1) { all : F. | remainder : A }\nA --> B\nB --> extrude(0.2) comp(f) { all : C }\nC --> X.");
  for (int depth = 2; depth < 12; ++depth) {
    DeriveOptions options;
    options.ids = false, options.limits.depth = depth;
    const Derivation copied = derive(program, turned_lot(), options);
    options.memoise = false;
    const Derivation own = derive(program, turned_lot(), options);
    EXPECT_TRUE(copied.copied > 0 || !own.limits.empty()) << depth;
    expect_same(copied, own);
    ASSERT_EQ(copied.limits.size(), own.limits.size()) << depth;
    for (std::size_t i = 0; i < own.limits.size(); ++i) EXPECT_EQ(copied.limits[i].times, own.limits[i].times);
  }
}

}  // namespace
}  // namespace citykiln::grammars
