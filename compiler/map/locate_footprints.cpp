#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "compiler/map/buildings/building_tags.h"
#include "compiler/map/buildings/coincident_footprints.h"
#include "compiler/map/buildings/part_outlines.h"
#include "compiler/map/buildings/shell.h"
#include "compiler/map/feature_readers.h"
#include "compiler/map/standing.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

// Parts replace an outline if they cover more than this share of it: a single roof terrace mapped as a part does not.
constexpr double kCoveringShare = 0.6;

void mark_outlines(std::span<const std::uint32_t> outlines, std::vector<Footprint>& footprints) {
  std::vector<double> covered_m2(footprints.size(), 0);
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (outlines[i] == kNoOutline) continue;
    footprints[i].outline = footprints[outlines[i]].id;
    covered_m2[outlines[i]] += area_m2(footprints[i].polygon);
  }
  for (std::size_t i = 0; i < footprints.size(); ++i)
    footprints[i].has_parts = covered_m2[i] > kCoveringShare * area_m2(footprints[i].polygon);
}

// The value of building=*; of a house under construction its class, if that is tagged; of a disused one that of
// disused:building=*.
std::string_view building_text(const ReadContext& context, source::Range tags) {
  const std::string_view text = standing_value(context.osm, tags, "building");
  const std::string_view planned = context.tag(tags, "construction");
  return text == "construction" && says_yes(planned) ? planned : text;
}

}  // namespace

std::vector<Footprint> locate_footprints(const ReadContext& context) {
  std::vector<Footprint> footprints;
  Account account;
  for (const source::Area& area : context.osm.areas) {
    const std::string_view outline = building_text(context, area.tags), part = context.tag(area.tags, "building:part");
    if (!says_yes(outline) && !says_yes(part)) continue;
    account.in += context.report.counts(area.from);
    const bool is_part = says_yes(part) && !says_yes(outline);
    const Standing standing = standing_of_building(context.osm, area.tags, is_part ? "building:part" : "building");
    if (const auto reason = reason_to_drop(standing)) {
      context.report.drop(account, *reason, area.from);
      continue;
    }
    const std::vector<LocatedPolygon> polygons = located(context, area);
    Footprint footprint;
    if (!polygons.empty())
      footprint = read_building_tags(context, area.from, area.tags, is_part ? part : outline, polygons.front().area_m2);
    footprint.is_part = is_part;
    if (standing.presence == Presence::kShell)
      make_shell(is_ruin(context.osm, area.tags), states_height(context.osm, area.tags), footprint);
    for_each_near_polygon(context, area.from, polygons, account, [&](const LocatedPolygon& polygon) {
      footprint.id = {area.from, polygon.part};
      footprint.polygon = standing.presence == Presence::kShell ? shell_walls(polygon.polygon) : polygon.polygon;
      footprints.push_back(footprint);
    });
  }
  // before parts are assigned to outlines, since only one of two equal outlines gets them
  footprints = without_duplicates(std::move(footprints), account, context.report);
  const std::vector<std::uint32_t> outlines = part_outlines(footprints);
  mark_outlines(outlines, footprints);
  footprints = without_enclosed_parts(std::move(footprints), outlines, account, context.report);
  context.report.account("map", "footprint") = account;
  return footprints;
}

}  // namespace citykiln::map
