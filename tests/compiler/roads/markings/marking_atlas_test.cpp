#include "compiler/roads/markings/marking_atlas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/roads/markings/markings.h"
#include "tests/compiler/roads/markings/marking_layout_text.h"

namespace citykiln::roads {
namespace {

using map::LandCoverClass;
using materials::TextureImage;

// Carriageways of two lanes, each a little wider than the one before.
std::vector<MarkingLayout> carriageways(int count) {
  std::vector<MarkingLayout> layouts;
  for (int i = 0; i < count; ++i) {
    layouts.push_back(layout(LandCoverClass::kSecondaryRoad, "dd v^"));
    layouts.back().lanes[0].width_m = 4 + i / 64.0;
  }
  return layouts;
}

TextureImage::Texel at(const TextureImage& atlas, std::size_t column, std::size_t row) {
  return atlas.texels[row * atlas.columns + column];
}

TEST(MarkingAtlas, TexelsDivideTheLayout) {
  for (const double tolerance_m : {0.0, 0.01, 0.03, 0.1, 0.5, 2.5, 12.5, 100.0}) {
    const MarkingAtlas atlas = make_marking_atlas(carriageways(2), tolerance_m);
    EXPECT_DOUBLE_EQ(atlas.image.texel_m * atlas.image.rows, kLayoutLength_m);
    EXPECT_GE(atlas.image.texel_m, std::min(std::max(tolerance_m, kFinestTexel_m), kLayoutLength_m) - 1e-6);
  }
  EXPECT_EQ(make_marking_atlas(carriageways(2), 0.02).image.rows, 400u);
}

TEST(MarkingAtlas, ColumnsAndTheirGuttersNeverOverlap) {
  for (const int count : {1, 7, 100, 600}) {
    const std::vector<MarkingLayout> layouts = carriageways(count);
    const MarkingAtlas atlas = make_marking_atlas(layouts, 0.03);
    // in texels: where the next gutter may begin
    double free = 0;
    EXPECT_NE(atlas.left_m[0], kNoColumn_m);
    for (std::size_t i = 0; i < layouts.size() && atlas.left_m[i] != kNoColumn_m; ++i) {
      const double left = atlas.left_m[i] / atlas.image.texel_m;
      EXPECT_GE(left - kGutter_texels, free - 1e-6);
      free = left + std::ceil(width_m(layouts[i]) / atlas.image.texel_m - 1e-6) + kGutter_texels;
    }
    EXPECT_LE(free, atlas.image.columns + 1e-6);
  }
}

TEST(MarkingAtlas, TheMaximumWidthHolds) {
  for (const int count : {20, 100, 900, 5000}) {
    const MarkingAtlas atlas = make_marking_atlas(carriageways(count), 0.02);
    EXPECT_LE(atlas.image.columns, kWidest_texels);
    EXPECT_EQ(atlas.image.texels.size(), std::size_t{atlas.image.columns} * atlas.image.rows);
    EXPECT_LE(atlas.image.texel_m, kCoarsestTexel_m);
  }
}

TEST(MarkingAtlas, TexelsGrowNoFurtherThanTheyMust) {
  // 25 strips of 7.25 to 7.6 m: 185.6 m and 200 gutter texels at 3 cm are 6400 columns
  EXPECT_EQ(make_marking_atlas(carriageways(25), 0.02).image.rows, 400u);
  const MarkingAtlas atlas = make_marking_atlas(carriageways(40), 0.02);
  EXPECT_LT(atlas.image.rows, 400u);
  EXPECT_GT(atlas.image.columns, kWidest_texels * 99 / 100);
}

TEST(MarkingAtlas, WhatDoesNotFitHasNoColumn) {
  const MarkingAtlas atlas = make_marking_atlas(carriageways(5000), 0.02);
  const auto first = std::find(atlas.left_m.begin(), atlas.left_m.end(), kNoColumn_m);
  EXPECT_GT(first - atlas.left_m.begin(), 100);
  EXPECT_TRUE(std::all_of(first, atlas.left_m.end(), [](double left_m) { return left_m == kNoColumn_m; }));
  MarkingLayout broad = layout(LandCoverClass::kSecondaryRoad, "dd v^");
  broad.lanes[0].width_m = 1e9;
  EXPECT_EQ(make_marking_atlas(std::vector{broad}, 0.02).left_m, std::vector{kNoColumn_m});
  EXPECT_TRUE(make_marking_atlas({}, 0.02).image.texels.empty());
}

TEST(MarkingAtlas, GuttersRepeatTheOutermostTexels) {
  const std::vector<MarkingLayout> layouts = carriageways(3);
  const TextureImage atlas = make_marking_atlas(layouts, 0.03).image;
  const double left_m = make_marking_atlas(layouts, 0.03).left_m[1];
  const auto first = static_cast<std::size_t>(std::lround(left_m / atlas.texel_m));
  const auto last = first + static_cast<std::size_t>(width_m(layouts[1]) / atlas.texel_m) - 1;
  ASSERT_GT(atlas.rows, 0u);
  for (std::size_t row = 0; row < atlas.rows; row += 7) {
    for (std::size_t i = 1; i <= kGutter_texels; ++i) {
      EXPECT_EQ(at(atlas, first - i, row), at(atlas, first, row));
      EXPECT_EQ(at(atlas, last + i, row), at(atlas, last, row));
    }
  }
}

TEST(MarkingAtlas, MarksLieInTheirColumn) {
  MarkingLayout strip = layout(LandCoverClass::kTertiaryRoad, "dd v^");
  const std::vector<MarkingLayout> layouts = {layout(LandCoverClass::kRailway, "r -"), strip};
  const MarkingAtlas atlas = make_marking_atlas(layouts, 0.03);
  // the middle of the centre line's dash, and bare road beside it
  const auto column = static_cast<std::size_t>((atlas.left_m[1] + 3.25) / atlas.image.texel_m);
  EXPECT_EQ(at(atlas.image, column, 200), kWhite);
  // between the seam of the lanes and the tyres' bands
  EXPECT_EQ(at(atlas.image, column + 10, 20), base_colour_of(strip));
  EXPECT_EQ(at(atlas.image, column + 10, 200), base_colour_of(strip));
}

// FNV-1a of all texels; all CPUs and compilers must agree.
TEST(MarkingAtlas, HasTheSameBytesOnEveryMachine) {
  std::vector<MarkingLayout> layouts;
  for (const char* section : {"SddS vv^^", "cddc vv^^", "bdtdb vv-^^", "d/c ^^^"})
    for (const StretchKind stretch :
         {StretchKind::kAlong, StretchKind::kStart, StretchKind::kEnd, StretchKind::kZebra}) {
      layouts.push_back(layout(LandCoverClass::kSecondaryRoad, section));
      layouts.back().stretch = stretch;
      layouts.back().control = Control::kGiveWay;
      layouts.back().lanes[1].turns = map::kTurnLeft | map::kTurnThrough;
    }
  std::sort(layouts.begin(), layouts.end());
  std::uint64_t hash = 14695981039346656037u;
  for (const TextureImage::Texel& texel : make_marking_atlas(layouts, 0.07).image.texels)
    for (const std::uint8_t byte : texel) hash = (hash ^ byte) * 1099511628211u;
  EXPECT_EQ(hash, 7833513934140471283u);
}

}  // namespace
}  // namespace citykiln::roads
