#include <algorithm>

#include "compiler/map/readers/coastline.h"
#include "compiler/map/readers/feature_readers.h"

namespace citykiln::map {
namespace {

// The sea is closed along a box this much wider than the extent, which puts its sides out of sight.
constexpr double kBeyond_m = 256;

}  // namespace

LocatedSea locate_sea(const ReadContext& context) {
  std::vector<CoastWay> ways;
  Account account;
  for (const source::Way& way : context.osm.ways) {
    if (context.tag(way.tags, "natural") != "coastline") continue;
    const OsmId id{OsmType::kWay, way.id};
    account.in += context.report.counts(id);
    LocatedLine line = located(context, way);
    if (line.axis.size() < 2) {
      context.report.drop(account, Code::kNoLength, id);
      continue;
    }
    const auto nodes = context.osm.nodes_of(way);
    ways.push_back({id, std::move(line.axis), nodes.front().id, nodes.back().id});
    account.merged += context.report.counts(id);
  }
  // the sea is one object with the id of its lowest coastline; its polygons are numbered from west to east
  OsmId first;
  LocatedSea located_sea;
  for (const CoastWay& way : ways)
    if (first.type == OsmType::kNone || way.id < first) first = way.id;
  for (const CoastWay& way : ways) located_sea.coasts.push_back(way.axis);
  Sea sea = close_sea(std::move(ways), context.extent.widened(kBeyond_m));
  for (const OsmId open : sea.open_ends) context.report.add(Code::kCoastlineOpen, open);
  std::sort(sea.polygons.begin(), sea.polygons.end(),
            [](const Polygon& a, const Polygon& b) { return a.outer < b.outer; });
  std::vector<AreaFeature>& areas = located_sea.areas;
  for (Polygon& polygon : sea.polygons) {
    const double area = area_m2(polygon);
    areas.push_back({.id = {first, static_cast<std::uint32_t>(areas.size())},
                     .polygon = std::move(polygon),
                     .surface = LandCoverClass::kSea,
                     .area_m2 = area});
  }
  account.split = account.out = context.report.counts(first) ? areas.size() : 0;
  context.report.account("map", "coastline") = account;
  return located_sea;
}

}  // namespace citykiln::map
