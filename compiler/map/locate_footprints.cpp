#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "compiler/map/buildings/building_tags.h"
#include "compiler/map/buildings/coincident_footprints.h"
#include "compiler/map/buildings/part_outlines.h"
#include "compiler/map/feature_readers.h"
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

}  // namespace

std::vector<Footprint> locate_footprints(const ReadContext& context) {
  std::vector<Footprint> footprints;
  Account account;
  for (const source::Area& area : context.osm.areas) {
    const std::string_view outline = context.tag(area.tags, "building"), part = context.tag(area.tags, "building:part");
    if (!says_yes(outline) && !says_yes(part)) continue;
    account.in += context.report.counts(area.from);
    if (context.tag(area.tags, "location") == "underground") {
      context.report.drop(account, Code::kUnderground, area.from);
      continue;
    }
    const std::vector<LocatedPolygon> polygons = located(context, area);
    const bool is_part = says_yes(part) && !says_yes(outline);
    Footprint footprint;
    if (!polygons.empty())
      footprint = read_building_tags(context, area.from, area.tags, is_part ? part : outline, polygons.front().area_m2);
    footprint.is_part = is_part;
    for_each_near_polygon(context, area.from, polygons, account, [&](const LocatedPolygon& polygon) {
      footprint.id = {area.from, polygon.part};
      footprint.polygon = polygon.polygon;
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
