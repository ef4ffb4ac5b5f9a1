#include "compiler/map/heights/resample.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "compiler/source/read_raster.h"
#include "tests/compiler/map/map_text.h"
#include "tests/scratch_folder.h"

namespace citykiln::map {
namespace {

using source::Raster;

const Box2 kRegion{{-256, -128}, {384, 256}};
constexpr double kThirdOfASecond = 1.0 / 10800;  // degrees: 7.4 m by 10.3 m at the test's origin

// A raster in degrees around the origin, its samples given by their place.
template <typename Height>
Raster raster_of(Height height_m, int columns = 161, int rows = 121, double spacing_deg = kThirdOfASecond,
                 LonLat centre = kTestOrigin) {
  const double west = centre.lon_deg - spacing_deg * (columns / 2), north = centre.lat_deg + spacing_deg * (rows / 2);
  Raster raster{"hills.hgt", "",
                columns,     rows,
                {},          {west, spacing_deg, 0, north, 0, -spacing_deg},
                "",          {spacing_deg * 111000 * 0.72, spacing_deg * 111000}};
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      raster.heights_m.push_back(static_cast<float>(height_m(west + spacing_deg * c, north - spacing_deg * r)));
  return raster;
}

Heightfield field_of(const std::vector<Raster>& rasters, Report& report, const Box2& extent = kRegion) {
  Result<Heightfield> field = resample(rasters, Plane(kTestOrigin), extent, report);
  EXPECT_TRUE(field) << to_string(field.error());
  return field ? std::move(*field) : Heightfield{{0, 0}, {1, 1}, 2, 2, {0, 0, 0, 0}, 0};
}

double slope_m(double lon_deg, double lat_deg) {
  return 700 + (lon_deg - kTestOrigin.lon_deg) * 9000 - (lat_deg - kTestOrigin.lat_deg) * 14000;
}

TEST(Resample, WithoutRastersTheFieldIsFlat) {
  Report report;
  const Heightfield field = field_of({}, report);
  for (const std::int32_t height : field.heights) EXPECT_EQ(height, 0);
  EXPECT_TRUE(report.diagnoses().empty());
}

TEST(Resample, VerticesLieOnThePlanesGridAndReachBeyondTheRegion) {
  Report report;
  for (const Heightfield& field : {field_of({}, report), field_of({raster_of(slope_m)}, report)}) {
    EXPECT_LE(field.box().min.x, kRegion.min.x - field.step_m.x);
    EXPECT_LE(field.box().min.y, kRegion.min.y - field.step_m.y);
    EXPECT_GE(field.box().max.x, kRegion.max.x + field.step_m.x);
    EXPECT_GE(field.box().max.y, kRegion.max.y + field.step_m.y);
    EXPECT_EQ(std::fmod(field.min.x, kStepUnit_m), 0);
    EXPECT_EQ(std::fmod(field.min.y, kStepUnit_m), 0);
    EXPECT_EQ(field.heights.size(), static_cast<std::size_t>(field.columns) * field.rows);
  }
}

TEST(Resample, StepsAreTheLargestOfTheirSetNotAboveTheFinestSpacing) {
  const struct {
    double spacing_m, step_m;
  } cases[] = {{0.3, 1}, {1, 1}, {1.9, 1.875}, {2, 2}, {5.3, 5.25}, {30.9, 30.875}, {92.57, 92.5}, {900, 128}};
  for (const auto& c : cases) {
    Raster raster = raster_of(slope_m);
    raster.spacing_m = {c.spacing_m, 20};
    Report report;
    EXPECT_EQ(field_of({raster}, report, {{0, 0}, {128, 128}}).sample_step_m(), (Vec2{c.step_m, 20})) << c.spacing_m;
    raster.spacing_m = {20, c.spacing_m};
    EXPECT_EQ(field_of({raster}, report, {{0, 0}, {128, 128}}).sample_step_m(), (Vec2{20, c.step_m})) << c.spacing_m;
  }
}

TEST(Resample, InTheMiddleVerticesLieOnSamples) {
  for (const double centre_lon : {kTestOrigin.lon_deg, kTestOrigin.lon_deg + kThirdOfASecond * 0.37}) {
    const Raster raster = raster_of(slope_m, 161, 121, kThirdOfASecond, {centre_lon, kTestOrigin.lat_deg + 1e-5});
    Report report;
    const Heightfield field = field_of({raster}, report);
    const Plane plane(kTestOrigin);
    double nearest_m = 1e9;
    for (int r = 0; r < raster.rows; ++r)
      for (int c = 0; c < raster.columns; ++c) {
        const auto& g = raster.from_grid;
        const Vec2 sample = plane.forward({g[0] + g[1] * c, g[3] + g[5] * r});
        if (distance(sample, kRegion.centre()) > 7) continue;
        nearest_m = std::min(nearest_m, distance(sample, nearest_vertex(field, sample)));
      }
    EXPECT_LE(nearest_m, kStepUnit_m);
  }
}

TEST(Resample, OfSeveralRastersTheFinestSpacingEachWayCounts) {
  Raster one = raster_of(slope_m), other = one;
  one.spacing_m = {30, 92}, other.spacing_m = {68, 40};
  Report report;
  EXPECT_EQ(field_of({one, other}, report).sample_step_m(), (Vec2{30, 40}));
}

TEST(Resample, ASlopeStaysASlopeWithinHalfAQuantum) {
  Report report;
  const Heightfield field = field_of({raster_of(slope_m)}, report);
  const Plane plane(kTestOrigin);
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i) {
      const LonLat place = plane.backward(field.vertex(i, j));
      // floats hold 700 m to 3e-5 m
      EXPECT_NEAR(field.height_m_at_vertex(i, j), slope_m(place.lon_deg, place.lat_deg), kHeightQuantum_m / 2 + 1e-4);
    }
  EXPECT_TRUE(report.diagnoses().empty());
}

TEST(Resample, TheStatedErrorHoldsAtEverySample) {
  const auto bumps_m = [](double lon_deg, double lat_deg) {
    return 300 + 40 * std::sin(lon_deg * 9000) * std::cos(lat_deg * 7000);
  };
  const Raster raster = raster_of(bumps_m);
  Report report;
  const Heightfield field = field_of({raster}, report);
  const Plane plane(kTestOrigin);
  double largest = 0;
  for (int r = 0; r < raster.rows; ++r)
    for (int c = 0; c < raster.columns; ++c) {
      const Vec2 p =
          plane.forward({raster.from_grid[0] + raster.from_grid[1] * c, raster.from_grid[3] + raster.from_grid[5] * r});
      if (field.box().contains(p)) largest = std::max(largest, std::abs(height_m_at(field, p) - raster.at(c, r)));
    }
  EXPECT_GT(largest, 0.1);
  EXPECT_GE(field.resampling_error_m, largest);
  EXPECT_LE(field.resampling_error_m, largest + kHeightQuantum_m);
}

TEST(Resample, WhereTwoRastersCoverAPlaceTheFirstWins) {
  const auto at_100_m = [](double, double) { return 100.0; };
  const auto at_200_m = [](double, double) { return 200.0; };
  Report report;
  const std::vector<Raster> rasters = {raster_of(at_100_m, 21, 21), raster_of(at_200_m)};
  const Heightfield field = field_of(rasters, report);
  EXPECT_EQ(height_m_at(field, {0, 0}), 100);
  EXPECT_EQ(height_m_at(field, {300, 200}), 200);
  EXPECT_TRUE(report.diagnoses().empty());
}

TEST(Resample, PlacesThatNothingCoversTakeTheNearestHeightAndAreDiagnosed) {
  Report report;
  const Heightfield field = field_of({raster_of(slope_m, 21, 21)}, report);
  ASSERT_EQ(report.diagnoses().size(), 1u);
  EXPECT_EQ(report.diagnoses()[0].code, Code::kNoHeight);
  EXPECT_GT(report.diagnoses()[0].size, 0.5);
  EXPECT_LT(report.diagnoses()[0].size, 1);
  for (const std::int32_t height : field.heights) EXPECT_NEAR(height * kHeightQuantum_m, 700, 40);
}

TEST(Resample, ADemElsewhereIsAnErrorThatNamesTheFile) {
  Raster elsewhere = raster_of(slope_m, 50, 50, kThirdOfASecond, {13.4, 52.5});
  elsewhere.file_box = {13.375, 52.25, 13.625, 52.75};
  const Result<Heightfield> field =
      resample(std::vector{elsewhere}, Plane(kTestOrigin), kRegion, *std::make_unique<Report>());
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().where, "hills.hgt");
  EXPECT_NE(field.error().message.find("7.42"), std::string::npos) << field.error().message;
  EXPECT_NE(field.error().message.find("13.3750,52.2500,13.6250,52.7500"), std::string::npos) << field.error().message;
}

