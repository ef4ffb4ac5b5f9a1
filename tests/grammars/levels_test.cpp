// Levels of detail: a surface simplified at a tolerance is within its stated error.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "grammars/derivation/memo.h"
#include "tests/grammars/on_lot.h"
#include "tests/grammars/plain_roof.h"
#include "tests/grammars/surfaces.h"
#include "tests/test_files.h"

namespace citykiln::grammars {
namespace {

struct Levels : testing::Test {
  std::mt19937 chance{2};
  double unit() { return static_cast<double>(chance()) / 4294967296.0; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  std::string metres_text(double low, double high) { return std::to_string(between(low, high)); }

  double sampled_m(const std::vector<Triangle3>& from, const std::vector<Triangle3>& to) {
    return grammars::sampled_m(from, to, 300, [&] { return chance(); });
  }

  /// The name of a rule below `level`, a terminal or NIL.
  std::string successor(int level) {
    const unsigned kind = chance() % 8;
    if (kind == 0) return "NIL";
    if (kind == 1 || level >= 5) return "End.";
    return "R" + std::to_string(level + 1 + chance() % (5 - level));
  }

  std::string parts(int level, std::vector<std::string> selectors) {
    std::string text = " { ";
    for (std::size_t i = 0; i < selectors.size(); ++i)
      text += (i ? " | " : "") + selectors[i] + (chance() % 5 == 0 ? " = " : " : ") + successor(level);
    return text + " }";
  }

  std::string division(int level) {
    std::string text = " { ";
    for (unsigned i = 0, n = 1 + chance() % 3; i < n; ++i) {
      const char* const kSigns[] = {"", "'", "~"};
      const unsigned kind = chance() % 3;
      text += (i ? " | " : "") + std::string(kSigns[kind]) + metres_text(0.1, kind == 1 ? 0.6 : 3) + " : " +
              successor(level);
    }
    if (chance() % 2) text += " | { ~" + metres_text(0.5, 3) + " : " + successor(level) + " }*";
    return text + " }";
  }

  /// The last statement of a rule: a split, comp or successor.
  std::string ending(int level) {
    switch (chance() % 8) {
      case 0:
        return parts(level, {"front", "top", "side"}).insert(0, "comp(f)");
      case 1:
        return parts(level, {"all"}).insert(0, "comp(f)");
      case 2:
        return parts(level, {"all", "remainder"}).insert(0, "setback(" + metres_text(0.05, 1) + ")");
      case 3:
        return parts(level, {"front", "left", "remainder"}).insert(0, "setback(" + metres_text(0.05, 1) + ")");
      case 4:
        return parts(level, {"shape", "remainder"})
            .insert(0, "shapeL(" + metres_text(0.2, 2) + ", " + metres_text(0.2, 2) + ")");
      case 5:
        return successor(level) + " " + successor(level);
      default:
        return std::string("split(") + "xyz"[chance() % 3] + ")" + division(level);
    }
  }

  std::string operation() {
    switch (chance() % 12) {
      case 0:
        return "t(" + metres_text(-0.3, 0.3) + ", " + metres_text(-0.3, 0.3) + ", " + metres_text(-0.3, 0.3) + ")";
      case 1:
        return "r(scopeCenter, 0, 0, " + metres_text(-8, 8) + ")";
      case 2:
        return "s('" + metres_text(0.8, 1.1) + ", '" + metres_text(0.8, 1.1) + ", '1)";
      case 3:
        return "extrude(" + metres_text(-0.6, 0.6) + ")";
      case 4:
        return "extrude(world.up, " + metres_text(0.1, 2) + ")";
      case 5:
        return "taper(" + metres_text(0.1, 1) + ")";
      case 6:
        return "offset(" + metres_text(-0.5, 0.5) + ")";
      case 7:
        return "offset(" + metres_text(-0.5, 0.5) + ", inside)";
      case 8:
        return "roofPyramid(30)";
      case 9:
        return "primitiveCube()";
      case 10:
        return "center(xyz)";
      default:
        return "color(rand, rand, rand)";
    }
  }

  std::string rules() {
    std::string text = "Lot --> extrude(" + metres_text(2, 9) + ") " + ending(0);
    for (int level = 1; level <= 5; ++level) {
      text += "\nR" + std::to_string(level) + " --> ";
      if (chance() % 2) text += operation() + " ";
      if (chance() % 4 == 0) text += "[ " + operation() + " " + successor(level) + " ] ";
      text += ending(level);
    }
    return text;
  }
};

TEST_F(Levels, SimplifiedSurfacesLieWithinTheStatedError) {
  int cut_ones = 0;
  double tightest = 0;
  for (int round = 0, rounds = quick_or_full(200, 600); round < rounds; ++round) {
    const std::string text = rules();
    const Program program = program_of(text);
    const Shape first = lot_of(between(3, 12), between(3, 12));
    DeriveOptions options;
    options.roofs = plain_roof;
    options.limits.shapes = 400;
    const Derivation whole = derive(program, first, options);
    const auto full = triangles_of(whole);
    if (full.empty() || full.size() > 2500) continue;
    for (const double tolerance_m : {0.05, 0.2, 0.6, 2.0, 8.0}) {
      options.tolerance_m = tolerance_m;
      // with fewer shapes a limit may not apply
      options.prune_early = round % 2 == 1 && whole.limits.empty();
      const Derivation derivation = derive(program, first, options);
      const auto cut = triangles_of(derivation);
      ASSERT_LE(derivation.error_m, tolerance_m);
      ASSERT_FALSE(cut.empty());
      if (derivation.error_m == 0) continue;
      ++cut_ones;
      const double measured_m = std::max(sampled_m(full, cut), sampled_m(cut, full));
      ASSERT_LE(measured_m, derivation.error_m + 1e-6) << "round " << round << " tolerance " << tolerance_m << "\n"
                                                       << text;
      tightest = std::max(tightest, measured_m / derivation.error_m);
    }
  }
  // the test measures simplified surfaces, and the bound is not much too large
  EXPECT_GT(cut_ones, 200);
  EXPECT_GT(tightest, 0.9);
}

// Boxes without height have faces without area, which bound no distance of a vanished sibling.
TEST_F(Levels, AreCertifiedBesideFacesWithoutArea) {
  const Program program = program_of(
      "Lot --> extrude(8.7) comp(f) { top : setback(0.4) { all : Flat | remainder = Flat } }\n"
      "Flat --> primitiveCube() [ taper(0.8) Cut ] comp(f) { front : End. | top : Cut | side = Cut }\n"
      "Cut --> split(x) { 1.5 : End. | 2 : NIL | { ~0.9 : End. }* }");
  for (int round = 0; round < 12; ++round) {
    const Shape first = lot_of(between(3, 12), between(3, 12));
    DeriveOptions options;
    const auto full = triangles_of(derive(program, first, options));
    ASSERT_FALSE(full.empty());
    options.tolerance_m = 0.6;
    const Derivation derivation = derive(program, first, options);
    const auto cut = triangles_of(derivation);
    ASSERT_FALSE(cut.empty());
    EXPECT_LE(std::max(sampled_m(full, cut), sampled_m(cut, full)), derivation.error_m + 1e-6);
  }
}

// Rules that can be pruned early, like those of facades: niches, reliefs and divisions of a wall.
struct PrunedLevels : Levels {
  std::string relief(int level) {
    const std::string depth = chance() % 3 ? metres_text(-0.4, 0.4) : "rand(0.1, " + metres_text(0.2, 0.4) + ")";
    const char* const kEnds[] = {"front", "back", "top", "left", "side", "vertical"};
    const auto end = [&] { return std::string(kEnds[chance() % 6]) + " : " + successor(level) + " | "; };
    return "extrude(" + depth + ") comp(f) { " + end() + end() + "all : " + successor(level) + " }";
  }

