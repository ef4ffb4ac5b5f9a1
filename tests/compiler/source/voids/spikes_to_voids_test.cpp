#include "compiler/source/voids/spikes_to_voids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"

namespace citykiln::source {
namespace {

constexpr int kSide = 129;

// 0 … 1, of a place and a seed.
double chance(int a, int b, int seed) {
  std::uint64_t x = static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15u +
                    static_cast<std::uint64_t>(b) * 0xC2B2AE3D27D4EB4Fu +
                    static_cast<std::uint64_t>(seed) * 0x165667B19E3779F9u;
  x ^= x >> 29, x *= 0xBF58476D1CE4E5B9u, x ^= x >> 32, x *= 0x94D049BB133111EBu, x ^= x >> 31;
  return static_cast<double>(x >> 11) * 0x1p-53;
}

Raster raster_of_spacing(int columns, int rows, double spacing_m, const std::function<double(int, int)>& height_m) {
  Raster raster;
  raster.columns = columns, raster.rows = rows, raster.file_spacing_m = spacing_m;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      raster.heights_m.push_back(static_cast<float>(height_m(column, row)));
  }
  return raster;
}

// Octaves of chance, each half as wide and `share` as high as the one before: mountains of whole metres, as SRTM has
// them.
Raster mountains(int seed, double spacing_m, double relief_m, double share) {
  return raster_of_spacing(kSide, kSide, spacing_m, [&](int column, int row) {
    double height_m = 0, octave_m = relief_m;
    for (int width = 64; width >= 1; width /= 2, octave_m *= share) {
      const int c = column / width, r = row / width;
      const double u = static_cast<double>(column % width) / width, v = static_cast<double>(row % width) / width;
      const auto at = [&](int i, int j) { return chance(c + i, r + j, seed * 100 + width); };
      height_m += octave_m * ((1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1)));
    }
    return std::round(height_m);
  });
}

struct Planted {
  Raster raster;
  std::vector<std::size_t> at;
};

// Spikes of one sample, two beside each other, two at a corner, three, and two by two, up and down.
Planted plant(const Raster& land, int seed, double size_m) {
  constexpr int kShapes[] = {0b0001, 0b0011, 0b0101, 0b1001, 0b0110, 0b1110, 0b1111};
  Planted planted{land, {}};
  for (int i = 0; i < 49; ++i) {
    const int column = 8 + i % 7 * 17 + static_cast<int>(5 * chance(i, 1, seed)),
              row = 8 + i / 7 * 17 + static_cast<int>(5 * chance(i, 2, seed));
    const double side = chance(i, 3, seed) < 0.5 ? -1 : 1;
    for (int k = 0; k < 4; ++k) {
      if ((kShapes[(i + seed) % 7] >> k & 1) == 0) continue;
      const std::size_t at = static_cast<std::size_t>(row + k / 2) * land.columns + column + k % 2;
      planted.raster.heights_m[at] += static_cast<float>(side * size_m * (1 + chance(i, 4 + k, seed)));
      planted.at.push_back(at);
    }
  }
  return planted;
}

std::vector<std::size_t> voids_of(const Raster& raster) {
  std::vector<std::size_t> voids;
  for (std::size_t i = 0; i < raster.heights_m.size(); ++i) {
    if (std::isnan(raster.heights_m[i])) voids.push_back(i);
  }
  return voids;
}

std::size_t spikes_in(const Raster& raster) {
  Report report;
  spikes_to_voids(raster, report);
  return report.diagnoses().size();
}

TEST(SpikesToVoids, MountainsWithoutSpikesStay) {
  for (int seed = 0; seed < 8; ++seed) {
    EXPECT_EQ(spikes_in(mountains(seed, 68, 1500, 0.5)), 0u) << seed;
    EXPECT_EQ(spikes_in(mountains(seed, 30, 1500, 0.45)), 0u) << seed;
    EXPECT_EQ(spikes_in(mountains(seed, 2, 200, 0.45)), 0u) << seed;
    EXPECT_EQ(spikes_in(mountains(seed, 30, 400, 0.7)), 0u) << seed;
  }
}

TEST(SpikesToVoids, RemovesExactlyThePlantedSpikes) {
  for (int seed = 0; seed < 8; ++seed) {
    Planted planted = plant(mountains(seed, 68, 1500, 0.5), seed, 400);
    std::ranges::sort(planted.at);
    Report report;
    EXPECT_EQ(voids_of(spikes_to_voids(planted.raster, report)), planted.at) << seed;
  }
}

