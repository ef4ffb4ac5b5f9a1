#include "compiler/ground/correction/corrected_land.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/correction/heightmap_error.h"
#include "compiler/map/plane/smooth_land.h"
#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

constexpr double kStep_m = 64;

// Hills that samples every 64 m cannot show well, divided as compile does.
map::Heightfield coarse_hills(std::uint64_t seed = 1) {
  return map::smooth_land(hilly_field(seed, 60, 12, 1024), map::smooth_parts({kStep_m, kStep_m}));
}

map::Heightfield slope_of(double grade, double step_m = kStep_m) {
  return field_from([&](double x, double) { return 500 + grade * x; }, 1024, step_m);
}

KnownLine line_at(Vec2 from, Vec2 to, double from_m, double to_m, KnownKind kind = KnownKind::kRoad) {
  return {from, to, from_m, to_m, kind};
}

KnownLine line_above(const map::Heightfield& field, Vec2 from, Vec2 to, double above_m) {
  return line_at(from, to, height_m_at(field, from) + above_m, height_m_at(field, to) + above_m);
}

double distance_from_line_m(const map::Heightfield& field, const KnownLine& line) {
  double largest_m = 0;
  for (double t = 0; t <= 1; t += 1.0 / 64)
    largest_m = std::max(largest_m, std::abs(height_m_at(field, line.from + (line.to - line.from) * t) -
                                             (line.from_m + (line.to_m - line.from_m) * t)));
  return largest_m;
}

TEST(CorrectedLand, StaysWithoutLines) {
  const map::Heightfield field = coarse_hills();
  EXPECT_EQ(corrected_land(field, {}), field);
}

TEST(CorrectedLand, FollowsARoadWithinTheErrorOfTheHeightmap) {
  const map::Heightfield field = slope_of(0.4);
  const KnownLine road = line_above(field, {-300, -500}, {-300, 500}, -3.5);
  EXPECT_GT(heightmap_error_m(field, {-300, 0}), 3.5);
  EXPECT_LT(distance_from_line_m(corrected_land(field, std::span(&road, 1)), road), 0.35);
}

TEST(CorrectedLand, RemainsCutBeyondTheErrorOfTheHeightmap) {
  const map::Heightfield field = slope_of(0.1);
  const KnownLine road = line_above(field, {-300, -500}, {-300, 500}, -30);
  const double error_m = heightmap_error_m(field, {-300, 0});
  // a quarter of the rise of a cell, and a metre of noise
  EXPECT_NEAR(error_m, 6.4 / 4 + 1, 0.05);
  EXPECT_GT(distance_from_line_m(corrected_land(field, std::span(&road, 1)), road), 29 - error_m);
}

TEST(CorrectedLand, ReachesAsFarAsOneStepOfSamples) {
  const map::Heightfield field = slope_of(0.4);
  const KnownLine road = line_above(field, {-300, -500}, {-300, 500}, -3.5);
  const map::Heightfield land = corrected_land(field, std::span(&road, 1));
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i)
      if (std::abs(field.vertex(i, j).x + 300) > kStep_m || std::abs(field.vertex(i, j).y) > 500 + kStep_m) {
        EXPECT_EQ(land.height_m_at_vertex(i, j), field.height_m_at_vertex(i, j));
      }
}

TEST(CorrectedLand, LeavesFineHeightmapsAsTheyAre) {
  const map::Heightfield field = slope_of(0.4, 8);
  const KnownLine road = line_above(field, {-300, -500}, {-300, 500}, -3.5);
  EXPECT_EQ(corrected_land(field, std::span(&road, 1)), field);
}

TEST(CorrectedLand, LevelLinesAreFollowedWhateverTheHeightmapSays) {
  const map::Heightfield field = slope_of(0.1);
  KnownLine runway = line_above(field, {-300, -500}, {-300, 500}, -30);
  runway.kind = KnownKind::kLevel;
  EXPECT_LT(distance_from_line_m(corrected_land(field, std::span(&runway, 1)), runway), 3);
}

TEST(CorrectedLand, IsNotLoweredBelowWaterBesideARoad) {
  const map::Heightfield field = slope_of(0.4);
  const KnownLine road = line_above(field, {-300, -500}, {-300, 500}, -3.5);
  KnownLine stream = line_above(field, {-310, -500}, {-310, 500}, 0);
  stream.kind = KnownKind::kWater;
  const std::vector<KnownLine> both{road, stream};
  const map::Heightfield without = corrected_land(field, std::span(&road, 1)), with = corrected_land(field, both);
  EXPECT_GT(height_m_at(with, {-310, 0}), height_m_at(without, {-310, 0}) + 0.75);
  EXPECT_EQ(corrected_land(field, std::span(&stream, 1)), field);
}

// Windows are windows of the corrected field, farther inside than kCorrectionSteps.
TEST(CorrectedLand, DependsOnWhatIsNear) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const map::Heightfield field = coarse_hills(seed);
    const RandomSequence draw(seed, StableId{3}, "lines");
    std::vector<KnownLine> lines, near;
    const Box2 window{{-900, -900}, {900, 900}};
    for (std::uint32_t k = 0; k < 40; ++k) {
      const Vec2 from{draw.between(-1000, 1000, 4 * k), draw.between(-1000, 1000, 4 * k + 1)};
      const Vec2 to = from + Vec2{draw.between(-90, 90, 4 * k + 2), draw.between(-90, 90, 4 * k + 3)};
      lines.push_back(line_above(field, from, to, draw.between(-20, 20, 1000 + k)));
      if (window.contains(from) || window.contains(to)) near.push_back(lines.back());
    }
    const map::Heightfield whole = corrected_land(field, lines), part = corrected_land(window_of(field, window), near);
    const double inside_m = 900 - kCorrectionSteps * kStep_m;
    for (double x = -inside_m; x <= inside_m; x += 7)
      for (double y = -inside_m; y <= inside_m; y += 7)
        EXPECT_EQ(height_m_at(whole, {x, y}), height_m_at(part, {x, y}));
  }
}

}  // namespace
}  // namespace citykiln::ground
