#include "compiler/map/countries/building_tradition.h"

#include <gtest/gtest.h>

namespace citykiln::map {
namespace {

struct TownInTradition {
  double lon_deg, lat_deg;
  BuildingTradition tradition;
  const char* name;
};

constexpr BuildingTradition kFrance = BuildingTradition::kFrance, kBelgium = BuildingTradition::kBelgium,
                            kGermany = BuildingTradition::kGermany, kNoTradition = BuildingTradition::kOther;
constexpr TownInTradition kTownsInTraditions[] = {
    {2.35, 48.86, kFrance, "Paris"},
    {4.83, 45.76, kFrance, "Lyon"},
    {7.27, 43.70, kFrance, "Nice"},
    {7.42, 43.74, kFrance, "Monaco"},
    {-0.58, 44.84, kFrance, "Bordeaux"},
    {-4.49, 48.39, kFrance, "Brest"},
    {3.06, 50.63, kFrance, "Lille"},
    {7.75, 48.58, kFrance, "Strasbourg"},
    {8.74, 41.92, kFrance, "Ajaccio"},
    {4.35, 50.85, kBelgium, "Brussels"},
    {4.40, 51.22, kBelgium, "Antwerp"},
    {5.57, 50.63, kBelgium, "Liège"},
    {13.40, 52.52, kGermany, "Berlin"},
    {12.37, 51.34, kGermany, "Leipzig"},
    {16.37, 48.21, kGermany, "Vienna"},
    {9.99, 53.55, kGermany, "Hamburg"},
    {11.58, 48.14, kGermany, "Munich"},
    {14.42, 50.09, kGermany, "Prague"},
    {19.04, 47.50, kGermany, "Budapest"},
    {17.03, 51.11, kGermany, "Wrocław"},
    {6.96, 50.94, kGermany, "Cologne"},
    {6.78, 51.23, kGermany, "Düsseldorf"},
    {9.73, 52.37, kGermany, "Hanover"},
    {7.85, 48.00, kGermany, "Freiburg"},
    {17.11, 48.15, kGermany, "Bratislava"},
    {21.01, 52.23, kNoTradition, "Warsaw"},
    {4.90, 52.37, BuildingTradition::kNetherlands, "Amsterdam"},
    {5.12, 52.09, BuildingTradition::kNetherlands, "Utrecht"},
    {6.57, 53.22, BuildingTradition::kNetherlands, "Groningen"},
    {1.52, 42.51, kNoTradition, "Andorra la Vella"},
    {8.54, 47.37, kNoTradition, "Zürich"},
    {9.19, 45.46, kNoTradition, "Milan"},
    {2.17, 41.38, kNoTradition, "Barcelona"},
    {-0.13, 51.51, kNoTradition, "London"},
    {12.57, 55.68, kNoTradition, "Copenhagen"},
    {7.68, 45.07, kNoTradition, "Turin"},
    {9.10, 39.22, kNoTradition, "Cagliari"},
    {14.51, 46.05, kNoTradition, "Ljubljana"},
    {135.77, 35.0, kNoTradition, "Kyoto"},
};

TEST(BuildingTraditions, AreThoseOfTheTownsCountry) {
  for (const TownInTradition& town : kTownsInTraditions)
    EXPECT_EQ(building_tradition_at({town.lon_deg, town.lat_deg}), town.tradition) << town.name;
}

}  // namespace
}  // namespace citykiln::map
