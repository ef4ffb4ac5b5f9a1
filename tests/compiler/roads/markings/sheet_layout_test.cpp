#include "compiler/roads/markings/sheet_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/roads/markings/markings.h"
#include "tests/compiler/roads/pattern_text.h"

namespace citykiln::roads {
namespace {

using map::SurfaceClass;
using materials::Sheet;

// Carriageways of two lanes, each a little wider than the one before.
std::vector<Pattern> carriageways(int count) {
  std::vector<Pattern> patterns;
  for (int i = 0; i < count; ++i) {
    patterns.push_back(pattern(SurfaceClass::kSecondaryRoad, "dd v^"));
    patterns.back().lanes[0].width_m = 4 + i / 64.0;
  }
  return patterns;
}

Sheet::Texel at(const Sheet& sheet, std::size_t column, std::size_t row) {
  return sheet.texels[row * sheet.columns + column];
}

TEST(SheetLayout, TexelsDivideThePattern) {
  for (const double tolerance_m : {0.0, 0.01, 0.03, 0.1, 0.5, 2.5, 12.5, 100.0}) {
    const SheetLayout layout = lay_out(carriageways(2), tolerance_m);
    EXPECT_DOUBLE_EQ(layout.sheet.texel_m * layout.sheet.rows, kPatternLength_m);
    EXPECT_GE(layout.sheet.texel_m, std::min(std::max(tolerance_m, kFinestTexel_m), kPatternLength_m) - 1e-6);
  }
  EXPECT_EQ(lay_out(carriageways(2), 0.02).sheet.rows, 400u);
}

TEST(SheetLayout, ColumnsAndTheirGuttersNeverOverlap) {
  for (const int count : {1, 7, 100, 600}) {
    const std::vector<Pattern> patterns = carriageways(count);
    const SheetLayout layout = lay_out(patterns, 0.03);
    // in texels: where a gutter may begin
    double free = 0;
    for (std::size_t i = 0; i < patterns.size() && layout.left_m[i] != kNoColumn_m; ++i) {
      const double left = layout.left_m[i] / layout.sheet.texel_m;
      EXPECT_GE(left - kGutter_texels, free - 1e-6);
      free = left + std::ceil(width_m(patterns[i]) / layout.sheet.texel_m - 1e-6) + kGutter_texels;
    }
    EXPECT_LE(free, layout.sheet.columns + 1e-6);
  }
}

TEST(SheetLayout, ItsBudgetHolds) {
  for (const int count : {20, 100, 900, 5000}) {
    const SheetLayout layout = lay_out(carriageways(count), 0.02);
    EXPECT_LE(layout.sheet.columns, kMostColumns);
    EXPECT_EQ(layout.sheet.texels.size(), std::size_t{layout.sheet.columns} * layout.sheet.rows);
    EXPECT_LE(layout.sheet.texel_m, kCoarsestTexel_m);
  }
}

TEST(SheetLayout, TexelsGrowNoFurtherThanTheyMust) {
  // 25 strips of 7.25 to 7.6 m: 185.6 m and 200 gutter texels at 3 cm are 6400 columns
  EXPECT_EQ(lay_out(carriageways(25), 0.02).sheet.rows, 400u);
  const SheetLayout layout = lay_out(carriageways(40), 0.02);
  EXPECT_LT(layout.sheet.rows, 400u);
  EXPECT_GT(layout.sheet.columns, kMostColumns * 99 / 100);
}

TEST(SheetLayout, WhatDoesNotFitHasNoColumn) {
  const SheetLayout layout = lay_out(carriageways(5000), 0.02);
  const auto first = std::find(layout.left_m.begin(), layout.left_m.end(), kNoColumn_m);
  EXPECT_GT(first - layout.left_m.begin(), 100);
  EXPECT_TRUE(std::all_of(first, layout.left_m.end(), [](double left_m) { return left_m == kNoColumn_m; }));
  Pattern broad = pattern(SurfaceClass::kSecondaryRoad, "dd v^");
  broad.lanes[0].width_m = 1e9;
  EXPECT_EQ(lay_out(std::vector{broad}, 0.02).left_m, std::vector{kNoColumn_m});
  EXPECT_TRUE(lay_out({}, 0.02).sheet.texels.empty());
}

TEST(SheetLayout, GuttersRepeatTheOutermostTexels) {
  const std::vector<Pattern> patterns = carriageways(3);
  const Sheet sheet = lay_out(patterns, 0.03).sheet;
  const double left_m = lay_out(patterns, 0.03).left_m[1];
  const auto first = static_cast<std::size_t>(std::lround(left_m / sheet.texel_m));
  const auto last = first + static_cast<std::size_t>(width_m(patterns[1]) / sheet.texel_m) - 1;
  for (std::size_t row = 0; row < sheet.rows; row += 7) {
    for (std::size_t i = 1; i <= kGutter_texels; ++i) {
      EXPECT_EQ(at(sheet, first - i, row), at(sheet, first, row));
      EXPECT_EQ(at(sheet, last + i, row), at(sheet, last, row));
    }
  }
}

TEST(SheetLayout, MarksLieInTheirColumn) {
  Pattern strip = pattern(SurfaceClass::kTertiaryRoad, "dd v^");
  const std::vector<Pattern> patterns = {pattern(SurfaceClass::kRailway, "r -"), strip};
  const SheetLayout layout = lay_out(patterns, 0.03);
  // the middle of the centre line's dash, and bare road beside it
  const auto column = static_cast<std::size_t>((layout.left_m[1] + 3.25) / layout.sheet.texel_m);
  EXPECT_EQ(at(layout.sheet, column, 200), kWhite);
  EXPECT_EQ(at(layout.sheet, column, 20), base_colour_of(strip));
  EXPECT_EQ(at(layout.sheet, column + 20, 200), base_colour_of(strip));
}

// FNV-1a of all texels, as computed on the machine that wrote this: other CPUs and compilers must agree.
TEST(SheetLayout, HasTheSameBytesOnEveryMachine) {
  std::vector<Pattern> patterns;
  for (const char* section : {"SddS vv^^", "cddc vv^^", "bdtdb vv-^^", "d/c ^^^"})
    for (const Stretch stretch : {Stretch::kAlong, Stretch::kStart, Stretch::kEnd, Stretch::kZebra}) {
      patterns.push_back(pattern(SurfaceClass::kSecondaryRoad, section));
      patterns.back().stretch = stretch;
      patterns.back().control = Control::kGiveWay;
      patterns.back().lanes[1].turns = map::kTurnLeft | map::kTurnThrough;
    }
  std::sort(patterns.begin(), patterns.end());
  std::uint64_t hash = 14695981039346656037u;
  for (const Sheet::Texel& texel : lay_out(patterns, 0.07).sheet.texels)
    for (const std::uint8_t byte : texel) hash = (hash ^ byte) * 1099511628211u;
  EXPECT_EQ(hash, 3874357215575089761u);
}

}  // namespace
}  // namespace citykiln::roads
