#include "compiler/plants/placing/blue_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace citykiln::plants {
namespace {

constexpr double kPi = 3.14159265358979;

// A slope that is not aligned with the lattice.
struct Slope {
  double degrees = 0;
  double normal_z() const { return std::cos(degrees * kPi / 180); }
  double height_m(Vec2 p) const { return std::tan(degrees * kPi / 180) * (0.6 * p.x + 0.8 * p.y); }
};

std::vector<Sample> samples_on(const Slope& slope, double trees_per_ha, const Box2& box, std::uint64_t seed = 7) {
  const SampleDensity wanted = density_for(trees_per_ha);
  return blue_noise(
      seed, box, [&](const Box2&) { return wanted.spacing_m; },
      [&](Vec2 p) {
        SampleDensity density = wanted;
        density.height_m = slope.height_m(p), density.normal_z = slope.normal_z();
        return density;
      });
}

TEST(BlueNoise, IsAsDenseAsAskedOnEverySlope) {
  const Box2 box = {{0, 0}, {1536, 1536}};
  for (const double trees_per_ha : {60.0, 100.0, 150.0, 220.0, 300.0})
    for (const double degrees : {0.0, 10.0, 20.0, 30.0, 40.0, 45.0}) {
      const Slope slope{degrees};
      const double hectares = box.width() * box.height() / 1e4 / slope.normal_z();
      const double found = static_cast<double>(samples_on(slope, trees_per_ha, box).size()) / hectares;
      EXPECT_NEAR(found / trees_per_ha, 1, 0.03) << trees_per_ha << " a hectare on " << degrees << " degrees";
    }
}

// Coordinates on the slope itself.
Vec2 on_ground(const Slope& slope, Vec2 p) {
  const double down = 0.6 * p.x + 0.8 * p.y, across = -0.8 * p.x + 0.6 * p.y;
  return {down / slope.normal_z(), across};
}

// Nearest-neighbour distances in units of 1 / sqrt(density); spread: standard deviation / mean.
struct Nearest {
  double least = 1e9, mean = 0, spread = 0;
};

// Statistics of the points in the inner box.
Nearest nearest_of(const std::vector<Vec2>& points, double per_m2, const Box2& inner) {
  std::vector<Vec2> sorted = points;
  std::ranges::sort(sorted, {}, [](Vec2 p) { return p.x; });
  std::vector<double> nearest;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (!inner.contains(sorted[i])) continue;
    double best = 1e9;
    const auto appearance = [&](std::size_t j) { best = std::min(best, distance(sorted[i], sorted[j])); };
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x - sorted[i].x < best; ++j) appearance(j);
    for (std::size_t j = i; j-- > 0 && sorted[i].x - sorted[j].x < best;) appearance(j);
    nearest.push_back(best * std::sqrt(per_m2));
  }
  Nearest stats;
  double squares = 0;
  for (const double d : nearest) stats.least = std::min(stats.least, d), stats.mean += d, squares += d * d;
  const auto n = static_cast<double>(nearest.size());
  stats.mean /= n;
  stats.spread = std::sqrt(squares / n - stats.mean * stats.mean) / stats.mean;
  return stats;
}

// Dart throwing: random points, rejected when too near to an earlier one, until `count` are accepted.
std::vector<Vec2> dart_throwing(double spacing_m, std::size_t count, double side_m) {
  std::mt19937_64 random(3);
  const auto cells = static_cast<int>(side_m / spacing_m);
  const double cell_m = side_m / cells;
  std::vector<std::vector<Vec2>> grid(static_cast<std::size_t>(cells) * cells);
  std::vector<Vec2> darts;
  for (std::size_t throws = 0; darts.size() < count && throws < 100 * count; ++throws) {
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const Vec2 p = {unit() * side_m, unit() * side_m};
    const int c = std::min(cells - 1, static_cast<int>(p.x / cell_m)),
              r = std::min(cells - 1, static_cast<int>(p.y / cell_m));
    bool is_free = true;
    for (int y = std::max(0, r - 1); y <= std::min(cells - 1, r + 1); ++y)
      for (int x = std::max(0, c - 1); x <= std::min(cells - 1, c + 1); ++x)
        for (const Vec2 q : grid[static_cast<std::size_t>(y) * cells + x]) is_free &= distance(p, q) >= spacing_m;
    if (!is_free) continue;
    grid[static_cast<std::size_t>(r) * cells + c].push_back(p);
    darts.push_back(p);
  }
  return darts;
}

