#include "compiler/pitches/pitch_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/contract/texts/parse.h"
#include "compiler/pitches/pitch_rules.h"

namespace citykiln::pitches {
namespace {

Pitch pitch_of(PitchKind kind) {
  const PitchRules& rules = rules_of(kind);
  return {{}, kind, {-rules.length.usual_m / 2, 0}, {rules.length.usual_m / 2, 0}, rules.width.usual_m};
}

TEST(PitchLines, CoordinatesAreSumsOfNumbersAndHalfSizes) {
  EXPECT_EQ(coordinate_m("-e+5.5", {50, 30}), -44.5);
  EXPECT_EQ(coordinate_m("1.37-s", {50, 30}), -28.63);
  EXPECT_EQ(coordinate_m("12", {50, 30}), 12);
  EXPECT_FALSE(coordinate_m("", {50, 30}));
  EXPECT_FALSE(coordinate_m("5m", {50, 30}));
}

TEST(PitchLines, EveryRowCanBeRead) {
  for (std::size_t i = 0; i < pitch_rules().size(); ++i) {
    const Pitch pitch = pitch_of(static_cast<PitchKind>(i));
    std::size_t lines = 0;
    for (const std::string_view text : split(rules_of(pitch.kind).lines, ';')) {
      const std::vector<PitchLine> read = lines_of(text, half_size_of(pitch));
      EXPECT_FALSE(read.empty()) << rules_of(pitch.kind).name << ": " << text;
      lines += read.size();
    }
    EXPECT_EQ(lines_of(pitch).size(), lines);
  }
}

TEST(PitchLines, LinesLieInThePitch) {
  for (std::size_t i = 0; i < pitch_rules().size(); ++i) {
    const Pitch pitch = pitch_of(static_cast<PitchKind>(i));
    const HalfSize half = half_size_of(pitch);
    for (const PitchLine& line : lines_of(pitch))
      for (const Vec2 p : line.path) {
        EXPECT_LE(std::abs(p.x), half.to_end_line_m + 1e-6) << rules_of(pitch.kind).name;
        EXPECT_LE(std::abs(p.y), half.to_side_line_m + 1e-6) << rules_of(pitch.kind).name;
      }
  }
}

TEST(PitchLines, RowsHaveSizesInOrder) {
  for (const PitchRules& rules : pitch_rules())
    for (const SizeRange& range : {rules.length, rules.width}) {
      EXPECT_GT(range.least_m, 0) << rules.name;
      EXPECT_LE(range.least_m, range.usual_m) << rules.name;
      EXPECT_LE(range.usual_m, range.most_m) << rules.name;
    }
}

TEST(PitchLines, TheCentreCircleOfSoccerHasARadiusOf915Centimetres) {
  const std::vector<PitchLine> lines = lines_of(pitch_of(PitchKind::kSoccer));
  const auto circle = std::ranges::find_if(lines, [](const PitchLine& line) {
    return line.path.size() > 30 && line.path.front() == line.path.back() && !line.is_disc;
  });
  ASSERT_NE(circle, lines.end());
  for (const Vec2 p : circle->path) EXPECT_NEAR(length(p), 9.15, 1e-9);
  for (std::size_t i = 0; i + 1 < circle->path.size(); ++i)
    EXPECT_GT(length((circle->path[i] + circle->path[i + 1]) * 0.5), 9.15 - 0.0041);
}

TEST(PitchLines, ThreePointLinesKeepTheirDistanceFromTheSides) {
  Pitch narrow = pitch_of(PitchKind::kBasketball);
  narrow.width_m = 13;
  const HalfSize half = half_size_of(narrow);
  double widest_m = 0;
  for (const PitchLine& line : lines_of("T e-1.575,0 6.75 s-0.9", half))
    for (const Vec2 p : line.path) widest_m = std::max(widest_m, std::abs(p.y));
  EXPECT_NEAR(widest_m, half.to_side_line_m - 0.9, 1e-6);
}

TEST(PitchLines, GoalsAreAtBothEndsAndFaceThePitch) {
  const Pitch pitch{{}, PitchKind::kSoccer, {100, 200}, {100, 305}, 68};
  const std::vector<Equipment> goals = equipment_of(pitch);
  ASSERT_EQ(goals.size(), 2u);
  for (const Equipment& goal : goals) {
    EXPECT_NEAR(goal.at.x, 100, 1e-9);
    EXPECT_NEAR(std::abs(goal.at.y - 252.5), 52.44 + 1, 1e-6);
    EXPECT_NEAR(dot(goal.facing, unit(Vec2{100, 252.5} - goal.at)), 1, 1e-9);
  }
}

}  // namespace
}  // namespace citykiln::pitches
