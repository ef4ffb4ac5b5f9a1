#include "compiler/map/countries/country_group.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace citykiln::map {
namespace {

struct TownInGroup {
  double lon_deg, lat_deg;
  const char *group, *name;
};
constexpr TownInGroup kTownsInGroups[] = {
    {13.40, 52.52, "central_europe", "Berlin"},
    {9.52, 47.14, "central_europe", "Vaduz"},
    {9.84, 46.49, "central_europe", "St. Moritz"},
    {11.35, 46.50, "central_europe", "Bolzano"},
    {14.51, 46.05, "central_europe", "Ljubljana"},
    {15.98, 45.81, "central_europe", "Zagreb"},
    {19.04, 47.50, "central_europe", "Budapest"},
    {17.11, 48.15, "central_europe", "Bratislava"},
    {14.42, 50.09, "central_europe", "Prague"},
    {2.35, 48.86, "central_europe", "Paris"},
    {4.83, 45.76, "central_europe", "Lyon"},
    {2.38, 51.05, "central_europe", "Dunkirk"},
    {4.90, 52.37, "central_europe", "Amsterdam"},
    {9.43, 54.78, "central_europe", "Flensburg"},
    {14.99, 51.15, "central_europe", "Görlitz"},
    {13.07, 53.56, "central_europe", "Neubrandenburg"},
    {7.27, 43.70, "southern_europe", "Nice"},
    {7.42, 43.74, "southern_europe", "Monaco"},
    {-0.58, 44.84, "southern_europe", "Bordeaux"},
    {1.52, 42.51, "southern_europe", "Andorra la Vella"},
    {14.51, 35.90, "southern_europe", "Valletta"},
    {13.36, 38.12, "southern_europe", "Palermo"},
    {-8.61, 41.15, "southern_europe", "Porto"},
    {-9.14, 38.72, "southern_europe", "Lisbon"},
    {-5.35, 36.14, "southern_europe", "Gibraltar"},
    {12.34, 45.44, "southern_europe", "Venice"},
    {9.19, 45.46, "southern_europe", "Milan"},
    {11.12, 46.07, "southern_europe", "Trento"},
    {16.44, 43.51, "southern_europe", "Split"},
    {23.73, 37.98, "southern_europe", "Athens"},
    {33.38, 35.17, "southern_europe", "Nicosia"},
    {28.98, 41.01, "southern_europe", "Istanbul"},
    {32.85, 39.93, "southern_europe", "Ankara"},
    {-16.25, 28.47, "southern_europe", "Santa Cruz de Tenerife"},
    {24.94, 60.17, "northern_europe", "Helsinki"},
    {18.07, 59.33, "northern_europe", "Stockholm"},
    {12.57, 55.68, "northern_europe", "Copenhagen"},
    {5.32, 60.39, "northern_europe", "Bergen"},
    {-21.94, 64.15, "northern_europe", "Reykjavík"},
    {-6.77, 62.01, "northern_europe", "Tórshavn"},
    {24.75, 59.44, "northern_europe", "Tallinn"},
    {25.28, 54.69, "northern_europe", "Vilnius"},
    {14.55, 53.43, "eastern_europe", "Szczecin"},
    {19.94, 50.06, "eastern_europe", "Kraków"},
    {30.31, 59.94, "eastern_europe", "Saint Petersburg"},
    {20.51, 54.71, "eastern_europe", "Kaliningrad"},
    {23.32, 42.70, "eastern_europe", "Sofia"},
    {20.46, 44.82, "eastern_europe", "Belgrade"},
    {44.79, 41.72, "eastern_europe", "Tbilisi"},
    {76.91, 43.24, "eastern_europe", "Almaty"},
    {131.89, 43.12, "eastern_europe", "Vladivostok"},
    {106.92, 47.92, "eastern_europe", "Ulaanbaatar"},
    {-0.13, 51.51, "british_isles", "London"},
    {-6.26, 53.35, "british_isles", "Dublin"},
    {-8.63, 52.66, "british_isles", "Limerick"},
    {-1.15, 60.15, "british_isles", "Lerwick"},
    {-74.01, 40.74, "north_america", "New York"},
    {-118.47, 34.23, "north_america", "Los Angeles"},
    {-123.12, 49.28, "north_america", "Vancouver"},
    {-157.86, 21.31, "north_america", "Honolulu"},
    {-117.04, 32.48, "latin_america", "Tijuana"},
    {-99.13, 19.43, "latin_america", "Mexico City"},
    {-82.37, 23.11, "latin_america", "Havana"},
    {-64.88, 17.71, "latin_america", "Frederiksted"},
    {-43.10, -22.88, "latin_america", "Niterói"},
    {-70.65, -33.45, "latin_america", "Santiago"},
    {-5.80, 35.77, "middle_east", "Tangier"},
    {3.06, 36.75, "middle_east", "Algiers"},
    {31.24, 30.04, "middle_east", "Cairo"},
    {32.53, 15.59, "middle_east", "Khartoum"},
    {35.50, 33.89, "middle_east", "Beirut"},
    {36.29, 33.51, "middle_east", "Damascus"},
    {51.39, 35.69, "middle_east", "Tehran"},
    {69.17, 34.53, "middle_east", "Kabul"},
    {45.03, 12.79, "middle_east", "Aden"},
    {-17.45, 14.69, "tropical_africa", "Dakar"},
    {3.38, 6.52, "tropical_africa", "Lagos"},
    {36.82, -1.29, "tropical_africa", "Nairobi"},
    {38.76, 9.01, "tropical_africa", "Addis Ababa"},
    {18.42, -33.92, "tropical_africa", "Cape Town"},
    {47.51, -18.88, "tropical_africa", "Antananarivo"},
    {67.01, 24.86, "south_asia", "Karachi"},
    {77.21, 28.61, "south_asia", "Delhi"},
    {85.32, 27.71, "south_asia", "Kathmandu"},
    {90.41, 23.81, "south_asia", "Dhaka"},
    {79.86, 6.93, "south_asia", "Colombo"},
    {116.41, 39.90, "china", "Beijing"},
    {87.62, 43.83, "china", "Ürümqi"},
    {91.13, 29.65, "china", "Lhasa"},
    {114.17, 22.32, "china", "Hong Kong"},
    {121.57, 25.03, "china", "Taipei"},
    {126.98, 37.57, "china", "Seoul"},
    {129.08, 35.18, "china", "Busan"},
    {135.76, 34.96, "japan", "Kyoto"},
    {141.35, 43.07, "japan", "Sapporo"},
    {127.68, 26.21, "japan", "Naha"},
    {96.16, 16.87, "south_east_asia", "Yangon"},
    {98.98, 18.79, "south_east_asia", "Chiang Mai"},
    {105.85, 21.03, "south_east_asia", "Hanoi"},
    {103.82, 1.35, "south_east_asia", "Singapore"},
    {106.85, -6.21, "south_east_asia", "Jakarta"},
    {120.98, 14.60, "south_east_asia", "Manila"},
    {147.18, -9.44, "south_east_asia", "Port Moresby"},
    {115.86, -31.95, "oceania", "Perth"},
    {130.84, -12.46, "oceania", "Darwin"},
    {174.78, -41.29, "oceania", "Wellington"},
    {178.44, -18.14, "oceania", "Suva"},
};

TEST(CountryGroup, IsThatOfTheTown) {
  for (const TownInGroup& town : kTownsInGroups)
    EXPECT_EQ(name_of(country_group_at({town.lon_deg, town.lat_deg})), town.group) << town.name;
}

TEST(CountryGroup, OfEachNameHasATown) {
  std::set<std::string_view> names;
  for (int i = 0; i < static_cast<int>(CountryGroup::kCount); ++i) names.insert(name_of(static_cast<CountryGroup>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(CountryGroup::kCount));
  for (const TownInGroup& town : kTownsInGroups) names.erase(town.group);
  EXPECT_TRUE(names.empty());
}

TEST(CountryGroup, BeyondTheAntimeridianLongitudesGoOn) {
  // maps across 180 degrees have longitudes up to 200
  EXPECT_EQ(country_group_at({180, -16.8}), CountryGroup::kOceania) << "Taveuni";
  EXPECT_EQ(country_group_at({180.2, -16.8}), CountryGroup::kOceania) << "Rabi";
  EXPECT_EQ(country_group_at({186.8, 64.4}), CountryGroup::kEasternEurope) << "Provideniya";
  EXPECT_EQ(country_group_at({199.9, 58}), CountryGroup::kNorthAmerica) << "the Bering Sea";
  for (const double lon_deg : {180.0, 181.0, 187.5, 199.0})
    EXPECT_EQ(country_group_at({lon_deg, -20}), country_group_at({lon_deg - 360, -20})) << lon_deg;
}

TEST(CountryGroup, IsCentralEuropeOutsideOfTheWorld) {
  for (const LonLat place : {LonLat{0, 0}, LonLat{200, 95}, LonLat{-300, 10}})
    EXPECT_EQ(country_group_at(place), CountryGroup::kCentralEurope);
}

}  // namespace
}  // namespace citykiln::map
