#include "compiler/pitches/plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/geometry/trig.h"
#include "compiler/pitches/pitch_lines.h"
#include "compiler/pitches/pitch_rules.h"

namespace citykiln::pitches {
namespace {

constexpr ObjectId kPitchId{{OsmType::kWay, 7}, 0};

// A rectangle about a place, turned by a share of a full turn.
Polygon sports_area_of(double length_m, double width_m, double turns = 0, Vec2 at = {0, 0}) {
  const Vec2 along = direction_of(turns);
  Polygon area;
  for (const Vec2 corner : {Vec2{-0.5, -0.5}, Vec2{0.5, -0.5}, Vec2{0.5, 0.5}, Vec2{-0.5, 0.5}})
    area.outer.push_back(at + along * (corner.x * length_m) + left_of(along) * (corner.y * width_m));
  return area;
}

double length_of(const Pitch& pitch) { return distance(pitch.from, pitch.to); }

TEST(PitchPlan, APitchIsInTheMiddleAlongTheLongerSide) {
  const std::vector<Pitch> pitches = pitches_of(kPitchId, sports_area_of(60, 100, 0, {300, -40}), "soccer");
  ASSERT_EQ(pitches.size(), 1u);
  EXPECT_EQ(pitches[0].kind, PitchKind::kSoccer);
  EXPECT_NEAR(distance((pitches[0].from + pitches[0].to) * 0.5, {300, -40}), 0, 0.01);
  EXPECT_NEAR(std::abs((pitches[0].to - pitches[0].from).x), 0, 0.01);
  EXPECT_NEAR(length_of(pitches[0]), 100, 0.01);
  EXPECT_NEAR(pitches[0].width_m, 60, 0.01);
}

TEST(PitchPlan, APitchTurnsWithItsArea) {
  for (const double turns : {0.03, 0.11, 0.2, 0.37}) {
    const std::vector<Pitch> pitches = pitches_of(kPitchId, sports_area_of(105, 68, turns), "soccer");
    ASSERT_EQ(pitches.size(), 1u);
    EXPECT_NEAR(std::abs(cross(frame_of(pitches[0]).along, direction_of(turns))), 0, 1e-3);
  }
}

TEST(PitchPlan, APitchKeepsToTheRuleBook) {
  const std::vector<Pitch> large = pitches_of(kPitchId, sports_area_of(140, 100), "soccer");
  ASSERT_EQ(large.size(), 1u);
  EXPECT_NEAR(length_of(large[0]), 105, 0.01);
  EXPECT_NEAR(large[0].width_m, 68, 0.01);
  EXPECT_EQ(pitches_of(kPitchId, sports_area_of(60, 40), "soccer").at(0).kind, PitchKind::kSoccerYouth);
  EXPECT_EQ(pitches_of(kPitchId, sports_area_of(40, 20), "soccer").at(0).kind, PitchKind::kSoccerSmall);
  EXPECT_EQ(pitches_of(kPitchId, sports_area_of(15, 15), "basketball").at(0).kind, PitchKind::kBasketballHalf);
  EXPECT_TRUE(pitches_of(kPitchId, sports_area_of(8, 5), "soccer").empty());
  EXPECT_TRUE(pitches_of(kPitchId, sports_area_of(80, 50), "chess").empty());
}

TEST(PitchPlan, AsManyCourtsAsFit) {
  const auto count = [](double length_m, double width_m) {
    return pitches_of(kPitchId, sports_area_of(length_m, width_m, 0.07), "tennis").size();
  };
  EXPECT_EQ(count(36, 18), 1u);
  EXPECT_EQ(count(24, 11), 1u);
  EXPECT_EQ(count(36, 36), 2u);
  EXPECT_EQ(count(54, 36), 3u);
  EXPECT_EQ(count(72, 36), 5u);
  EXPECT_EQ(count(54, 72), 6u);
}

TEST(PitchPlan, CourtsDoNotOverlap) {
  const std::vector<Pitch> courts = pitches_of(kPitchId, sports_area_of(100, 72, 0.3), "tennis");
  ASSERT_GT(courts.size(), 4u);
  for (std::size_t i = 0; i < courts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(distance((courts[i].from + courts[i].to) * 0.5, (courts[j].from + courts[j].to) * 0.5), 10.97);
}

TEST(PitchPlan, TheFirstSportOfWhichAPitchFitsCounts) {
  EXPECT_EQ(pitches_of(kPitchId, sports_area_of(28, 15), "soccer;basketball").at(0).kind, PitchKind::kSoccerSmall);
  EXPECT_EQ(pitches_of(kPitchId, sports_area_of(28, 15), "gymnastics;basketball").at(0).kind, PitchKind::kBasketball);
}

TEST(PitchPlan, AnAreaThatIsNearlyARectangleHasAPitch) {
  // way of Berlin-Reinickendorf: its longer sides differ in direction by half a degree, one has a bend
  const Polygon area{{{0, 0}, {17.6, -21.7}, {56.4, 6.6}, {39, 29.2}, {36.6, 27.3}}, {}};
  EXPECT_EQ(pitches_of(kPitchId, area, "soccer").size(), 1u);
}

TEST(PitchPlan, AreasThatAreNoRectanglesHaveNoLines) {
  Polygon bent = sports_area_of(100, 60);
  bent.outer = {{0, 0}, {100, 0}, {100, 20}, {20, 20}, {20, 80}, {0, 80}};
  EXPECT_TRUE(pitches_of(kPitchId, bent, "soccer").empty());
}

}  // namespace
}  // namespace citykiln::pitches