TEST(SpikesToVoids, MountainsAreRestored) {
  for (int seed = 0; seed < 8; ++seed) {
    const Raster land = mountains(seed, 68, 1500, 0.5);
    Report report;
    const Raster mended = fill_voids(spikes_to_voids(plant(land, seed, 400).raster, report), report);
    double largest_m = 0;
    for (std::size_t i = 0; i < land.heights_m.size(); ++i) {
      largest_m = std::max<double>(largest_m, std::abs(mended.heights_m[i] - land.heights_m[i]));
    }
    // what the smallest octaves, of 94 and 47 and 23 m, add to the mean of the neighbours
    EXPECT_LT(largest_m, 130) << seed;
  }
}

TEST(SpikesToVoids, ASecondRunFindsNothing) {
  for (int seed = 0; seed < 8; ++seed) {
    Report report;
    const Raster once = spikes_to_voids(plant(mountains(seed, 68, 1500, 0.5), seed, 400).raster, report);
    EXPECT_FALSE(report.diagnoses().empty()) << seed;
    EXPECT_EQ(spikes_in(once), 0u) << seed;
  }
}

TEST(SpikesToVoids, AWindowEqualsThatPartOfTheWhole) {
  const Raster whole = plant(mountains(3, 68, 1500, 0.5), 3, 300).raster;
  Report report;
  const Raster mended = spikes_to_voids(whole, report);
  EXPECT_FALSE(voids_of(mended).empty());
  for (int first = 1; first < 40; first += 3) {
    const int size = kSide - 40;
    const Raster window = spikes_to_voids(
        raster_of_spacing(size, size, 68, [&](int c, int r) { return whole.at(c + first, r + first); }), report);
    for (int r = kSpikeInfluence; r < size - kSpikeInfluence; ++r) {
      for (int c = kSpikeInfluence; c < size - kSpikeInfluence; ++c) {
        EXPECT_EQ(std::isnan(window.at(c, r)), std::isnan(mended.at(c + first, r + first)))
            << first << " " << c << " " << r;
      }
    }
  }
}

// Terrain that rises or falls steeply is no spike if its neighbours rise or fall too.
TEST(SpikesToVoids, SummitsRidgesCliffsAndShoresStay) {
  const auto cone = [](int c, int r) { return 3000 - 90 * std::hypot(c - 20, r - 20); };
  const auto ridge = [](int c, int r) { return 2000 - 150.0 * std::abs(c - r) + 3 * r; };
  const auto ridge_that_ends = [](int c, int r) { return r > 20 ? 500.0 : 2000 - 150.0 * std::abs(c - 20); };
  const auto cliff = [](int c, int r) { return c + r / 3 > 25 ? 0.0 : 400.0 + c; };
  const auto gorge = [](int c, int r) { return c + r == 40 ? 300.0 : 500.0; };
  const auto sea_stack = [](int c, int r) { return std::abs(c - 20) <= 1 && std::abs(r - 20) <= 1 ? 120.0 : 0.0; };
  const auto wall = [](int c, int) { return c == 20 ? 90.0 : 20.0; };
  for (const auto& land :
       std::vector<std::function<double(int, int)>>{cone, ridge, ridge_that_ends, cliff, gorge, sea_stack, wall}) {
    EXPECT_EQ(spikes_in(raster_of_spacing(41, 41, 30, land)), 0u);
  }
}

TEST(SpikesToVoids, ASmallRockInTheSeaStays) {
  EXPECT_EQ(spikes_in(raster_of_spacing(9, 9, 30, [](int c, int r) { return c == 4 && r == 4 ? 26.0 : 0.0; })), 0u);
  EXPECT_EQ(spikes_in(raster_of_spacing(9, 9, 30, [](int c, int r) { return c == 4 && r == 4 ? 28.0 : 0.0; })), 1u);
}

TEST(SpikesToVoids, DiagnosesEachSpikeWithItsSize) {
  Report report;
  spikes_to_voids(raster_of_spacing(9, 9, 30, [](int c, int r) { return 10.0 * c + (c == 4 && r == 4 ? -700 : 0); }),
                  report);
  ASSERT_EQ(report.diagnoses().size(), 1u);
  EXPECT_EQ(report.diagnoses()[0].code, Code::kHeightSpike);
  EXPECT_NEAR(report.diagnoses()[0].size, 700, 1e-9);
}

TEST(SpikesToVoids, KeepsSamplesAmongVoids) {
  const auto lone = [](int c, int r) { return c == 4 && r == 4 ? 900.0 : r > 4 ? 0.0 : double{kVoid}; };
  EXPECT_EQ(spikes_in(raster_of_spacing(9, 9, 30, lone)), 0u);
}

TEST(SpikesToVoids, AcceptsRastersWithoutSamples) {
  EXPECT_EQ(spikes_in(Raster{}), 0u);
  EXPECT_EQ(spikes_in(raster_of_spacing(1, 1, 30, [](int, int) { return 1.0; })), 0u);
  EXPECT_EQ(spikes_in(raster_of_spacing(3, 1, 30, [](int c, int) { return c == 1 ? 1e6 : 0.0; })), 0u);
}

}  // namespace
}  // namespace citykiln::source
