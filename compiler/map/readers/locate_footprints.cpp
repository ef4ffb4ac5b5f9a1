#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "compiler/map/buildings/building_tags.h"
#include "compiler/map/buildings/coincident_footprints.h"
#include "compiler/map/buildings/part_heights.h"
#include "compiler/map/buildings/part_looks.h"
#include "compiler/map/buildings/part_outlines.h"
#include "compiler/map/buildings/shell.h"
#include "compiler/map/buildings/treads.h"
#include "compiler/map/buildings/uncovered_pieces.h"
#include "compiler/map/readers/feature_readers.h"
#include "compiler/map/tags/standing.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

// Diagnoses each element that is built with a default height. An outline with parts is built only where none covers it.
void diagnose_heights(std::span<const Footprint> footprints, Report& report) {
  std::set<OsmId> found;
  for (const Footprint& f : footprints)
    if (f.has_default_height && !f.has_parts && found.insert(f.id.osm).second)
      report.add(Code::kNoBuildingHeight, f.id.osm);
}

}  // namespace

std::vector<Footprint> locate_footprints(const ReadContext& context) {
  std::vector<Footprint> footprints;
  Account account;
  for (const source::Area& area : context.osm.areas) {
    const BuildingValue value = building_value(context, area.tags);
    if (value.text.empty()) continue;
    account.in += context.report.counts(area.from);
    const Standing standing =
        standing_of_building(context.osm, area.tags, value.is_part ? "building:part" : "building");
    if (const auto reason = reason_to_drop(standing)) {
      context.report.drop(account, *reason, area.from);
      continue;
    }
    if (is_bridge_support(context, area.tags)) {
      context.report.drop(account, Code::kBridgeSupport, area.from);
      continue;
    }
    const std::vector<LocatedPolygon> polygons = located(context, area);
    Footprint footprint;
    if (!polygons.empty())
      footprint = read_building_tags(context, area.from, area.tags, value.text, polygons.front().area_m2);
    footprint.is_part = value.is_part;
    if (standing.presence == Presence::kShell)
      make_shell(is_ruin(context.osm, area.tags), states_height(context.osm, area.tags), footprint);
    for_each_near_polygon(context, area.from, polygons, account, [&](const LocatedPolygon& polygon) {
      footprint.id = {area.from, polygon.part};
      const LonLat place = context.plane.backward(polygon.polygon.outer.front());
      footprint.country = country_group_at(place);
      footprint.tradition = building_tradition_at(place);
      footprint.polygon = standing.presence == Presence::kShell ? shell_walls(polygon.polygon) : polygon.polygon;
      footprints.push_back(footprint);
    });
  }
  // before parts are assigned to outlines, since only one of two equal outlines gets them
  footprints = without_duplicates(std::move(footprints), account, context.report);
  const std::vector<std::uint32_t> outlines = part_outlines(footprints);
  complete_parts(footprints, outlines);
  complete_looks(context, footprints, outlines);
  footprints = with_uncovered_pieces(std::move(footprints), outlines, account, context.report);
  diagnose_unlike_parts(context, footprints);
  diagnose_heights(footprints, context.report);
  footprints = with_treads(std::move(footprints), outlines, account, context.report);
  context.report.account("map", "footprint") = account;
  return footprints;
}

}  // namespace citykiln::map
