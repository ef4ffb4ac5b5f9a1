#include "compiler/map/ways/private_ways.h"

#include <algorithm>
#include <string_view>

#include "compiler/source/osm_data.h"

namespace citykiln::map {

std::vector<OsmId> private_ways(const source::OsmData& osm) {
  std::vector<OsmId> ways;
  for (const source::Way& way : osm.ways) {
    const std::string_view service = osm.value_of(way.tags, "service");
    if (service == "driveway" || service == "parking_aisle" || service == "drive-through")
      ways.push_back({OsmType::kWay, way.id});
  }
  std::ranges::sort(ways);
  return ways;
}

}  // namespace citykiln::map
