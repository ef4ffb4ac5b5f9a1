#include "compiler/source/voids/codes_to_voids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace citykiln::source {
namespace {

constexpr int kCodesSide = 60;

Raster raster_of(const std::function<double(int, int)>& height_m) {
  Raster raster;
  raster.columns = raster.rows = kCodesSide;
  raster.file_spacing_m = 5;
  raster.file_name = "heights.tif";
  raster.from_grid = {10, 0.001, 0, 50, 0, -0.001};
  for (int row = 0; row < kCodesSide; ++row)
    for (int column = 0; column < kCodesSide; ++column)
      raster.heights_m.push_back(static_cast<float>(height_m(column, row)));
  return raster;
}

double land_m(int column, int row) { return 180 + 2 * std::sin(column * 0.3) + 0.5 * row; }

bool is_inside(int column, int row) { return column > 20 && column < 40 && row > 25 && row < 45; }

struct CountedVoids {
  int voids = 0, wrong = 0;  // wrong: samples of the hole that are left, or of the land that are gone
  std::size_t findings = 0;
};

CountedVoids counted(const Raster& raster, const std::function<bool(int, int)>& is_hole) {
  Report report;
  const Raster mended = codes_to_voids(raster, report);
  CountedVoids counts;
  for (int row = 0; row < kCodesSide; ++row)
    for (int column = 0; column < kCodesSide; ++column) {
      const bool is_void = std::isnan(mended.at(column, row));
      counts.voids += is_void;
      counts.wrong += is_void != is_hole(column, row);
    }
  counts.findings = report.diagnoses().size();
  return counts;
}

TEST(CodesToVoids, ValuesFarFromTheLandAroundAreVoids) {
  for (const double value : {-9999.0, -32767.0, 0.0, -500.0, 65535.0, 99999.0, 1e8, -77.0, 12345.0, 8999.0}) {
    const Raster raster = raster_of([&](int c, int r) { return is_inside(c, r) ? value : land_m(c, r); });
    const CountedVoids counts = counted(raster, is_inside);
    EXPECT_EQ(counts.wrong, 0) << value;
    EXPECT_EQ(counts.findings, 1u) << value;
  }
}

TEST(CodesToVoids, APlainBesideAPlateauIsLandWhereItIsMostOfTheHeightmap) {
  const Raster raster = raster_of([](int c, int) { return c < 25 ? 200.0 : 0.0; });
  EXPECT_EQ(counted(raster, [](int, int) { return false; }).wrong, 0);
}

TEST(CodesToVoids, ACollarIsVoid) {
  const auto is_collar = [](int c, int r) { return c + r < 35; };
  for (const double value : {-9999.0, 0.0, -500.0, 99999.0}) {
    const Raster raster = raster_of([&](int c, int r) { return is_collar(c, r) ? value : land_m(c, r); });
    EXPECT_EQ(counted(raster, is_collar).wrong, 0) << value;
  }
  const Raster nothing = raster_of([](int, int) { return -9999; });
  EXPECT_EQ(counted(nothing, [](int, int) { return true; }).wrong, 0);
}

TEST(CodesToVoids, TheEndsOfTheNumberTypeAreCodes) {
  Raster raster = raster_of([](int c, int r) { return is_inside(c, r) ? 3276.75 : land_m(c, r); });
  EXPECT_EQ(counted(raster, is_inside).voids, 0);
  raster.code_heights_m = {3276.75F};
  EXPECT_EQ(counted(raster, is_inside).wrong, 0);
}

TEST(CodesToVoids, SeaLakesAndPoldersStay) {
  const auto none = [](int, int) { return false; };
  // a beach, a cliff with a beach below, a cliff without, a fjord, a polder, a lake on its shore
  EXPECT_EQ(counted(raster_of([](int c, int) { return std::max(0, c - 30); }), none).voids, 0);
  EXPECT_EQ(counted(raster_of([](int c, int) { return c < 30 ? 0 : c < 33 ? 1.5 : 90; }), none).voids, 0);
  EXPECT_EQ(counted(raster_of([](int c, int r) { return c < 30 ? 0 : 40 + 0.8 * r; }), none).voids, 0);
  EXPECT_EQ(counted(raster_of([](int c, int) { return std::max(0, std::abs(c - 30) * 6 - 60); }), none).voids, 0);
  EXPECT_EQ(counted(raster_of([](int c, int r) { return is_inside(c, r) ? -4 : 2; }), none).voids, 0);
  EXPECT_EQ(counted(raster_of([](int c, int r) { return is_inside(c, r) ? 300 : land_m(c, r); }), none).voids, 0);
}

TEST(CodesToVoids, SamplesIntoWhichAValueIsMixedGoToo) {
  const auto mixed_m = [](int c, int r, double value) {
    const double share = (is_inside(c, r) + is_inside(c + 1, r) + is_inside(c, r + 1) + is_inside(c + 1, r + 1)) / 4.0;
    return share * value + (1 - share) * land_m(c, r);
  };
  for (const double value : {-9999.0, 0.0, 99999.0}) {
    Report report;
    const Raster mended = codes_to_voids(raster_of([&](int c, int r) { return mixed_m(c, r, value); }), report);
    for (int r = 0; r < kCodesSide; ++r)
      for (int c = 0; c < kCodesSide; ++c)
        if (!std::isnan(mended.at(c, r))) {
          EXPECT_NEAR(mended.at(c, r), land_m(c, r), 9) << value << " at " << c << "," << r;
        }
  }
}

TEST(HeightNotOnEarth, NamesTheFileAndThePlace) {
  EXPECT_FALSE(first_height_off_land(raster_of(land_m)));
  const auto error = first_height_off_land(raster_of([](int c, int r) { return 100 * land_m(c, r); }));
  ASSERT_TRUE(error);
  EXPECT_EQ(error->where, "heights.tif");
  EXPECT_NE(error->message.find("found 18000 m at 10.00000,50.00000"), std::string::npos) << error->message;
}

TEST(HeightNotOnEarth, ManyValuesBeyondItAreNoCode) {
  Report report;
  const Raster mended = codes_to_voids(raster_of([](int c, int r) { return 100 * land_m(c, r); }), report);
  EXPECT_TRUE(first_height_off_land(mended));
}

}  // namespace
}  // namespace citykiln::source