TEST(Resample, ARasterThatComesNotNearAndHasNoSamplesIsNoCrash) {
  // what read_raster gives for a heightmap beyond the window
  const Raster empty{"far.hgt", "", 0, 0, {}, {13, 0.001, 0, 52, 0, -0.001}, "", {0, 0}};
  Report report;
  EXPECT_FALSE(resample(std::vector{empty}, Plane(kTestOrigin), kRegion, report));
  const Heightfield field = field_of({empty, raster_of(slope_m)}, report);
  EXPECT_NEAR(height_m_at(field, {0, 0}), 700, 0.1);
  EXPECT_EQ(field.step_m, field_of({raster_of(slope_m)}, report).step_m);
}

// An ASCII grid of 40 by 40 samples, 0.0005 degrees apart, at one height.
std::string level_grid(double west_deg, double south_deg, int height_m) {
  std::string text =
      fmt::format("ncols 40\nnrows 40\nxllcorner {}\nyllcorner {}\ncellsize 0.0005\n", west_deg, south_deg);
  for (int i = 0; i < 40 * 40; ++i) text += fmt::format("{}{}", height_m, i % 40 < 39 ? ' ' : '\n');
  return text;
}

TEST(Resample, AFileFarAwayDoesNotChangeTheSteps) {
  const ScratchFolder folder;
  const std::vector<source::RasterSpec> specs = {{.path = folder.write("near.asc", level_grid(7.41, 43.72, 700))},
                                                 {.path = folder.write("far.asc", level_grid(13.4, 52.5, 30))}};
  const source::LonLatBox window{7.415, 43.725, 7.425, 43.735};
  Report report;
  const auto both = source::read_heightmaps(specs, &window, report),
             one = source::read_heightmaps(std::span(specs).first(1), &window, report);
  ASSERT_TRUE(both && one);
  const Heightfield field = field_of(*both, report), alone = field_of(*one, report);
  EXPECT_GT(alone.sample_step_m().x, 35);
  EXPECT_EQ(field.step_m, alone.step_m);
  EXPECT_EQ(field.heights, alone.heights);
}

