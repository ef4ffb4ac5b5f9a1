#include "compiler/climate/climate_at.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <string>

#include "tests/test_files.h"

namespace citykiln::climate {
namespace {

struct City {
  const char* name;
  double lon_deg, lat_deg;
  const char* climate;
};

// Classes as published for the cities by Kottek et al. 2006 and Peel et al. 2007.
constexpr City kCities[] = {{"Singapore", 103.82, 1.35, "Af"},
                            {"Kuala Lumpur", 101.69, 3.14, "Af"},
                            {"Miami", -80.2, 25.8, "Am"},
                            {"Lagos", 3.39, 6.52, "Aw"},
                            {"Mumbai", 72.87, 19.08, "Aw"},
                            {"Bangkok", 100.5, 13.75, "Aw"},
                            {"Darwin", 130.84, -12.46, "Aw"},
                            {"Brasilia", -47.9, -15.8, "Aw"},
                            {"Honolulu", -157.86, 21.3, "As"},
                            {"Cairo", 31.24, 30.04, "BWh"},
                            {"Riyadh", 46.7, 24.7, "BWh"},
                            {"Phoenix", -112.07, 33.45, "BWh"},
                            {"Nouakchott", -15.97, 18.08, "BWh"},
                            {"Las Vegas", -115.1, 36.2, "BWk"},
                            {"Denver", -104.99, 39.74, "BSk"},
                            {"Ulaanbaatar", 106.9, 47.9, "BSk"},
                            {"Rome", 12.5, 41.9, "Csa"},
                            {"Athens", 23.73, 37.98, "Csa"},
                            {"Perth", 115.86, -31.95, "Csa"},
                            {"San Francisco", -122.42, 37.77, "Csb"},
                            {"Porto", -8.61, 41.15, "Csb"},
                            {"Cape Town", 18.42, -33.93, "Csb"},
                            {"London", -0.13, 51.5, "Cfb"},
                            {"Paris", 2.35, 48.86, "Cfb"},
                            {"Berlin", 13.4, 52.52, "Cfb"},
                            {"Melbourne", 144.96, -37.81, "Cfb"},
                            {"Kyoto", 135.77, 35.0, "Cfa"},
                            {"Tokyo", 139.7, 35.68, "Cfa"},
                            {"Buenos Aires", -58.38, -34.6, "Cfa"},
                            {"Shanghai", 121.47, 31.23, "Cfa"},
                            {"Hong Kong", 114.17, 22.3, "Cwa"},
                            {"Delhi", 77.2, 28.6, "Cwa"},
                            {"Mexico City", -99.13, 19.43, "Cwb"},
                            {"Johannesburg", 28.04, -26.2, "Cwb"},
                            {"Reykjavik", -21.9, 64.1, "Cfc"},
                            {"Chicago", -87.63, 41.88, "Dfa"},
                            {"Boston", -71.08, 42.35, "Dfa"},
                            {"Seoul", 126.98, 37.57, "Dwa"},
                            {"Beijing", 116.4, 39.9, "Dwa"},
                            {"Vladivostok", 131.9, 43.1, "Dwb"},
                            {"Helsinki", 24.94, 60.17, "Dfb"},
                            {"Moscow", 37.62, 55.75, "Dfb"},
                            {"Montreal", -73.57, 45.5, "Dfb"},
                            {"Tromsø", 18.96, 69.65, "Dfc"},
                            {"Fairbanks", -147.7, 64.84, "Dfc"},
                            {"Yakutsk", 129.73, 62.03, "Dfd"},
                            {"Nuuk", -51.7, 64.2, "ET"},
                            {"Vostok", 106.8, -78.5, "EF"}};

double sum_of(const ClimateMix& mix) {
  return mix.mean([](ClimateClass) { return 1.0; });
}

// How much of the shares differs, from 0 to 1.
double difference(const ClimateMix& a, const ClimateMix& b) {
  double sum = 0;
  for (std::size_t c = 0; c < kClimateClasses; ++c) {
    const auto is_it = [&](ClimateClass each) { return static_cast<std::size_t>(each) == c ? 1.0 : 0.0; };
    sum += std::abs(a.mean(is_it) - b.mean(is_it)) / 2;
  }
  return sum;
}

TEST(ClimateAt, IsThePublishedClassOfCities) {
  for (const City& city : kCities)
    EXPECT_EQ(name_of(climate_at(city.lon_deg, city.lat_deg)), city.climate) << city.name;
}

TEST(ClimateAt, IsThatOfTheNearestLandAtSea) {
  // 20 km off Porto; Santa Barbara Island, which is less than half a cell; Bermuda; the Pacific, far from any land
  EXPECT_EQ(climate_at(-9.2, 41.15), ClimateClass::kCsb);
  EXPECT_EQ(name_of(climate_at(-119.03, 33.47))[0], 'C');
  EXPECT_LT(climate_at(-64.75, 32.3), ClimateClass::kCount);
  EXPECT_LT(climate_at(-123.4, -48.9), ClimateClass::kCount);
  // off Fiji the nearest land lies across the line of 180°
  EXPECT_EQ(climate_at(179.99, -16.6), climate_at(-179.99, -16.6));
}

TEST(ClimateAt, TakesAnyLongitudeAndLatitude) {
  EXPECT_EQ(climate_at(103.82 - 360, 1.35), ClimateClass::kAf);
  EXPECT_EQ(climate_at(103.82 + 720, 1.35), ClimateClass::kAf);
  for (const double lat_deg : {90.0, -90.0, 89.99, -89.99})
    for (const double lon_deg : {-180.0, 180.0, 0.0}) EXPECT_EQ(name_of(climate_at(lon_deg, lat_deg))[0], 'E');
}

TEST(ClimateMixAt, HasSharesThatAddUpToOneEverywhere) {
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    const double lon_deg = random() / 4294967296.0 * 360 - 180, lat_deg = random() / 4294967296.0 * 180 - 90;
    const ClimateMix mix = climate_mix_at(lon_deg, lat_deg);
    EXPECT_NEAR(sum_of(mix), 1, 1e-12);
    for (const ClimateShare& each : mix.shares()) EXPECT_GT(each.share, 0);
  }
}

// From Munich over the Alps to Rome, and from Lagos to the Sahara; coasts are not crossed.
TEST(ClimateMixAt, ChangesGraduallyOverEdges) {
  const auto largest_step = [](double lon_deg, double from_deg, double to_deg) {
    double largest = 0;
    for (double lat_deg = from_deg; lat_deg < to_deg; lat_deg += 0.01)
      largest =
          std::max(largest, difference(climate_mix_at(lon_deg, lat_deg), climate_mix_at(lon_deg, lat_deg + 0.01)));
    return largest;
  };
  EXPECT_LE(largest_step(11.6, 44.8, 48), 0.0201);
  EXPECT_LE(largest_step(3.39, 7.5, 20), 0.0201);
}

TEST(ClimateMixAt, IsTheClassAtTheCentreOfAHalfDegree) {
  for (const City& city : kCities) {
    const double lon_deg = std::floor(city.lon_deg * 2) / 2 + 0.25, lat_deg = std::floor(city.lat_deg * 2) / 2 + 0.25;
    const ClimateMix mix = climate_mix_at(lon_deg, lat_deg);
    ASSERT_EQ(mix.shares().size(), 1u) << city.name;
    EXPECT_EQ(name_of(mix.shares()[0].climate), city.climate) << city.name;
  }
}

// Every half degree of the source, land and sea.
TEST(ClimateAtReal, HasEveryCellOfItsSource) {
  const std::filesystem::path path = real_data("climate/koeppen-half-degree.txt");
  std::ifstream file(path);
  if (!file) GTEST_SKIP() << path << " is absent";
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcd";
  std::string line;
  int row = 0, land = 0;
  while (std::getline(file, line)) {
    if (line.starts_with('#')) continue;
    for (int column = 0; column < 720; ++column)
      if (line[static_cast<std::size_t>(column)] != '.') {
        ++land;
        ASSERT_EQ(static_cast<std::size_t>(climate_at(column / 2.0 - 179.75, 89.75 - row / 2.0)),
                  letters.find(line[static_cast<std::size_t>(column)]))
            << row << ' ' << column;
      }
    ++row;
  }
  EXPECT_EQ(row, 360);
  EXPECT_GT(land, 90000);
}

}  // namespace
}  // namespace citykiln::climate
