#include "compiler/ground/cover/merge_slivers.h"

#include <gtest/gtest.h>

#include "tests/compiler/ground/cover/border_claims.h"
#include "tests/compiler/ground/wavy_surfaces.h"

namespace citykiln::ground {
namespace {

bool all_may(const CoverFace&) { return true; }

double total_m2(const std::vector<BorderFace>& faces) {
  double area_m2 = 0;
  for (const BorderFace& face : faces) area_m2 += face.area_m2;
  return area_m2;
}

TEST(MergeSlivers, FacesHaveOneLabelAndTileTheCell) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const auto borders = borders_of(wavy_surfaces(seed, 50, 1), kWavyCell);
    const MergedSlivers now = merge_slivers(borders, 1.5, all_may);
    const auto faces = border_faces_between(now.borders);
    EXPECT_EQ(total_m2(faces), 128.0 * 128.0);
    EXPECT_LT(faces.size(), border_faces_between(borders).size());
    EXPECT_TRUE(no_two_cross(now.borders));
    EXPECT_LE(now.error_m, 1.5);
  }
}

// Random places: where the polygon has changed, an old border is near.
TEST(MergeSlivers, WhatChangedWasNearABorder) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const auto borders = borders_of(wavy_surfaces(seed, 50, 1), kWavyCell);
    const MergedSlivers now = merge_slivers(borders, 2, all_may);
    const RandomSequence draw(seed, StableId{21}, "places");
    int changed = 0;
    constexpr int kPlaces = 20000;
    for (std::uint32_t i = 0; i < kPlaces; ++i) {
      const Vec2 p{draw.between(-128, 0, 2 * i), draw.between(0, 128, 2 * i + 1)};
      if (surface_between(borders, p) == surface_between(now.borders, p)) continue;
      ++changed;
      double nearest_m = 1e300;
      for (const Border& b : borders)
        if (!b.is_cell_border) nearest_m = std::min(nearest_m, distance_m(p, plane_point(b.a), plane_point(b.b)));
      EXPECT_LE(nearest_m, now.error_m);
    }
    EXPECT_NEAR(changed * 128.0 * 128.0 / kPlaces, now.area_m2, 0.25 * now.area_m2);
    EXPECT_GT(changed, 0);
  }
}

TEST(MergeSlivers, AtNoThicknessNothingIsMerged) {
  const auto borders = borders_of(wavy_surfaces(1, 50, 1), kWavyCell);
  const MergedSlivers now = merge_slivers(borders, 0, all_may);
  EXPECT_EQ(now.faces, 0u);
  EXPECT_EQ(faces_by_surface(border_faces_between(now.borders)), faces_by_surface(border_faces_between(borders)));
  EXPECT_EQ(now.borders.size(), borders.size());
}

TEST(MergeSlivers, TheCellsBorderStaysAsItIs) {
  const auto borders = borders_of(wavy_surfaces(2, 50, 1), kWavyCell);
  const auto on_border = [](std::span<const Border> all) {
    std::vector<Border> some;
    std::ranges::copy_if(all, std::back_inserter(some), &Border::is_cell_border);
    std::ranges::sort(some, {}, [](const Border& b) { return std::tuple(b.a, b.b); });
    return some;
  };
  EXPECT_EQ(on_border(merge_slivers(borders, 100, all_may).borders), on_border(borders));
}

TEST(MergeSlivers, OrderDoesNotCount) {
  auto borders = borders_of(wavy_surfaces(3, 60, 1), kWavyCell);
  const MergedSlivers once = merge_slivers(borders, 1, all_may);
  std::ranges::reverse(borders);
  EXPECT_EQ(once.borders, merge_slivers(borders, 1, all_may).borders);
}

TEST(MergeSlivers, OnlyWhatMayYieldDoes) {
  const auto borders = borders_of(wavy_surfaces(4, 60, 1), kWavyCell);
  EXPECT_EQ(merge_slivers(borders, 2, [](const CoverFace&) { return false; }).faces, 0u);
  const auto before = faces_by_surface(border_faces_between(borders));
  const auto now = merge_slivers(borders, 2, [](const CoverFace& face) { return face.polygon % 2 == 0; });
  ASSERT_GT(now.faces, 0u);
  for (const auto& [surface, faces] : before)
    if (surface % 2 == 1 && surface != 0xffffffffu) {
      EXPECT_TRUE(faces_by_surface(border_faces_between(now.borders)).contains(surface));
    }
}

void add_border(std::vector<Border>& borders, Vec2 from, Vec2 to, std::uint32_t left, std::uint32_t right,
                bool is_cell_border) {
  const GridPoint a = grid_point(from), b = grid_point(to);
  borders.push_back(a < b ? Border{a, b, left, right, is_cell_border} : Border{b, a, right, left, is_cell_border});
}

void add_box(std::vector<Border>& borders, const Box2& box, std::uint32_t inside, std::uint32_t outside,
             bool is_cell_border) {
  const std::vector<Vec2> corners = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  for (int i = 0; i < 4; ++i) add_border(borders, corners[i], corners[(i + 1) % 4], inside, outside, is_cell_border);
}

