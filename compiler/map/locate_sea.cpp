#include <algorithm>

#include "compiler/map/coastline.h"
#include "compiler/map/locate_parts.h"

namespace citykiln::map {
namespace {

// The sea is closed along a box this much wider than the region, so that its sides are never seen.
constexpr double kBeyond_m = 256;

}  // namespace

std::vector<AreaFeature> locate_sea(const Reading& reading) {
  std::vector<CoastWay> ways;
  Account account;
  for (const source::Way& way : reading.osm.ways) {
    if (reading.tag(way.tags, "natural") != "coastline") continue;
    ++account.in;
    const OsmId id{OsmType::kWay, way.id};
    LocatedLine line = located(reading, way);
    if (line.axis.size() < 2) {
      reading.report.drop(account, Code::kNoThickness, id);
      continue;
    }
    const auto nodes = reading.osm.nodes_of(way);
    ways.push_back({id, std::move(line.axis), nodes.front().id, nodes.back().id});
    ++account.merged;
  }
  // all sea is one object's: that of the lowest coastline, its polygons numbered from west to east
  OsmId first;
  for (const CoastWay& way : ways)
    if (first.type == OsmType::kNone || way.id < first) first = way.id;
  Sea sea = close_sea(std::move(ways), reading.region.widened(kBeyond_m));
  for (const OsmId open : sea.open_ends) reading.report.add(Code::kCoastlineOpen, open);
  std::sort(sea.polygons.begin(), sea.polygons.end(),
            [](const Polygon& a, const Polygon& b) { return a.outer < b.outer; });
  std::vector<AreaFeature> areas;
  for (Polygon& polygon : sea.polygons) {
    const double area = area_m2(polygon);
    areas.push_back({{first, static_cast<std::uint32_t>(areas.size())}, std::move(polygon), SurfaceClass::kSea, area});
  }
  account.split = account.out = areas.size();
  reading.report.account("map", "coastline") = account;
  return areas;
}

}  // namespace citykiln::map