  std::string statements(int level) {
    std::string nudge = chance() % 4 ? "" : "t(0, 0, " + metres_text(-0.2, 0.2) + ") ";
    if (chance() % 4 == 0) nudge += "set(mode, " + std::to_string(chance() % 3) + ") ";
    switch (chance() % 4) {
      case 0:
        return nudge + parts(level, {"all", "remainder"}).insert(0, "setback(" + metres_text(0.05, 0.5) + ")");
      case 1:
        return nudge + "split(" + "xy"[chance() % 2] + ")" + division(level);
      case 2:
        return nudge + "[ " + relief(level) + " ] " + successor(level);
      default:
        return nudge + relief(level);
    }
  }

  /// A condition with a known value, except where an attribute is set on the way.
  std::string condition() {
    const char* const kConditions[] = {
        "!is_deep",         "mode == 1", "deep(0.3) > 0.5 || mode >= 2", "mode != 1 && is_deep", "mode == 2 && p(0.5)",
        "rand(1, 2) < mode"};
    return kConditions[chance() % 6];
  }

  std::string facades(bool are_coloured) {
    std::string text = "attr mode = 1\nconst is_deep = mode < 2\ndeep(d) = case is_deep : d else : 4 * d\n";
    text += "Lot --> extrude(" + metres_text(2, 9) + ") comp(f) { all : R1 }";
    for (int level = 1; level <= 5; ++level) {
      text += "\nR" + std::to_string(level) + " -->";
      if (!are_coloured && chance() % 3 == 0)
        text += "\n  case " + condition() + " : " + (chance() % 2 ? "NIL" : statements(level)) + "\n  else :";
      if (are_coloured && chance() % 3 == 0) text += " color(" + metres_text(0, 1) + ", 0, 0)";
      if (!are_coloured && chance() % 3 == 0)
        text += "\n  case scope.sx > " + metres_text(0.5, 4) + " : " + statements(level) + "\n  else :";
      text += " " + statements(level);
    }
    return text;
  }
};

// With appearances kept, less is simplified, except narrow pieces, which are merged into their neighbours.
struct KeptLevels : PrunedLevels, testing::WithParamInterface<bool> {};

TEST_P(KeptLevels, LieWithinTheStatedError) {
  int ended = 0;
  double tightest = 0;
  for (int round = 0; round < 200; ++round) {
    const std::string text = facades(GetParam());
    const Program program = program_of(text);
    const Shape first = lot_of(between(3, 8), between(3, 8));
    DeriveOptions options;
    options.keep_appearances = GetParam();
    options.limits.shapes = 4000;
    const Derivation whole = derive(program, first, options);
    const auto full = triangles_of(whole);
    if (full.empty() || full.size() > 1500 || !whole.limits.empty()) continue;
    options.prune_early = true;
    for (const double tolerance_m : {0.2, 0.6, 2.0}) {
      options.tolerance_m = tolerance_m;
      const Derivation derivation = derive(program, first, options);
      ASSERT_LE(derivation.error_m, tolerance_m);
      if (derivation.shapes == whole.shapes) continue;
      ++ended;
      const auto cut = triangles_of(derivation);
      const double measured_m = std::max(sampled_m(full, cut), sampled_m(cut, full));
      ASSERT_LE(measured_m, derivation.error_m + 1e-6) << "round " << round << " tolerance " << tolerance_m << "\n"
                                                       << text;
      tightest = std::max(tightest, measured_m / derivation.error_m);
    }
  }
  EXPECT_GT(ended, 100);
  EXPECT_GT(tightest, 0.9);
}

INSTANTIATE_TEST_SUITE_P(Appearances, KeptLevels, testing::Bool(),
                         [](const auto& row) { return row.param ? "Kept" : "NotKept"; });

const char* const kPanels =
    "Lot --> extrude(6) comp(f) { side : Facade | all : Roof. }\n"
    "Facade --> color(\"#808080\") split(x) { { ~2 : Panel | 0.05 : color(\"#000000\") Joint. | ~1 : Wall. }* | ~2 : "
    "Panel }\n"
    "Panel --> split(y) { ~1 : Wall. | 0.08 : Sill | 1.2 : 50% : color(\"#203040\") Glass. else : Wall. | ~1 : Wall. "
    "}\n"
    "Sill --> color(\"#ffffff\") extrude(0.08) comp(f) { back : NIL | all : Block. }";

std::map<StableId, std::uint32_t> appearances_by_id(const Derivation& derivation, const std::string& name) {
  std::map<StableId, std::uint32_t> appearances;
  for (const Terminal& terminal : derivation.terminals)
    if (terminal.name == name) appearances[terminal.id] = terminal.appearance;
  return appearances;
}

TEST_F(Levels, PiecesNarrowerThanTheToleranceAreMerged) {
  DeriveOptions options;
  const auto full = derived(kPanels, 10, 8, options);
  options.keep_appearances = options.prune_early = true;
  options.tolerance_m = 0.1;
  const auto cut = derived(kPanels, 10, 8, options);
  EXPECT_FALSE(appearances_by_id(full, "Joint").empty());
  EXPECT_TRUE(appearances_by_id(cut, "Joint").empty());
  EXPECT_TRUE(appearances_by_id(cut, "Sill").empty());
  EXPECT_NEAR(cut.error_m, 0.08, 16 * kSame_m);
  // the other pieces keep their ids, so they draw the same random numbers
  EXPECT_EQ(appearances_by_id(cut, "Glass").size(), appearances_by_id(full, "Glass").size());
  for (const auto& [id, appearance] : appearances_by_id(full, "Glass"))
    EXPECT_TRUE(appearances_by_id(cut, "Glass").contains(id));
}

// Whatever rounding does to the ends of a piece.
TEST_F(Levels, PiecesAsWideAsTheToleranceAreMerged) {
  const std::string front =
      "Lot --> extrude(6) comp(f) { side : color(\"#808080\") split(x) { { ~1 : Wall. | 0.1 : color(\"#ffffff\") "
      "Trim. | 0.7 : color(\"#000000\") Glass. }* | ~1 : Wall. } | all : Roof. }";
  DeriveOptions options;
  options.keep_appearances = options.prune_early = true, options.tolerance_m = 0.1;
  for (double wide_m = 7; wide_m < 12; wide_m += 0.37) {
    const Derivation derivation = derived(front, wide_m, wide_m + 1, options);
    EXPECT_EQ(count_named(derivation, "Trim"), 0u) << wide_m;
    EXPECT_GT(count_named(derivation, "Glass"), 0u) << wide_m;
  }
}

TEST_F(Levels, AdjacentEqualTerminalsAreMerged) {
  const std::string front =
      "Lot --> extrude(6) comp(f) { side : Front | all : Roof. }\n"
      "Front --> split(x) { 0.5 : Wall. | { ~1 : Wall. | 0.7 : Glass. | ~1 : Wall. }* | 0.5 : Wall. }";
  DeriveOptions options;
  const Derivation all = derived(front, 6, 6, options);
  options.prune_early = true;
  const Derivation joined = derived(front, 6, 6, options);
  ASSERT_EQ(count_named(all, "Glass"), 8u);
  EXPECT_EQ(count_named(all, "Wall"), 24u);
  EXPECT_EQ(count_named(joined, "Wall"), 12u);
  // pieces between them keep their ids
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(named(all, "Glass")[i]->id, named(joined, "Glass")[i]->id);
}

std::multiset<std::tuple<StableId, std::string, std::uint32_t, bool>> without_geometry(const Derivation& derivation) {
  std::multiset<std::tuple<StableId, std::string, std::uint32_t, bool>> made;
  for (const Terminal& terminal : derivation.terminals)
    made.insert({terminal.id, terminal.name, terminal.appearance, terminal.simplified});
  return made;
}

TEST_F(Levels, BranchesThatCannotApplyDoNotAffectTheBound) {
  // by day no pane is open, so the front surely moves by at most a decimetre
  const std::string front =
      "attr night = 0\nattr open = 0\nLot --> extrude(6) comp(f) { side : Front | all : Roof. }\n"
      "Front --> split(x) { { ~1 : Pane }* }\nPane --> case night && p(0.5) : set(open, 1) Glass else : Glass\n"
      "Glass --> case open == 1 : NIL else : split(y) { ~1 : Light. | 0.1 : t(0, 0, 0.1) Bar. }";
  DeriveOptions options;
  options.tolerance_m = 0.2, options.prune_early = true;
  EXPECT_EQ(count_named(derived(front, 10, 8, options), "Front"), 4u);
  options.attributes["night"] = 1.0;
  EXPECT_EQ(count_named(derived(front, 10, 8, options), "Front"), 0u);
}

TEST_F(Levels, AreTheSameWithoutCopies) {
  std::uint64_t copies = 0;
  for (int round = 0; round < 300; ++round) {
    const std::string text = rules();
    const Program program = program_of(text);
    const Shape first = lot_of(between(3, 12), between(3, 12));
    for (const double tolerance_m : {0.0, 0.2, 2.0}) {
      DeriveOptions options;
      options.roofs = plain_roof;
      options.limits.shapes = 400;
      options.tolerance_m = tolerance_m;
      const Derivation copied = derive(program, first, options);
      copies += copied.copied;
      options.memoise = false;
      const Derivation own = derive(program, first, options);
      ASSERT_EQ(copied.shapes, own.shapes) << text;
      ASSERT_EQ(copied.steps, own.steps) << text;
      ASSERT_EQ(without_geometry(copied), without_geometry(own)) << tolerance_m << "\n" << text;
      const auto a = triangles_of(copied), b = triangles_of(own);
      if (a.empty() || a.size() > 1000) continue;
      ASSERT_LE(std::max(sampled_m(a, b), sampled_m(b, a)), 1e-5) << text;
    }
  }
  EXPECT_GT(copies, 1'000u);
}

const char* const kWall =
    "Lot --> extrude(6) comp(f) { side : Facade | all : Roof. }\n"
    "Facade --> color(\"#808080\") split(y) { { ~3 : split(x) { { ~2 : Tile }* } }* }\n"
    "Tile --> split(x) { ~1 : Wall. | 1 : split(y) { 1 : Wall. | 1.2 : Window | ~1 : Wall. } | ~1 : Wall. }\n"
    "Window --> extrude(-0.2) comp(f) { front : NIL | back : color(\"#203040\") Glass. | all : Wall. }";

TEST_F(Levels, AWindowIsSimplifiedIfItsDepthIsWithinTheTolerance) {
  DeriveOptions options;
  const auto full = derived(kWall, 10, 8, options);
  options.tolerance_m = 0.1;
  EXPECT_EQ(derived(kWall, 10, 8, options).terminals.size(), full.terminals.size());
  options.tolerance_m = 1.3;
  const auto cut = derived(kWall, 10, 8, options);
  EXPECT_EQ(cut.terminals.size(), 6u);
  EXPECT_LE(cut.error_m, 1.3);
  EXPECT_EQ(count_named(cut, "Facade"), 4u);
}

TEST_F(Levels, ASimplifiedNodeHasTheAppearanceOfMostOfItsArea) {
  DeriveOptions options;
  options.tolerance_m = 1.3;
  const auto cut = derived(kWall, 10, 8, options);
  EXPECT_NEAR(cut.appearances[named(cut, "Facade").at(0)->appearance].red, 128 / 255.0, 1e-9);
}

TEST_F(Levels, AppearancesAreKeptIfAsked) {
  DeriveOptions options;
  options.tolerance_m = 0.4;
  options.keep_appearances = true;
  // a window is wider than that, so it stays a face of its own, without depth
  const auto cut = derived(kWall, 10, 8, options);
  EXPECT_EQ(count_named(cut, "Window"), count_named(derived(kWall), "Glass"));
  options.tolerance_m = 1.3;
  EXPECT_EQ(count_named(derived(kWall, 10, 8, options), "Facade"), 4u);
}

TEST_F(Levels, TheErrorIsZeroWithoutATolerance) {
  const auto full = derived(kWall);
  EXPECT_EQ(full.error_m, 0);
  EXPECT_FALSE(full.terminals.empty());
  for (const Terminal& terminal : full.terminals) EXPECT_FALSE(terminal.simplified);
}

}  // namespace
}  // namespace citykiln::grammars
