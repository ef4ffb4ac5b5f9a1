#include "compiler/fields/divide_land.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/fields/cut_rings.h"

namespace citykiln::fields {
namespace {

constexpr double kUsual_m2 = 20000;

FieldRule usual(Vec2) { return {.area_m2 = kUsual_m2, .aspect = 2}; }

Polygon rectangle(Vec2 low, Vec2 high) { return {{low, {high.x, low.y}, high, {low.x, high.y}}, {}}; }

Division divided(const Polygon& land, std::vector<Polyline> lines = {}) {
  return divide(land, lines, usual, StableId{7}, 1);
}

double area_of_fields(const Division& division) {
  double sum_m2 = 0;
  for (const Field& field : division.fields) sum_m2 += area_m2(field.polygon);
  return sum_m2;
}

TEST(DivideLand, FieldsCoverTheLandOnce) {
  const Polygon land = {{{0, 0}, {900, 50}, {850, 700}, {400, 500}, {-50, 650}},
                        {{{300, 200}, {300, 300}, {400, 300}}}};
  const Division division = divided(land);
  EXPECT_GT(division.fields.size(), 8u);
  EXPECT_NEAR(area_of_fields(division), area_m2(land), 0.001 * area_m2(land));
  int inside = 0;
  for (double x = -40; x < 900; x += 13)
    for (double y = 1; y < 700; y += 17) {
      const auto holds = [&](const Field& field) { return contains(field.polygon, {x + 0.3, y + 0.1}); };
      EXPECT_LE(std::ranges::count_if(division.fields, holds), 1);
      inside += std::ranges::any_of(division.fields, holds);
    }
  EXPECT_NEAR(inside * 13.0 * 17.0, area_m2(land), 0.02 * area_m2(land));
}

TEST(DivideLand, FieldsHaveAboutTheUsualSizeAndForm) {
  const Division division = divided(rectangle({0, 0}, {1400, 1100}));
  const double mean_m2 = area_of_fields(division) / static_cast<double>(division.fields.size());
  EXPECT_GT(mean_m2, kUsual_m2 / 2);
  EXPECT_LT(mean_m2, kUsual_m2 * 1.6);
  for (const Field& field : division.fields) {
    const Box2 box = box_of(field.polygon.outer);
    const double aspect = std::max(box.width(), box.height()) / std::min(box.width(), box.height());
    EXPECT_LT(aspect, 4.5);
  }
}

TEST(DivideLand, NoFieldLiesOnBothSidesOfALine) {
  const Polyline track = {{-10, 40}, {300, 60}, {610, 35}};
  for (const Field& field : divided(rectangle({0, 0}, {600, 100}), {track}).fields) {
    bool is_above = false, is_below = false;
    for (const Vec2 p : field.polygon.outer) {
      const double line_m = p.x < 300 ? 40 + (p.x + 10) * 20 / 310 : 60 - (p.x - 300) * 25 / 310;
      is_above |= p.y > line_m + 1, is_below |= p.y < line_m - 1;
    }
    EXPECT_FALSE(is_above && is_below);
  }
}

TEST(DivideLand, FieldsDoNotDependOnLandFarAway) {
  const Division small = divided(rectangle({0, 0}, {9000, 1000})), large = divided(rectangle({0, 0}, {14000, 1000}));
  int compared = 0;
  for (const Field& field : small.fields) {
    if (box_of(field.polygon.outer).max.x > 9000 - kFieldRadius_m) continue;
    const auto same = [&](const Field& other) {
      return other.number == field.number && other.polygon == field.polygon;
    };
    ++compared;
    EXPECT_TRUE(std::ranges::any_of(large.fields, same));
  }
  EXPECT_GT(compared, 100);
}

TEST(DivideLand, SmallLandIsOneField) {
  const Polygon land = rectangle({0, 0}, {100, 150});
  const Division division = divided(land);
  ASSERT_EQ(division.fields.size(), 1u);
  EXPECT_TRUE(division.borders.empty());
  EXPECT_EQ(division.fields[0].along, (Vec2{0, 1}));
}

TEST(CutRings, BothSidesHaveTheSamePointsOnTheLine) {
  const std::vector<Ring> rings = {{{0, 0}, {10, 1}, {9, 8}, {5, 3}, {1, 9}}};
  const Vec2 at{3, 4.3}, along = unit(Vec2{5, 0.7});
  const std::vector<Ring> left = left_of_cut(rings, at, along), right = left_of_cut(rings, at, along * -1);
  EXPECT_NEAR(area_of(left) + area_of(right), area_of(rings), 0.1);
  for (const Vec2 p : left.front())
    if (std::abs(cross(along, p - at)) < 0.01) {
      EXPECT_NE(std::ranges::find(right.front(), p), right.front().end());
    }
  EXPECT_EQ(inside_parts(rings, at, along).size(), 2u);
}

}  // namespace
}  // namespace citykiln::fields
