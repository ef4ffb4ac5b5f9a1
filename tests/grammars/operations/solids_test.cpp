// Tests of round primitives, edges, scattered points and details, as rules use them.
#include <gtest/gtest.h>

#include "grammars/shapes/cut.h"
#include "tests/grammars/on_lot.h"
#include "tests/grammars/surfaces.h"

namespace citykiln::grammars {
namespace {

Derivation at_tolerance(const std::string& text, double tolerance_m, bool keep_appearances = true) {
  DeriveOptions options;
  options.tolerance_m = tolerance_m;
  options.keep_appearances = keep_appearances;
  return derived(text, 4, 4, options);
}

std::size_t faces_of(const Derivation& derivation) {
  std::size_t count = 0;
  for (const Terminal& terminal : derivation.terminals) count += terminal.faces.size();
  return count;
}

TEST(Solids, ARoundPrimitiveHasFewerSidesAtATolerance) {
  const std::string rules = "Lot --> s(2, 3, 2) primitiveCylinder() Tank.";
  const Derivation fine = at_tolerance(rules, 0), coarse = at_tolerance(rules, 0.2);
  EXPECT_LT(faces_of(coarse), faces_of(fine));
  EXPECT_LE(fine.error_m, 0.02);
  EXPECT_GT(coarse.error_m, fine.error_m);
  EXPECT_LE(coarse.error_m, 0.1);
}

TEST(Solids, ThePrimitiveWithGivenSidesIsTheSameAtEveryTolerance) {
  const std::string rules = "Lot --> s(2, 3, 2) primitiveCone(y, 6, 0.5) Cone.";
  EXPECT_EQ(faces_of(at_tolerance(rules, 0)), 8u);
  EXPECT_EQ(faces_of(at_tolerance(rules, 0.3)), 8u);
  EXPECT_EQ(at_tolerance(rules, 0.3).error_m, 0);
}

TEST(Solids, AllRoundPrimitivesAreClosed) {
  for (const char* call :
       {"primitiveCylinder()", "primitiveCylinder(5)", "primitiveCylinder(8, 1, 4)", "primitiveCone()",
        "primitiveCone(x, 0, 0.3)", "primitiveSphere(z)", "primitiveSphere(6)", "primitiveDome()"}) {
    const Derivation made = derived(std::string("Lot --> s(2, 3, 2) ") + call + " Body.");
    ASSERT_EQ(made.terminals.size(), 1u);
    EXPECT_TRUE(is_closed(made.terminals[0].faces)) << call;
  }
}

TEST(Solids, ScaledRoundBodiesAreOffByMore) {
  const std::string rules = "Lot --> s(1, 1, 1) primitiveCylinder() s(3, 1, 1) Body.";
  EXPECT_NEAR(derived(rules).error_m, 3 * derived("Lot --> s(1, 1, 1) primitiveCylinder() Body.").error_m, 1e-9);
}

TEST(Solids, ABoxHasTwelveEdges) {
  const std::string box = "Lot --> extrude(3) comp(e) { ";
  EXPECT_EQ(count_named(derived(box + "all : s('1, 0.1, 0.1) primitiveCube() Bar. }"), "Bar"), 12u);
  EXPECT_EQ(count_named(derived(box + "vertical : s('1, 0.1, 0.1) primitiveCube() Bar. }"), "Bar"), 4u);
  EXPECT_EQ(count_named(derived(box + "top : s('1, 0.1, 0.1) primitiveCube() Bar. }"), "Bar"), 4u);
  EXPECT_EQ(count_named(derived("Lot --> comp(e) { border : s('1, 0.1, 0.1) primitiveCube() Bar. }"), "Bar"), 4u);
}

TEST(Solids, AnEdgeHasItsLengthAndNoSurface) {
  const Derivation bars = derived("Lot --> comp(e) { 0 : report(\"long\", scope.sx) Edge. }", 7, 3);
  ASSERT_EQ(bars.reports.size(), 1u);
  EXPECT_EQ(std::get<double>(bars.reports[0].value), 7);
  EXPECT_TRUE(bars.terminals.empty());
}

TEST(Solids, CopiesStandAlongAnEdge) {
  const std::string rules =
      "Lot --> comp(e) { 0 : split(x) { { ~2 : Place }* } }\nPlace --> s(0.2, 1, 0.2) primitiveCube() Post.";
  const Derivation posts = derived(rules, 8, 3);
  EXPECT_EQ(count_named(posts, "Post"), 4u);
  EXPECT_NEAR(posts.terminals[1].scope.origin.x - posts.terminals[0].scope.origin.x, 2, 1e-9);
}

TEST(Solids, ScatteredPointsLieOnTheSurface) {
  const std::string cubes = "Lot --> scatter(surface, 50, uniform) { s(0.2, 0.2, 0.2) primitiveCube() Stone. }";
  const Derivation stones = derived(cubes, 10, 8);
  EXPECT_EQ(count_named(stones, "Stone"), 50u);
  for (const Terminal* stone : named(stones, "Stone")) {
    const Vec3 p = stone->scope.origin;
    EXPECT_TRUE(p.x >= 0 && p.x <= 10 && p.y >= 0 && p.y <= 8 && std::abs(p.z) < 1e-9);
  }
  EXPECT_EQ(derived(cubes, 10, 8).terminals[7].scope.origin, stones.terminals[7].scope.origin);
}

TEST(Solids, ScatterTakesOneBody) {
  EXPECT_FALSE(read_rules_of("Lot --> scatter(surface, 5)", "test.cga"));
  EXPECT_TRUE(read_rules_of("Lot --> scatter(scope, 5, uniform) { t(0, 1, 0) Leaf. }", "test.cga"));
}

constexpr const char* kPlateWithBolt =
    "Lot --> details() Base Fixing\n"
    "Base --> s(2, 0.2, 2) primitiveCube() Plate.\n"
    "Fixing --> t(1, 0.2, 1) s(0.05, 0.04, 0.05) primitiveCube() color(\"#ff0000\") Bolt.\n";

TEST(Solids, ADetailIsLeftOutWithinTheTolerance) {
  EXPECT_EQ(count_named(at_tolerance(kPlateWithBolt, 0), "Bolt"), 1u);
  EXPECT_EQ(count_named(at_tolerance(kPlateWithBolt, 0.02), "Bolt"), 1u);
  const Derivation coarse = at_tolerance(kPlateWithBolt, 0.06);
  EXPECT_EQ(count_named(coarse, "Bolt"), 0u);
  EXPECT_NEAR(coarse.error_m, 0.04, 1e-9);
}

TEST(Solids, AWideDetailOfAnotherColourStays) {
  const std::string rules =
      "Lot --> details() Base Band\nBase --> s(2, 0.2, 2) primitiveCube() Plate.\n"
      "Band --> t(0, 0.2, 0) s(2, 0.04, 1) primitiveCube() color(\"#ff0000\") Stripe.\n";
  EXPECT_GE(count_named(at_tolerance(rules, 0.06), "Stripe"), 1u);
  EXPECT_EQ(count_named(at_tolerance(rules, 0.06, false), "Stripe"), 0u);
}

TEST(Solids, ADetailFarFromTheRestStays) {
  const std::string rules =
      "Lot --> details() Base Far\nBase --> s(2, 0.2, 2) primitiveCube() Plate.\n"
      "Far --> t(1, 3, 1) s(0.05, 0.05, 0.05) primitiveCube() Ball.\n";
  EXPECT_GE(at_tolerance(rules, 0.5).terminals.size(), 2u);
}

TEST(Solids, TheStatedErrorBoundsTheDistanceToAllThatWasLeftOut) {
  std::uint32_t state = 7;
  const auto chance = [&] { return state = state * 1664525u + 1013904223u; };
  const std::string rules =
      std::string(kPlateWithBolt) + "Post --> t(0.5, 0.2, 0.5) s(0.3, 2, 0.3) primitiveCylinder() Post.\n";
  const Derivation fine = at_tolerance("Lot --> details() Plate Bolt Post\n" + rules.substr(rules.find('\n') + 1), 0);
  for (const double tolerance_m : {0.03, 0.06, 0.15}) {
    const Derivation coarse =
        at_tolerance("Lot --> details() Plate Bolt Post\n" + rules.substr(rules.find('\n') + 1), tolerance_m);
    EXPECT_LE(coarse.error_m, tolerance_m);
    const auto a = triangles_of(fine), b = triangles_of(coarse);
    const double measured_m = std::max(sampled_m(a, b, 400, chance), sampled_m(b, a, 400, chance));
    EXPECT_LE(measured_m, coarse.error_m + fine.error_m + 1e-6);
  }
}

}  // namespace
}  // namespace citykiln::grammars
