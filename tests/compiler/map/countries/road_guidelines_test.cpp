#include "compiler/map/countries/road_guidelines.h"

#include <gtest/gtest.h>

namespace citykiln::map {
namespace {

struct TownInRegion {
  double lon_deg, lat_deg;
  RoadGuidelines guidelines;
  const char* name;
};
constexpr TownInRegion kTownsInRegions[] = {
    {-71.08, 42.35, RoadGuidelines::kNorthAmerica, "Boston"},
    {-117.16, 32.72, RoadGuidelines::kNorthAmerica, "San Diego"},
    {-106.49, 31.85, RoadGuidelines::kNorthAmerica, "El Paso"},
    {-80.19, 25.76, RoadGuidelines::kNorthAmerica, "Miami"},
    {-52.71, 47.56, RoadGuidelines::kNorthAmerica, "St. John's"},
    {-149.9, 61.22, RoadGuidelines::kNorthAmerica, "Anchorage"},
    {-157.86, 21.31, RoadGuidelines::kNorthAmerica, "Honolulu"},
    {-116.6, 31.87, RoadGuidelines::kElsewhere, "Ensenada"},
    {-100.31, 25.67, RoadGuidelines::kElsewhere, "Monterrey"},
    {-82.38, 23.13, RoadGuidelines::kElsewhere, "Havana"},
    {-51.74, 64.18, RoadGuidelines::kElsewhere, "Nuuk"},
    {-6.26, 53.35, RoadGuidelines::kBritishIsles, "Dublin"},
    {-8.63, 52.66, RoadGuidelines::kBritishIsles, "Limerick"},
    {1.31, 51.13, RoadGuidelines::kBritishIsles, "Dover"},
    {-1.14, 60.15, RoadGuidelines::kBritishIsles, "Lerwick"},
    {1.86, 50.95, RoadGuidelines::kElsewhere, "Calais"},
    {-1.62, 49.64, RoadGuidelines::kElsewhere, "Cherbourg"},
    {-6.77, 62.01, RoadGuidelines::kElsewhere, "Torshavn"},
    {135.76, 34.96, RoadGuidelines::kJapan, "Kyoto"},
    {127.68, 26.21, RoadGuidelines::kJapan, "Naha"},
    {129.08, 35.18, RoadGuidelines::kElsewhere, "Busan"},
    {13.4, 52.5, RoadGuidelines::kElsewhere, "Berlin"},
    {7.42, 43.73, RoadGuidelines::kElsewhere, "Monaco"},
    {179.9, -85, RoadGuidelines::kElsewhere, "the ice"},
};

TEST(RoadGuidelines, TownsLieInTheirRegions) {
  for (const TownInRegion& town : kTownsInRegions)
    EXPECT_EQ(guidelines_at({town.lon_deg, town.lat_deg}), town.guidelines) << town.name;
}

}  // namespace
}  // namespace citykiln::map
