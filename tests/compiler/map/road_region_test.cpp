#include "compiler/map/road_region.h"

#include <gtest/gtest.h>

namespace citykiln::map {
namespace {

struct TownInRegion {
  double lon_deg, lat_deg;
  RoadRegion region;
  const char* name;
};
constexpr TownInRegion kTownsInRegions[] = {
    {-71.08, 42.35, RoadRegion::kNorthAmerica, "Boston"},
    {-117.16, 32.72, RoadRegion::kNorthAmerica, "San Diego"},
    {-106.49, 31.85, RoadRegion::kNorthAmerica, "El Paso"},
    {-80.19, 25.76, RoadRegion::kNorthAmerica, "Miami"},
    {-52.71, 47.56, RoadRegion::kNorthAmerica, "St. John's"},
    {-149.9, 61.22, RoadRegion::kNorthAmerica, "Anchorage"},
    {-157.86, 21.31, RoadRegion::kNorthAmerica, "Honolulu"},
    {-116.6, 31.87, RoadRegion::kElsewhere, "Ensenada"},
    {-100.31, 25.67, RoadRegion::kElsewhere, "Monterrey"},
    {-82.38, 23.13, RoadRegion::kElsewhere, "Havana"},
    {-51.74, 64.18, RoadRegion::kElsewhere, "Nuuk"},
    {-6.26, 53.35, RoadRegion::kBritishIsles, "Dublin"},
    {-8.63, 52.66, RoadRegion::kBritishIsles, "Limerick"},
    {1.31, 51.13, RoadRegion::kBritishIsles, "Dover"},
    {-1.14, 60.15, RoadRegion::kBritishIsles, "Lerwick"},
    {1.86, 50.95, RoadRegion::kElsewhere, "Calais"},
    {-1.62, 49.64, RoadRegion::kElsewhere, "Cherbourg"},
    {-6.77, 62.01, RoadRegion::kElsewhere, "Torshavn"},
    {135.76, 34.96, RoadRegion::kJapan, "Kyoto"},
    {127.68, 26.21, RoadRegion::kJapan, "Naha"},
    {129.08, 35.18, RoadRegion::kElsewhere, "Busan"},
    {13.4, 52.5, RoadRegion::kElsewhere, "Berlin"},
    {7.42, 43.73, RoadRegion::kElsewhere, "Monaco"},
    {179.9, -85, RoadRegion::kElsewhere, "the ice"},
};

TEST(RoadRegion, TownsLieInTheirRegions) {
  for (const TownInRegion& town : kTownsInRegions)
    EXPECT_EQ(road_region_at({town.lon_deg, town.lat_deg}), town.region) << town.name;
}

}  // namespace
}  // namespace citykiln::map
