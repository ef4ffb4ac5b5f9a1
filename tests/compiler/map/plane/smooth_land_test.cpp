#include "compiler/map/plane/smooth_land.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/map/plane/bicubic.h"

namespace citykiln::map {
namespace {

Heightfield samples_with(int columns, int rows, const std::function<std::int32_t(int i, int j)>& height) {
  Heightfield field{{-64, 32}, {92.5, 64}, columns, rows, {}, 0};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) field.heights.push_back(height(i, j));
  return field;
}

// Steps of whole metres up to 100 m.
Heightfield rough_samples(std::uint64_t seed, int columns = 9, int rows = 8) {
  const RandomSequence random(seed, StableId{1}, "heights");
  return samples_with(columns, rows, [&](int i, int j) {
    return static_cast<std::int32_t>(random.between(0, 100, static_cast<std::uint32_t>(j * columns + i))) * 64;
  });
}

// A height of the surface through a field's samples, at sample (i, j) and shares of a step beyond.
double smooth_at(const Heightfield& samples, int i, int j, double u, double v) {
  return smooth_height<double>([&](int c, int r) { return samples.height_m_at_vertex(i + c, j + r); }, u, v);
}

TEST(SmoothLand, TheLongerStepDecidesTheParts) {
  EXPECT_EQ(smooth_parts({10, 24}), 1);
  EXPECT_EQ(smooth_parts({24.125, 1}), 2);
  EXPECT_EQ(smooth_parts({22, 30.875}), 2);
  EXPECT_EQ(smooth_parts({68.375, 92.5}), 4);
  EXPECT_EQ(smooth_parts({128, 128}), 4);
}

TEST(SmoothLand, KeepsItsSamples) {
  for (const int parts : {1, 2, 4}) {
    const Heightfield samples = rough_samples(7), land = smooth_land(samples, parts);
    EXPECT_EQ(samples_of(land), samples) << parts;
    if (parts == 1) continue;
    ASSERT_EQ(land.columns, (samples.columns - 3) * parts + 1);
    ASSERT_EQ(land.rows, (samples.rows - 3) * parts + 1);
    for (int j = 0; j < land.rows; j += parts)
      for (int i = 0; i < land.columns; i += parts) {
        EXPECT_EQ(land.vertex(i, j), samples.vertex(i / parts + 1, j / parts + 1));
        EXPECT_EQ(land.height_m_at_vertex(i, j), samples.height_m_at_vertex(i / parts + 1, j / parts + 1));
      }
  }
}

TEST(SmoothLand, LiesOnTheSurfaceThroughItsSamples) {
  const Heightfield samples = rough_samples(3), land = smooth_land(samples, 4);
  for (int j = 0; j < land.rows - 1; ++j)
    for (int i = 0; i < land.columns - 1; ++i)
      EXPECT_NEAR(land.height_m_at_vertex(i, j), smooth_at(samples, i / 4 + 1, j / 4 + 1, i % 4 / 4.0, j % 4 / 4.0),
                  kHeightQuantum_m / 2);
}

TEST(SmoothLand, SlopesAreEqualOnBothSidesOfASampleLine) {
  constexpr double kBeside = 1e-5;
  const Heightfield samples = rough_samples(11);
  for (int i = 2; i < samples.columns - 2; ++i)
    for (const double v : {0.0, 0.3, 0.5, 1.0}) {
      const double at = smooth_at(samples, i, 3, 0, v);
      EXPECT_NEAR(at, smooth_at(samples, i - 1, 3, 1, v), 1e-9);
      const double before = (at - smooth_at(samples, i - 1, 3, 1 - kBeside, v)) / kBeside;
      const double after = (smooth_at(samples, i, 3, kBeside, v) - at) / kBeside;
      EXPECT_NEAR(before, after, 0.02) << i << " " << v;
      const double on_line = smooth_at(samples, 3, i, v, 0);
      const double south = (on_line - smooth_at(samples, 3, i - 1, v, 1 - kBeside)) / kBeside;
      const double north = (smooth_at(samples, 3, i, v, kBeside) - on_line) / kBeside;
      EXPECT_NEAR(south, north, 0.02) << i << " " << v;
    }
}

TEST(SmoothLand, APlaneStaysAPlane) {
  const Heightfield land =
      smooth_land(samples_with(9, 8, [](int i, int j) { return 4 * (300 + 37 * i - 113 * j); }), 4);
  for (int j = 0; j < land.rows; ++j)
    for (int i = 0; i < land.columns; ++i)
      EXPECT_EQ(land.heights[static_cast<std::size_t>(j) * land.columns + i], 4 * (300 + 37 - 113) + 37 * i - 113 * j);
}

TEST(SmoothLand, ALakeBelowACliffStaysLevel) {
  for (const bool is_pit : {false, true}) {
    // water in columns 0 to 4
    const Heightfield samples = samples_with(
        10, 9, [&](int i, int j) { return i <= 4 ? 500 * 64 : 500 * 64 + (is_pit ? -1 : 1) * (i * i * 400 + j * 77); });
    const Heightfield land = smooth_land(samples, 4);
    for (int j = 0; j < land.rows; ++j)
      for (int i = 0; i <= 12; ++i) EXPECT_EQ(land.height_m_at_vertex(i, j), 500);
  }
}

// The largest share of the range of four samples by which the surface between them leaves it.
double overshoot_of(const Heightfield& samples, int i, int j) {
  double low = 1e9, high = -1e9, least = 1e9, most = -1e9;
  for (int c = 0; c < 4; ++c) {
    const double z = samples.height_m_at_vertex(i + c % 2, j + c / 2);
    low = std::min(low, z), high = std::max(high, z);
  }
  for (double v = 0; v <= 1; v += 0.125)
    for (double u = 0; u <= 1; u += 0.125) {
      const double z = smooth_at(samples, i, j, u, v);
      least = std::min(least, z), most = std::max(most, z);
    }
  const double beyond = std::max(low - least, most - high);
  return high > low ? beyond / (high - low) : beyond;
}

TEST(SmoothLand, LeavesTheRangeOfFourSamplesByLessThanThatRange) {
  double largest = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Heightfield samples = rough_samples(seed);
    for (int j = 1; j < samples.rows - 2; ++j)
      for (int i = 1; i < samples.columns - 2; ++i) largest = std::max(largest, overshoot_of(samples, i, j));
  }
  EXPECT_LE(largest, kMostOvershoot);
  EXPECT_GT(largest, 0.1);
}

TEST(SmoothLand, AWindowIsTheLandOfTheWindowsSamples) {
  const Heightfield land = smooth_land(rough_samples(5, 30, 24), 4);
  for (const Box2 box : {Box2{{300, 400}, {700, 900}}, Box2{{-500, -500}, {100, 200}}, land.box()}) {
    const Heightfield window = window_of(land, box);
    EXPECT_EQ(window, smooth_land(samples_of(window), 4));
    for (double y = std::max(box.min.y, land.min.y); y <= std::min(box.max.y, land.box().max.y); y += 7)
      for (double x = std::max(box.min.x, land.min.x); x <= std::min(box.max.x, land.box().max.x); x += 7) {
        EXPECT_EQ(height_m_at(window, {x, y}), height_m_at(land, {x, y}));
        EXPECT_EQ(normal_at(window, {x, y}), normal_at(land, {x, y}));
      }
  }
}

}  // namespace
}  // namespace citykiln::map
