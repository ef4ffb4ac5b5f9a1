#include <algorithm>

#include "compiler/map/building_tags.h"
#include "compiler/map/feature_readers.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

// The share of an outline that its parts must cover to replace it: a single roof terrace mapped as a part does not.
constexpr double kCoveringShare = 0.6;

Vec2 inner_point(const Polygon& polygon) {
  // the point only has to tell parts from neighbours: the centre of the box, else a point just inside an edge
  const Vec2 centre = box_of(polygon.outer).centre();
  if (contains(polygon, centre)) return centre;
  for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
    const Vec2 a = polygon.outer[i], b = polygon.outer[(i + 1) % polygon.outer.size()];
    const Vec2 p = (a + b) * 0.5 + unit(left_of(b - a)) * 0.05;
    if (contains(polygon, p)) return p;
  }
  return polygon.outer.front();
}

void mark_outlines(std::vector<Footprint>& footprints) {
  std::vector<std::size_t> outlines;
  for (std::size_t i = 0; i < footprints.size(); ++i)
    if (!footprints[i].is_part) outlines.push_back(i);
  const auto west = [&](std::size_t i) { return box_of(footprints[i].polygon.outer).min.x; };
  std::sort(outlines.begin(), outlines.end(), [&](auto a, auto b) { return west(a) < west(b); });
  std::vector<double> edges, covered(footprints.size(), 0);
  double widest = 0;
  for (const std::size_t i : outlines) {
    edges.push_back(west(i));
    widest = std::max(widest, box_of(footprints[i].polygon.outer).width());
  }
  for (const Footprint& part : footprints) {
    if (!part.is_part) continue;
    const Vec2 p = inner_point(part.polygon);
    const auto end = std::upper_bound(edges.begin(), edges.end(), p.x);
    const auto begin = std::lower_bound(edges.begin(), edges.end(), p.x - widest);
    for (auto edge = begin; edge != end; ++edge) {
      const std::size_t i = outlines[static_cast<std::size_t>(edge - edges.begin())];
      if (box_of(footprints[i].polygon.outer).contains(p) && contains(footprints[i].polygon, p))
        covered[i] += area_m2(part.polygon);
    }
  }
  for (const std::size_t i : outlines)
    footprints[i].has_parts = covered[i] > kCoveringShare * area_m2(footprints[i].polygon);
}

}  // namespace

std::vector<Footprint> locate_footprints(const ReadContext& context) {
  std::vector<Footprint> footprints;
  Account account;
  for (const source::Area& area : context.osm.areas) {
    const std::string_view outline = context.tag(area.tags, "building"), part = context.tag(area.tags, "building:part");
    if (!says_yes(outline) && !says_yes(part)) continue;
    ++account.in;
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
  context.report.account("map", "footprint") = account;
  mark_outlines(footprints);
  return footprints;
}

}  // namespace citykiln::map
