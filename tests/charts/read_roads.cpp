#include "tests/charts/read_roads.h"

#include "compiler/map/locate.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/source/read_osm.h"

namespace citykiln::charts {

Result<std::vector<roads::Road>> read_roads(const std::string& path, int threads) {
  Report ignored;
  const Result<source::OsmData> osm = source::read_osm(path, threads, ignored);
  if (!osm) return osm.error();
  const source::LonLatBox box = map::choose_box(*osm, {});
  return roads::roads_on_ground(map::locate(*osm, map::Plane(map::default_origin(box)), box, {}, ignored), ignored);
}

}  // namespace citykiln::charts