// Radially averaged power spectrum at a wavelength (Ulichney); 1 for white noise.
double power_at(const std::vector<Vec2>& points, double wave_m) {
  double power = 0;
  constexpr int kWays = 64;
  for (int way = 0; way < kWays; ++way) {
    const double turn = kPi * (way + 0.37) / kWays, x = std::cos(turn) / wave_m, y = std::sin(turn) / wave_m;
    double re = 0, im = 0;
    for (const Vec2 p : points)
      re += std::cos(2 * kPi * (p.x * x + p.y * y)), im += std::sin(2 * kPi * (p.x * x + p.y * y));
    power += (re * re + im * im) / static_cast<double>(points.size());
  }
  return power / kWays;
}

std::vector<Vec2> places_of(const std::vector<Sample>& samples, const Slope& slope) {
  std::vector<Vec2> places;
  for (const Sample& site : samples) places.push_back(on_ground(slope, site.at));
  return places;
}

TEST(BlueNoise, IsAsEvenAsDartThrowing) {
  const double side_m = 512, trees_per_ha = 150, spacing_m = density_for(trees_per_ha).spacing_m;
  const Box2 box = {{0, 0}, {side_m, side_m}};
  const std::vector<Vec2> ours = places_of(samples_on({}, trees_per_ha, box), {});
  const std::vector<Vec2> darts = dart_throwing(spacing_m, ours.size(), side_m);
  ASSERT_EQ(darts.size(), ours.size());
  const double per_m2 = static_cast<double>(ours.size()) / (side_m * side_m);
  const Nearest a = nearest_of(ours, per_m2, box.widened(-16)), b = nearest_of(darts, per_m2, box.widened(-16));
  EXPECT_GE(a.least, spacing_m * std::sqrt(per_m2) - 0.001);
  EXPECT_NEAR(a.mean / b.mean, 1, 0.03);
  EXPECT_NEAR(a.spread / b.spread, 1, 0.1);
  // low frequencies are as weak as the darts', and the lattice leaves no peaks
  for (const double wave_m : {60.0, 35.0, 21.0, 16.0, 9.0, 7.0})
    EXPECT_NEAR(power_at(ours, wave_m), power_at(darts, wave_m), 0.25) << wave_m;
  EXPECT_LT(power_at(ours, 4 * spacing_m), 0.35);
}

TEST(BlueNoise, KeepsItsSpacingOnTheGround) {
  const Box2 box = {{0, 0}, {512, 512}};
  const double trees_per_ha = 150, spacing_m = density_for(trees_per_ha).spacing_m;
  const Slope flat{0}, steep{45};
  const auto across = [&](const Slope& slope) {
    const std::vector<Vec2> places = places_of(samples_on(slope, trees_per_ha, box), slope);
    double least_m = 1e9;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = i + 1; j < places.size(); ++j) least_m = std::min(least_m, distance(places[i], places[j]));
    return least_m;
  };
  EXPECT_GE(across(flat), spacing_m - 0.01);
  EXPECT_GE(across(steep), spacing_m - 0.01);
  EXPECT_LT(across(steep), spacing_m * 1.02);
}

TEST(BlueNoise, IsTheSameInAnyBox) {
  const Slope slope{25};
  const Box2 box = {{0, 0}, {256, 256}};
  const std::vector<Sample> whole = samples_on(slope, 150, box);
  ASSERT_FALSE(whole.empty());
  const auto key = [](const Sample& s) { return s.at; };
  for (const double cut : {32.0, 101.5, 128.0}) {
    std::vector<Sample> parts = samples_on(slope, 150, {{0, 0}, {cut, 256}});
    const std::vector<Sample> east = samples_on(slope, 150, {{cut, 0}, {256, 256}});
    parts.insert(parts.end(), east.begin(), east.end());
    std::vector<Sample> all = whole;
    std::ranges::sort(parts, {}, key), std::ranges::sort(all, {}, key);
    ASSERT_EQ(parts.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(parts[i].at == all[i].at && parts[i].id == all[i].id);
  }
}

TEST(BlueNoise, AsksForDensitiesWithinItsInfluenceRadius) {
  const Box2 box = {{0, 0}, {128, 128}};
  const SampleDensity wide = density_for(60), narrow = density_for(300);
  bool is_asked_beyond = false;
  const std::vector<Sample> samples = blue_noise(
      7, box, [&](const Box2&) { return narrow.spacing_m; },
      [&](Vec2 p) {
        is_asked_beyond |= !box.widened(kSampleInfluence_m).contains(p);
        return p.x < 40 ? wide : narrow;
      });
  EXPECT_FALSE(is_asked_beyond);
  EXPECT_GT(samples.size(), 100u);
}

TEST(BlueNoise, DiffersBySeed) {
  const Box2 box = {{0, 0}, {128, 128}};
  const auto first = samples_on({}, 150, box, 1), second = samples_on({}, 150, box, 2);
  ASSERT_FALSE(first.empty());
  EXPECT_NE(first.front().at, second.front().at);
}

}  // namespace
}  // namespace citykiln::plants