// The cell's border with 9 inside, and boxes stacked on each other from (-100, 20) up, 40 m wide: 1, 2, 3 …
std::vector<Border> stacked(const std::vector<double>& heights_m) {
  std::vector<Border> borders;
  add_box(borders, kWavyCell, 9, 9, true);
  double y = 20;
  for (std::uint32_t i = 1; i <= heights_m.size(); ++i) {
    const double top = y + heights_m[i - 1];
    add_border(borders, {-100, y}, {-60, y}, i, i == 1 ? 9 : i - 1, false);
    add_border(borders, {-60, y}, {-60, top}, i, 9, false);
    add_border(borders, {-100, top}, {-100, y}, i, 9, false);
    y = top;
  }
  add_border(borders, {-60, y}, {-100, y}, static_cast<std::uint32_t>(heights_m.size()), 9, false);
  return borders;
}

// A square of 0.5 m inside one of 1 m, in the middle of 9.
std::vector<Border> nested(std::uint32_t inner) {
  std::vector<Border> borders;
  add_box(borders, kWavyCell, 9, 9, true);
  add_box(borders, {{-64.5, 63.5}, {-63.5, 64.5}}, 1, 9, false);
  add_box(borders, {{-64.25, 63.75}, {-63.75, 64.25}}, inner, 1, false);
  return borders;
}

TEST(MergeSlivers, AStripGoesToItsLongestNeighbour) {
  const auto borders = stacked({40, 0.3125});
  const MergedSlivers now = merge_slivers(borders, 0.5, all_may);
  EXPECT_EQ(now.faces, 1u);
  EXPECT_EQ(now.area_m2, 40 * 0.3125);
  // 40.6 m with all around, 40 m with the box
  EXPECT_EQ(surface_between(now.borders, {-80, 60.1}), 9u);
  EXPECT_EQ(now.borders.size(), 4u + 4u);
}

TEST(MergeSlivers, AStripUpToTheThicknessGoesAWiderOneStays) {
  EXPECT_EQ(merge_slivers(stacked({0.5}), 0.5, all_may).faces, 1u);
  EXPECT_EQ(merge_slivers(stacked({1.25}), 0.5, all_may).faces, 0u);
}

// A ring road of 64 corners outside and 7 inside: triangles fan out from few corners to many.
TEST(MergeSlivers, ABentStripOfUnequalSidesGoes) {
  const auto ring = [](int corners, double radius_m) {
    Ring points;
    for (int i = 0; i < corners; ++i) {
      const double turn = 2 * 3.14159265 * i / corners;
      points.push_back(plane_point(grid_point({-64 + radius_m * std::cos(turn), 64 + radius_m * std::sin(turn)})));
    }
    return points;
  };
  Ring hole = ring(7, 30);
  std::ranges::reverse(hole);
  // the inside's sides bulge inwards by 3 m
  const std::vector<LandCoverPolygon> surfaces = {
      {{{OsmType::kWay, 1}, 0}, map::LandCoverClass::kMeadow, 9, {ring(64, 30.5), hole}}};
  const auto borders = borders_of(surfaces, kWavyCell);
  // the widest circle has a radius of 1.74 m
  EXPECT_EQ(merge_slivers(borders, 2, all_may).faces, 1u);
  EXPECT_EQ(merge_slivers(borders, 1.7, all_may).faces, 0u);
}

// The frame is 0.25 m wide. Together with the merged inside it is a square of 1 m.
TEST(MergeSlivers, ThinFacesYieldWhileTheyAreThinTogether) {
  const MergedSlivers fine = merge_slivers(nested(2), 0.375, all_may);
  EXPECT_EQ(fine.faces, 1u);
  EXPECT_EQ(fine.area_m2, 0.25);
  EXPECT_EQ(surface_between(fine.borders, {-64.01, 64.02}), 1u);
  const MergedSlivers coarse = merge_slivers(nested(2), 0.75, all_may);
  EXPECT_EQ(coarse.faces, 2u);
  EXPECT_EQ(coarse.area_m2, 1);
  EXPECT_EQ(coarse.borders.size(), 4u);
}

TEST(MergeSlivers, WhatGetsItsOwnSurfaceBackHasNotChanged) {
  EXPECT_EQ(merge_slivers(nested(9), 0.75, all_may).area_m2, 0.75);
}

TEST(MergeSlivers, NothingInNothingOut) { EXPECT_TRUE(merge_slivers({}, 1, all_may).borders.empty()); }

TEST(MergeSlivers, RegionsServeManyTolerances) {
  const auto borders = borders_of(wavy_surfaces(3, 50, 1), kWavyCell);
  const CoverFaces between = faces_between(borders);
  for (const double thickness_m : {2.0, 0.1, 1.0, 2.0}) {
    const MergedSlivers one = merge_slivers(between, thickness_m, all_may),
                        other = merge_slivers(borders, thickness_m, all_may);
    EXPECT_FALSE(one.borders.empty());
    EXPECT_EQ(one.borders, other.borders);
    EXPECT_EQ(one.error_m, other.error_m);
  }
}

}  // namespace
}  // namespace citykiln::ground
