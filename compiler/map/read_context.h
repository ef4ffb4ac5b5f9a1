// What all feature readers need: an element's tags, and its nodes in the plane.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/map/plane.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// The extract, the plane it is located in, and the report.
struct ReadContext {
  const source::OsmData& osm;
  const Plane& plane;
  Box2 region;
  Report& report;

  std::string_view tag(source::Range tags, std::string_view key) const { return osm.value_of(tags, key); }
};

/// A way in the plane: snapped, without repeated neighbours.
struct LocatedLine {
  Polyline axis;
  std::vector<std::int64_t> node_ids;   ///< The OSM node of each point.
  std::vector<std::uint32_t> vertices;  ///< The point of each node of the way.
};
LocatedLine located(const ReadContext& context, const source::Way& way);

/// The polygons of an area with the numbers of their parts: snapped, without repeats, oriented, trimmed to what is near
/// the region. Polygons without area are left out.
struct LocatedPolygon {
  std::uint32_t part = 0;
  Polygon polygon;
  double area_m2 = 0;  ///< Before trimming.
};
std::vector<LocatedPolygon> located(const ReadContext& context, const source::Area& area);

/// Calls visit(polygon) for each polygon near the region. The account gets the others as dropped, kOutsideBounds, and
/// an area without polygons as dropped, kDegenerateRing.
template <typename Visit>
void for_each_near_polygon(const ReadContext& context, OsmId id, const std::vector<LocatedPolygon>& polygons,
                           Account& account, Visit visit) {
  if (polygons.empty()) return context.report.drop(account, Code::kDegenerateRing, id);
  const bool counts = context.report.counts(id);
  account.split += counts ? polygons.size() - 1 : 0;
  for (const LocatedPolygon& polygon : polygons) {
    if (polygon.polygon.outer.empty() || !box_of(polygon.polygon.outer).touches(context.region)) {
      context.report.drop(account, Code::kOutsideBounds, id);
      continue;
    }
    account.out += counts;
    visit(polygon);
  }
}

/// Returns parse(text), an optional, or nothing for an empty text. Diagnosed: kBadTagValue of `key` where parse returns
/// nothing.
template <typename Parse>
auto parsed_text(const ReadContext& context, OsmId id, std::string_view key, std::string_view text, Parse parse)
    -> decltype(parse(text)) {
  if (text.empty()) return std::nullopt;
  auto parsed = parse(text);
  if (!parsed) context.report.add_tag(Code::kBadTagValue, id, key, text);
  return parsed;
}

/// parsed_text() of the whole value of a key.
template <typename Parse>
auto parsed_tag(const ReadContext& context, OsmId id, source::Range tags, std::string_view key, Parse parse) {
  return parsed_text(context, id, key, context.tag(tags, key), parse);
}

/// Returns the number that a text of `key` states, from least to most, or nothing where the text is empty. Diagnosed:
/// kBadTagValue.
std::optional<double> number_within(const ReadContext& context, OsmId id, std::string_view key, std::string_view text,
                                    double least, double most);

/// Returns a length from a tag, or nothing where it is absent. Diagnosed: kBadTagValue where it is unreadable or
/// outside least … most.
std::optional<double> tagged_length_m(const ReadContext& context, OsmId id, source::Range tags, std::string_view key,
                                      double least_m, double most_m);

/// Returns layer=*, between -10 and 10; 0 where absent.
std::int8_t tagged_layer(const ReadContext& context, OsmId id, source::Range tags);

/// Returns bridge, tunnel or ground by tags.
Passage tagged_passage(const ReadContext& context, source::Range tags);

/// True where the box of a line touches the region.
bool is_near(const ReadContext& context, const Polyline& line);

/// Diagnoses kCutAtBounds where a line leaves the region.
void tell_cut(const ReadContext& context, OsmId id, const Polyline& line);

}  // namespace citykiln::map