TEST(Resample, SingleRowsAndColumnsAreEnough) {
  Report report;
  EXPECT_NEAR(height_m_at(field_of({raster_of(slope_m, 1, 1)}, report), {0, 0}), 700, 1);
  EXPECT_NEAR(height_m_at(field_of({raster_of(slope_m, 9, 1)}, report), {0, 0}), 700, 1);
}

TEST(Resample, VoidsThatWereLeftCountAsUncovered) {
  Raster raster = raster_of(slope_m);
  for (std::size_t i = 0; i < raster.heights_m.size(); i += 7)
    raster.heights_m[i] = std::numeric_limits<float>::quiet_NaN();
  Report report;
  const Heightfield field = field_of({raster}, report);
  EXPECT_EQ(report.counts()[Code::kNoHeight], 1u);
  for (const std::int32_t height : field.heights) EXPECT_NEAR(height * kHeightQuantum_m, 700, 120);
}

TEST(Resample, OnlyHeightsBeyondAThousandKilometresAreLeftOut) {
  for (const double height : {-11000.0, 9000.0, 1e6, 1e7, -1e30, 1e30, 1.0 / 0.0}) {
    Report report;
    const Result<Heightfield> field =
        resample(std::vector{raster_of([&](double, double) { return height; })}, Plane(kTestOrigin), kRegion, report);
    ASSERT_EQ(static_cast<bool>(field), std::abs(height) < 0x1p20) << height;
    if (field) {
      EXPECT_EQ(height_m_at(*field, {0, 0}), height);
    }
  }
}

}  // namespace
}  // namespace citykiln::map
