// Functions that all feature readers share: an element's tags as values, and its nodes in the plane.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/plane.h"
#include "compiler/map/plants/user_plants.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// The extract, the plane it is located in, and the report.
struct ReadContext {
  const source::OsmData& osm;
  const Plane& plane;
  Box2 extent;
  Report& report;
  const UserPlants* user_plants = nullptr;  ///< Null: none.

  std::string_view tag(source::Range tags, std::string_view key) const { return osm.value_of(tags, key); }
};

/// A way in the plane: snapped, without equal consecutive points.
struct LocatedLine {
  Polyline axis;
  std::vector<std::int64_t> node_ids;   ///< The OSM node of each point.
  std::vector<std::uint32_t> vertices;  ///< Index of the point of each node of the way.
};
/// Returns the way in the plane. Nodes more than 65,536 m outside the extent are moved to that distance, in x and y. A
/// way whose nodes lie at one place has one point.
LocatedLine located(const ReadContext& context, const source::Way& way);

/// One polygon of an area, with its number: snapped, without repeated points, oriented, and trimmed to the surroundings
/// of the extent.
struct LocatedPolygon {
  std::uint32_t part = 0;
  Polygon polygon;
  double area_m2 = 0;  ///< Area before trimming.
};
/// Returns the polygons of an area; polygons without area are left out.
std::vector<LocatedPolygon> located(const ReadContext& context, const source::Area& area);

/// Calls visit(polygon) for each polygon whose box touches the extent. Others are dropped, kOutsideBounds; an area
/// without polygons is dropped, kDegenerateRing.
/// @param account  The account in which the area is counted.
template <typename Visit>
void for_each_near_polygon(const ReadContext& context, OsmId id, const std::vector<LocatedPolygon>& polygons,
                           Account& account, Visit visit) {
  if (polygons.empty()) return context.report.drop(account, Code::kDegenerateRing, id);
  const bool counts = context.report.counts(id);
  account.split += counts ? polygons.size() - 1 : 0;
  for (const LocatedPolygon& polygon : polygons) {
    if (polygon.polygon.outer.empty() || !box_of(polygon.polygon.outer).touches(context.extent)) {
      context.report.drop(account, Code::kOutsideBounds, id);
      continue;
    }
    account.out += counts;
    visit(polygon);
  }
}

/// Returns the value that `parse` reads from a text; nothing for an empty or unreadable text. An unreadable one is
/// diagnosed kBadTagValue.
/// @param key    The key of the tag that contains the text.
/// @param parse  A function from text to an optional value.
template <typename Parse>
auto parsed_text(const ReadContext& context, OsmId id, std::string_view key, std::string_view text, Parse parse)
    -> decltype(parse(text)) {
  if (text.empty()) return std::nullopt;
  auto parsed = parse(text);
  if (!parsed) context.report.add_tag(Code::kBadTagValue, id, key, text);
  return parsed;
}

/// Returns parsed_text() of the value of a key.
template <typename Parse>
auto parsed_tag(const ReadContext& context, OsmId id, source::Range tags, std::string_view key, Parse parse) {
  return parsed_text(context, id, key, context.tag(tags, key), parse);
}

/// Returns the number in a text; nothing for an empty text. A text that is no number, or a number outside least to
/// most, is diagnosed kBadTagValue and gives nothing.
/// @param key  The key of the tag that contains the text.
std::optional<double> number_within(const ReadContext& context, OsmId id, std::string_view key, std::string_view text,
                                    double least, double most);

/// Returns the length in a tag in metres; nothing if the tag is missing. An unreadable length, or one outside least_m
/// to most_m, is diagnosed kBadTagValue and gives nothing.
std::optional<double> tagged_length_m(const ReadContext& context, OsmId id, source::Range tags, std::string_view key,
                                      double least_m, double most_m);

/// Returns layer=*, -10 to 10; 0 if it is not tagged.
std::int8_t tagged_layer(const ReadContext& context, OsmId id, source::Range tags);

/// Returns bridge, tunnel or ground by tags.
Passage tagged_passage(const ReadContext& context, source::Range tags);

/// True if the box of a line touches the extent.
bool is_near(const ReadContext& context, const Polyline& line);

/// Diagnoses kCutAtBounds if a line leaves the extent.
void diagnose_cut(const ReadContext& context, OsmId id, const Polyline& line);

}  // namespace citykiln::map
