#include "compiler/map/countries/road_guidelines.h"

#include "compiler/map/countries/country_group.h"

namespace citykiln::map {

RoadGuidelines guidelines_at(LonLat place) {
  switch (country_group_at(place)) {
    case CountryGroup::kNorthAmerica:
      return RoadGuidelines::kNorthAmerica;
    case CountryGroup::kBritishIsles:
      return RoadGuidelines::kBritishIsles;
    case CountryGroup::kJapan:
      return RoadGuidelines::kJapan;
    default:
      return RoadGuidelines::kElsewhere;
  }
}

}  // namespace citykiln::map
