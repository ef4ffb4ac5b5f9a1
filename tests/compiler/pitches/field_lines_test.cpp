#include "compiler/pitches/field_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/contract/texts/parse.h"
#include "compiler/pitches/field_rules.h"

namespace citykiln::pitches {
namespace {

Field field_of(FieldKind kind) {
  const FieldRules& rules = rules_of(kind);
  return {{}, kind, {-rules.length.usual_m / 2, 0}, {rules.length.usual_m / 2, 0}, rules.width.usual_m};
}

TEST(FieldLines, CoordinatesAreSumsOfNumbersAndHalfSizes) {
  EXPECT_EQ(coordinate_m("-e+5.5", {50, 30}), -44.5);
  EXPECT_EQ(coordinate_m("1.37-s", {50, 30}), -28.63);
  EXPECT_EQ(coordinate_m("12", {50, 30}), 12);
  EXPECT_FALSE(coordinate_m("", {50, 30}));
  EXPECT_FALSE(coordinate_m("5m", {50, 30}));
}

TEST(FieldLines, EveryRowCanBeRead) {
  for (std::size_t i = 0; i < field_rules().size(); ++i) {
    const Field field = field_of(static_cast<FieldKind>(i));
    std::size_t lines = 0;
    for (const std::string_view text : split(rules_of(field.kind).lines, ';')) {
      const std::vector<FieldLine> read = lines_of(text, half_size_of(field));
      EXPECT_FALSE(read.empty()) << rules_of(field.kind).name << ": " << text;
      lines += read.size();
    }
    EXPECT_EQ(lines_of(field).size(), lines);
  }
}

TEST(FieldLines, LinesLieInTheField) {
  for (std::size_t i = 0; i < field_rules().size(); ++i) {
    const Field field = field_of(static_cast<FieldKind>(i));
    const HalfSize half = half_size_of(field);
    for (const FieldLine& line : lines_of(field))
      for (const Vec2 p : line.path) {
        EXPECT_LE(std::abs(p.x), half.to_end_line_m + 1e-6) << rules_of(field.kind).name;
        EXPECT_LE(std::abs(p.y), half.to_side_line_m + 1e-6) << rules_of(field.kind).name;
      }
  }
}

TEST(FieldLines, RowsHaveSizesInOrder) {
  for (const FieldRules& rules : field_rules())
    for (const SizeRange& range : {rules.length, rules.width}) {
      EXPECT_GT(range.least_m, 0) << rules.name;
      EXPECT_LE(range.least_m, range.usual_m) << rules.name;
      EXPECT_LE(range.usual_m, range.most_m) << rules.name;
    }
}

TEST(FieldLines, TheCentreCircleOfSoccerHasARadiusOf915Centimetres) {
  const std::vector<FieldLine> lines = lines_of(field_of(FieldKind::kSoccer));
  const auto circle = std::ranges::find_if(lines, [](const FieldLine& line) {
    return line.path.size() > 30 && line.path.front() == line.path.back() && !line.is_disc;
  });
  ASSERT_NE(circle, lines.end());
  for (const Vec2 p : circle->path) EXPECT_NEAR(length(p), 9.15, 1e-9);
  for (std::size_t i = 0; i + 1 < circle->path.size(); ++i)
    EXPECT_GT(length((circle->path[i] + circle->path[i + 1]) * 0.5), 9.15 - 0.0041);
}

TEST(FieldLines, ThreePointLinesKeepTheirDistanceFromTheSides) {
  Field narrow = field_of(FieldKind::kBasketball);
  narrow.width_m = 13;
  const HalfSize half = half_size_of(narrow);
  double widest_m = 0;
  for (const FieldLine& line : lines_of("T e-1.575,0 6.75 s-0.9", half))
    for (const Vec2 p : line.path) widest_m = std::max(widest_m, std::abs(p.y));
  EXPECT_NEAR(widest_m, half.to_side_line_m - 0.9, 1e-6);
}

TEST(FieldLines, GoalsAreAtBothEndsAndFaceTheField) {
  const Field field{{}, FieldKind::kSoccer, {100, 200}, {100, 305}, 68};
  const std::vector<Equipment> goals = equipment_of(field);
  ASSERT_EQ(goals.size(), 2u);
  for (const Equipment& goal : goals) {
    EXPECT_NEAR(goal.at.x, 100, 1e-9);
    EXPECT_NEAR(std::abs(goal.at.y - 252.5), 52.44 + 1, 1e-6);
    EXPECT_NEAR(dot(goal.facing, unit(Vec2{100, 252.5} - goal.at)), 1, 1e-9);
  }
}

}  // namespace
}  // namespace citykiln::pitches
