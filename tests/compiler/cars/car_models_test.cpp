#include "compiler/cars/car_models.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace citykiln::cars {
namespace {

constexpr int kCars = 4000;

std::map<std::string, int> bodies_in(map::CountryGroup country, double length_m) {
  std::map<std::string, int> counts;
  for (std::uint64_t key = 0; key < kCars; ++key) {
    const things::Form form = form_of_car({.key = StableId{key}, .length_m = length_m, .country = country}, 1);
    EXPECT_LE(form.depth_m, length_m);
    ++counts[form.value];
  }
  return counts;
}

TEST(CarModels, HaveTenBodiesThatPark) {
  EXPECT_EQ(bodies_in(map::CountryGroup::kCentralEurope, 5.75).size(), 9u);
  EXPECT_EQ(bodies_in(map::CountryGroup::kJapan, 5.75).size(), 9u);
}

TEST(CarModels, FitIntoTheirPlaces) {
  EXPECT_EQ(bodies_in(map::CountryGroup::kNorthAmerica, 5).count("pickup"), 0u);
  EXPECT_EQ(bodies_in(map::CountryGroup::kNorthAmerica, kLeastPlace_m).size(), 2u);
}

TEST(CarModels, DifferByMarket) {
  EXPECT_GT(bodies_in(map::CountryGroup::kNorthAmerica, 5.75)["pickup"], kCars / 8);
  EXPECT_LT(bodies_in(map::CountryGroup::kCentralEurope, 5.75)["pickup"], kCars / 40);
  EXPECT_GT(bodies_in(map::CountryGroup::kJapan, 5.75)["kei"], kCars / 5);
  EXPECT_EQ(bodies_in(map::CountryGroup::kCentralEurope, 5.75).count("kei"), 0u);
}

TEST(CarModels, AreMostlyWhiteBlackAndGrey) {
  std::map<map::Srgb, int> counts;
  for (std::uint64_t key = 0; key < kCars; ++key)
    ++counts[*form_of_car({.key = StableId{key}, .length_m = 5.75}, 1).colour];
  EXPECT_EQ(counts.size(), 8u);
  EXPECT_NEAR((counts[{0xe6, 0xe7, 0xe5}]) / double{kCars}, 0.31, 0.03);
  EXPECT_NEAR((counts[{0x8c, 0x1d, 0x22}]) / double{kCars}, 0.06, 0.02);
}

}  // namespace
}  // namespace citykiln::cars
