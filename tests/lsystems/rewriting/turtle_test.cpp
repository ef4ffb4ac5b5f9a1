#include "lsystems/rewriting/turtle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "tests/lsystems/derived.h"

namespace citykiln::lsystems {
namespace {

constexpr double kRoot = 0.70710678118654752440;

Skeleton skeleton_after(const std::string& text, int steps = 0) {
  DeriveOptions options;
  options.steps = steps;
  return grow(system_of(text), options).skeleton;
}

void expect_at(Vec3 found, Vec3 expected) {
  EXPECT_LT(length(found - expected), 1e-12) << found.x << " " << found.y << " " << found.z;
}

Vec3 end_of(const std::string& axiom) { return skeleton_after("axiom: " + axiom).segments.back().end().at; }

TEST(Turtle, GoesUpAndTurnsAboutItself) {
  // heading is z, left is -x (west), up is -y (south)
  expect_at(end_of("F(2)"), {0, 0, 2});
  expect_at(end_of("+(90)F"), {-1, 0, 0});
  expect_at(end_of("-(90)F"), {1, 0, 0});
  expect_at(end_of("&(90)F"), {0, 1, 0});
  expect_at(end_of("^(90)F"), {0, -1, 0});
  expect_at(end_of("|F"), {0, 0, -1});
  // rolled left, left is where down was
  expect_at(end_of("\\(90)+(90)F"), {0, 1, 0});
  expect_at(end_of("/(90)+(90)F"), {0, -1, 0});
  expect_at(end_of("+(45)F"), {-kRoot, 0, kRoot});
}

TEST(Turtle, TakesDefaultsFromTheFile) {
  expect_at(skeleton_after("angle: 90\nstep: 3\naxiom: f+F").segments[0].end().at, {-3, 0, 3});
  EXPECT_EQ(skeleton_after("width: 4\nwidth unit: 0.1\naxiom: F").segments[0].end_radius, 0.2);
}

TEST(Turtle, LevelsItsLeft) {
  const Skeleton skeleton = skeleton_after("axiom: &(40)/(77)$F");
  EXPECT_LT(std::abs(skeleton.segments[0].start.left.z), 1e-15);
  EXPECT_GT(skeleton.segments[0].start.up.z, 0);
  // a vertical heading has no horizontal left
  expect_at(skeleton_after("axiom: /(90)$F").segments[0].start.left, {0, -1, 0});
}

TEST(Turtle, GoesBackAtTheEndOfABranch) {
  const Skeleton skeleton = skeleton_after("axiom: F[+(90)F[F]]F");
  ASSERT_EQ(skeleton.segments.size(), 4u);
  expect_at(skeleton.segments[3].start.at, {0, 0, 1});
  expect_at(skeleton.segments[2].start.at, {-1, 0, 1});
}

TEST(Turtle, SetsParentsAndOrders) {
  const Skeleton skeleton = skeleton_after("axiom: FF[[+FF][-F]]F[[[F]]]");
  std::vector<std::int32_t> parents, orders;
  for (const Segment& segment : skeleton.segments) parents.push_back(segment.parent), orders.push_back(segment.order);
  EXPECT_EQ(parents, (std::vector<std::int32_t>{-1, 0, 1, 2, 1, 1, 5}));
  EXPECT_EQ(orders, (std::vector<std::int32_t>{0, 0, 1, 1, 1, 0, 1}));
}

TEST(Turtle, TapersAlongAnAxisAndNotIntoABranch) {
  const Skeleton skeleton = skeleton_after("axiom: !(4)F[!(1)F]!(2)F!FfF!(8)F");
  const auto& s = skeleton.segments;
  EXPECT_EQ(s[0].start_radius, 2);
  EXPECT_EQ(s[1].start_radius, 0.5);
  EXPECT_EQ(s[2].start_radius, 2);
  EXPECT_EQ(s[2].end_radius, 1);
  EXPECT_DOUBLE_EQ(s[3].end_radius, kRoot);
  EXPECT_EQ(s[4].start_radius, s[4].end_radius);
  EXPECT_EQ(s[5].start_radius, s[4].end_radius);
}

TEST(Turtle, CountsColours) {
  const Skeleton skeleton = skeleton_after("axiom: F'F;F,F'(7)F");
  std::vector<std::int32_t> colours;
  for (const Segment& segment : skeleton.segments) colours.push_back(segment.colour);
  EXPECT_EQ(colours, (std::vector<std::int32_t>{0, 1, 2, 1, 7}));
}

TEST(Turtle, CutsTheRestOfABranch) {
  EXPECT_EQ(skeleton_after("axiom: F[F%F[F]F]F").segments.size(), 3u);
  EXPECT_EQ(skeleton_after("axiom: F%F[F]F").segments.size(), 1u);
}

TEST(Turtle, MakesPolygonsThatNest) {
  // f and F add vertices, G does not; nothing is drawn inside
  const Skeleton skeleton = skeleton_after("angle: 90\naxiom: F{.f+F+{.f.f+f}f}G");
  EXPECT_EQ(skeleton.segments.size(), 2u);
  ASSERT_EQ(skeleton.polygons.size(), 2u);
  EXPECT_EQ(skeleton.polygons[0].count, 5u);
  EXPECT_EQ(skeleton.polygons[1].count, 4u);
  EXPECT_EQ(skeleton.polygons[0].parent, 0);
  expect_at(skeleton.vertices[skeleton.polygons[1].first], {0, 0, 1});
  expect_at(skeleton.vertices[skeleton.polygons[1].first + 2], {-1, 0, 2});
}

TEST(Turtle, KeepsAPolygonOpenAcrossBranches) {
  const Skeleton skeleton = skeleton_after("angle: 60\naxiom: {.G[-f][+G.]G.}");
  ASSERT_EQ(skeleton.polygons.size(), 1u);
  EXPECT_EQ(skeleton.polygons[0].count, 4u);
  EXPECT_TRUE(skeleton.segments.empty());
}

TEST(Turtle, PlacesInstances) {
  const std::string text = "module leaf\naxiom: F[&(90)~leaf(0.3)]@O(2)~L";
  const Skeleton skeleton = skeleton_after(text);
  const LSystem system = system_of(text);
  ASSERT_EQ(skeleton.instances.size(), 3u);
  EXPECT_EQ(system.kinds[skeleton.instances[0].kind].name, "~leaf");
  EXPECT_EQ(skeleton.instances[0].size, 0.3);
  EXPECT_EQ(skeleton.instances[0].order, 1);
  expect_at(skeleton.instances[0].frame.heading, {0, 1, 0});
  EXPECT_EQ(system.kinds[skeleton.instances[1].kind].name, "@O");
  EXPECT_EQ(skeleton.instances[2].size, 1);
}

TEST(Tropism, TurnsTowardsIt) {
  // 0.3 radians of a heading perpendicular to the tropism
  const Skeleton down = skeleton_after("tropism: 0,0,-1\nelasticity: 0.3\naxiom: -(90)FF");
  const double degrees = 0.3 * 57.29577951308232;
  expect_at(down.segments[1].start.heading, {cosine(degrees), 0, -sine(degrees)});
  // a parallel heading does not turn
  expect_at(skeleton_after("tropism: 0,0,-1\nelasticity: 0.3\naxiom: FF").segments[1].end().at, {0, 0, 2});
  // @T sets the tropism of a branch
  expect_at(skeleton_after("axiom: -(90)[@T(0,0,1,0.3)FF]FF").segments[1].start.heading,
            {cosine(degrees), 0, sine(degrees)});
}

TEST(Tropism, NeverTurnsFurtherThanHalfATurn) {
  const Skeleton skeleton = skeleton_after("tropism: 0,0,-1\nelasticity: 1000\naxiom: -(90)FF");
  EXPECT_LT(std::abs(length(skeleton.segments[1].start.heading) - 1), 1e-12);
}

TEST(Frames, StayOrthonormal) {
  // a long string with all rotations and tropism
  const Skeleton skeleton = skeleton_after(
      "tropism: 0.3,0.1,-1\nelasticity: 0.1\nangle: 17.3\naxiom: A\nA -> F+F&F/F-(33)F^(71)F\\(5)F|F$FA", 2000);
  ASSERT_GT(skeleton.segments.size(), 17'000u);
  double worst = 0;
  for (const Segment& segment : skeleton.segments) {
    const TurtleFrame& f = segment.start;
    worst = std::max({worst, std::abs(length(f.heading) - 1), std::abs(dot(f.heading, f.left)),
                      length(cross(f.heading, f.left) - f.up)});
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(Height, ScalesTheWholePlant) {
  const Skeleton skeleton = skeleton_after("height: 12\naxiom: !(1)F(2)[+(90)F(2)]F(2){.f(1).+(90)f(1)}~L(1)");
  EXPECT_DOUBLE_EQ(skeleton.segments[2].end().at.z, 9.6);
  EXPECT_DOUBLE_EQ(skeleton.segments[0].end_radius, 1.2);
  EXPECT_DOUBLE_EQ(skeleton.instances[0].size, 2.4);
  EXPECT_EQ(skeleton.vertices[1].z, 12);
  expect_at(skeleton_after("height: 12\naxiom: -(90)F").segments[0].end().at, {1, 0, 0});
}

TEST(Queries, AreAnsweredAfterEachStep) {
  EXPECT_EQ(grown("axiom: F(2)?P(0,0,0)-(90)F(3)?P(0,0,0)", 0), "F(2)?P(0,0,2)-(90)F(3)?P(3,0,2)");
  // pruning after Prusinkiewicz, James and Mech 1994: growth stops above a height
  EXPECT_EQ(grown("axiom: A\nA -> F?H(0)A\n?H(h) : h > 2.5 -> @o%", 3), "F?H(1)F?H(2)F?H(3)A");
  EXPECT_EQ(grown("axiom: A\nA -> F?H(0)A\n?H(h) : h > 2.5 -> @o%", 6), "F?H(1)F?H(2)F@o");
}

TEST(Queries, CallTheEnvironment) {
  const LSystem system = system_of("axiom: A\nA -> F?H(0)?S(0)A");
  DeriveOptions options;
  options.steps = 2;
  options.environment.height_above_ground = [](Vec3 p) { return p.z + 10; };
  options.environment.shade = [](Vec3 p) { return p.z > 1.5 ? 0 : 0.75; };
  EXPECT_EQ(text_of(system, derive(system, options).string), "F?H(11)?S(0.75)F?H(12)?S(0)A");
  options.environment.shade = [](Vec3) { return std::nan(""); };
  EXPECT_EQ(text_of(system, derive(system, options).string), "F?H(11)?S(0)F?H(12)?S(0)A");
}

TEST(Queries, FollowInterpretationRules) {
  EXPECT_EQ(grown("axiom: A?H(0)[%?H(0)]?H(0)\ninterpretation:\nA -> FFF", 0), "A?H(3)[%?H(0)]?H(3)");
}

TEST(TurtleWarnings, AreCountedOnceEach) {
  const std::string text = "axiom: F}F}.{.{.f.f.F(1e300)[A]";
  const LSystem system = system_of(text);
  const Skeleton skeleton = grow(system, {}).skeleton;
  std::vector<std::string> lines;
  for (const Warning& warning : skeleton.warnings) lines.push_back(warning_line(system, warning));
  EXPECT_EQ(lines, (std::vector<std::string>{
                       "x.lsys: a '}' outside polygons is skipped (2 times)",
                       "x.lsys: a '.' outside polygons is skipped",
                       "x.lsys: 'F' with a number beyond 1000000000 is skipped",
                       "x.lsys: a polygon without '}' is skipped",
                   }));
  EXPECT_TRUE(skeleton.polygons.empty());
  EXPECT_EQ(skeleton_after("axiom: {.f.}{f}").warnings.size(), 1u);
}

TEST(TurtleWarnings, UndefinedValuesAreSkipped) {
  const LSystem system = system_of("axiom: F(1)+(2)F(3)");
  ModuleString string = derive(system).string;
  string.values[0] = std::nan("");
  string.values[1] = std::numeric_limits<double>::infinity();
  const Skeleton skeleton = walk(system, string);
  EXPECT_EQ(skeleton.segments.size(), 1u);
  EXPECT_EQ(skeleton.warnings.size(), 2u);
}

TEST(TurtleWarnings, DeepBranchesAreSkipped) {
  std::string text = "axiom: ";
  for (int i = 0; i < 12'000; ++i) text += "[F";
  const Skeleton skeleton = skeleton_after(text + std::string(12'000, ']') + "F");
  EXPECT_EQ(skeleton.segments.size(), 10'001u);
  EXPECT_EQ(skeleton.segments.back().order, 0);
  EXPECT_EQ(skeleton.warnings.at(0).message, "branches nest too deeply: one is skipped");
}

}  // namespace
}  // namespace citykiln::lsystems
