#include "lsystems/reading/read_rpforest.h"

#include <gtest/gtest.h>

#include "lsystems/rewriting/turtle.h"
#include "tests/lsystems/derived.h"

namespace citykiln::lsystems {
namespace {

LSystem rpforest(const std::string& text, const std::string& file) {
  Result<LSystem> system = read_rpforest(text, file);
  EXPECT_TRUE(system) << to_string(system.error());
  return system ? *system : LSystem{};
}

std::string rpforest_error_of(const std::string& text, const std::string& file = "x.lsys") {
  const Result<LSystem> system = read_rpforest(text, file);
  return system ? "" : to_string(system.error());
}

double top_of(const Skeleton& skeleton) {
  double top = 0;
  for (const Segment& segment : skeleton.segments) top = std::max(top, segment.end().at.z);
  for (const Vec3 vertex : skeleton.vertices) top = std::max(top, vertex.z);
  return top;
}

constexpr const char* kHonda = "N 10\nR1 0.9\nR2 0.6\nA0 45\nA2 45\nD 137.5\nWr 0.707\n";

TEST(RpForest, HondaFilesGiveTheBooksTree) {
  const LSystem system = rpforest(kHonda, "A.honda");
  const ModuleString string = derive(system).string;
  EXPECT_EQ(string.kinds.size(), 1 + 7 * 1023u);
  const Skeleton skeleton = grow(system).skeleton;
  EXPECT_EQ(skeleton.segments.size(), 1023u);
  EXPECT_NEAR(top_of(skeleton), 2, 1e-12);
  // a trunk of radius 0.2 where its first segment is 1 long
  EXPECT_NEAR(skeleton.segments[0].end_radius / skeleton.segments[0].length, 0.2, 1e-12);
}

TEST(RpForest, FamilyFilesGiveOneLeaf) {
  const LSystem system = rpforest("N 20\nDelta 60\nLA 5\nRA 1.0\nLB 0.6\nRB 1.06\nPD 0.25", "C.family");
  const Plant plant = grow(system);
  ASSERT_EQ(plant.skeleton.polygons.size(), 1u);
  // the foot, and a tip on each side for each of 19 steps
  EXPECT_EQ(plant.skeleton.polygons[0].count, 1 + 2 * 19u);
  EXPECT_NEAR(top_of(plant.skeleton), 0.4, 1e-12);
  // lower case occurs in its assets
  EXPECT_EQ(rpforest_error_of("N 20\ndelta 60\nLA 5\nRA 1.2\nLB 10.0\nRB 1.00\nPD 0.50", "D.family"), "");
}

TEST(RpForest, LsysFilesHaveThreeAngles) {
  const LSystem system = rpforest(
      "N 7\nTurnAngle 25.7\nHeight 0.5\nInitRadius 1.2\nAxiom X\nProd X > F[+X][-X]FX\nProd F > FF \n", "plantE.lsys");
  EXPECT_EQ(derive(system).string.kinds.size(), 12'863u);
  const Skeleton skeleton = grow(system).skeleton;
  EXPECT_NEAR(top_of(skeleton), 0.5, 1e-12);
  const LSystem turned = rpforest("N 0\nTurnAngle 90\nPitchAngle 30\nRollAngle 10\nAxiom +F-F&F/F", "x.lsys");
  const auto& s = grow(turned).skeleton.segments;
  EXPECT_NEAR(s[0].start.heading.x, -1, 1e-15);
  EXPECT_NEAR(s[2].start.heading.y, 0.5, 1e-15);
}

TEST(RpForest, OldestFilesHaveNoNames) {
  const LSystem system = rpforest("5\n25.7\n1\nF\nF > F[+F]F[-F]F \n", "plantA.lsys");
  EXPECT_EQ(derive(system).string.kinds.size(), 7'811u);
}

TEST(RpForest, FilesAreDistinguishedFromOurs) {
  EXPECT_TRUE(is_rpforest("", "a.honda"));
  EXPECT_TRUE(is_rpforest("", "a.family"));
  EXPECT_TRUE(is_rpforest("N 7\nAxiom X", "a.lsys"));
  EXPECT_TRUE(is_rpforest("5\n25.7\n1\nF\n", "a.lsys"));
  EXPECT_FALSE(is_rpforest("n: 7\naxiom: X", "a.lsys"));
  EXPECT_FALSE(is_rpforest("N -> F\naxiom: N", "other.txt"));
  for (const char* figure : {"1_24a", "1_26", "2_6a", "5_11a"})
    EXPECT_FALSE(is_rpforest(text_of_tree("lsystems/book/fig_" + std::string(figure) + ".lsys"), "a.lsys"));
}

TEST(RpForest, ErrorsStateTheirPosition) {
  EXPECT_EQ(rpforest_error_of("N seven"), "x.lsys:1:3: expected a number, found 'seven'");
  EXPECT_EQ(rpforest_error_of("N 7\n  Hight 3"), "x.lsys:2:3: 'Hight' is no RPForest entry of this format");
  EXPECT_EQ(rpforest_error_of("N 7"), "x.lsys: expected an Axiom");
  EXPECT_EQ(rpforest_error_of("Axiom F"), "x.lsys: expected a value of 'N'");
  EXPECT_EQ(rpforest_error_of("N"), "x.lsys:1:1: expected a value of 'N', found the end of the file");
  EXPECT_EQ(rpforest_error_of("N 7\nAxiom F\nProd F -> FF"), "x.lsys:3:8: expected '>', found '->'");
  EXPECT_EQ(rpforest_error_of("N 7\nAxiom F\nProd FF > FF"), "x.lsys:3:6: expected one symbol, found 'FF'");
  EXPECT_EQ(rpforest_error_of("N 7\nR1 2", "x.honda"), "x.honda: expected a value of 'R2'");
  EXPECT_EQ(rpforest_error_of("5\n25.7"), "x.lsys:1:1: expected N, angle, height and axiom");
  EXPECT_EQ(rpforest_error_of("N 1\nAxiom F["), "x.lsys: translated to our notation: x.lsys:3:9: '[' without ']'");
}

}  // namespace
}  // namespace citykiln::lsystems
