#include "compiler/map/things/find_things.h"

#include <algorithm>
#include <map>

#include "compiler/geometry/snap.h"
#include "compiler/map/read_elements.h"
#include "compiler/map/tag_values.h"
#include "compiler/map/things/outline_places.h"

namespace citykiln::map {
namespace {

constexpr double kLeastThing_m = 0.05, kTallestThing_m = 400, kLargestArea_m = 128;

// The numbers of the rows that may fit an element with a key.
using RowsOfKeys = std::map<std::string_view, std::vector<std::size_t>>;

RowsOfKeys rows_of_keys(const ThingTable& table) {
  RowsOfKeys rows;
  for (std::size_t row = 0; row < table.size(); ++row)
    for (const std::vector<TagTest>& all : table[row].tags) rows[all.front().key].push_back(row);
  return rows;
}

MatchedThing match_tags(const ReadContext& context, source::Range tags, const ThingTable& table,
                        const RowsOfKeys& rows) {
  std::vector<std::size_t> candidates;
  for (const source::Tag& tag : context.osm.tags_of(tags))
    if (const auto found = rows.find(context.osm.strings[tag.key]); found != rows.end())
      candidates.insert(candidates.end(), found->second.begin(), found->second.end());
  std::ranges::sort(candidates);
  for (const std::size_t row : candidates) {
    const auto value = matched_value(table[row], [&](std::string_view key) { return context.tag(tags, key); });
    if (value) return {&table[row], *value};
  }
  return {};
}

std::optional<double> length_by_tag_m(const ReadContext& context, OsmId id, source::Range tags,
                                      const TaggedLength& length) {
  if (length.key.empty()) return std::nullopt;
  return tagged_length_m(context, id, tags, length.key, kLeastThing_m, kTallestThing_m);
}

double tagged_or_default_m(const ReadContext& context, OsmId id, source::Range tags, const TaggedLength& length) {
  return std::max(kQuantum_m, snapped(length_by_tag_m(context, id, tags, length).value_or(length.default_m)));
}

FoundThing found_thing(const ReadContext& context, OsmId id, source::Range tags, source::Location where,
                       const MatchedThing& match) {
  const std::optional<double> height_m = length_by_tag_m(context, id, tags, match.row->height);
  return {.id = {id, 0},
          .tags = tags,
          .where = where,
          .match = match,
          .at = context.plane.snapped_forward(where),
          .width_m = tagged_or_default_m(context, id, tags, match.row->width),
          .depth_m = tagged_or_default_m(context, id, tags, match.row->depth),
          .height_m = std::max(kQuantum_m, snapped(height_m.value_or(match.row->height.default_m))),
          .has_height = height_m.has_value()};
}

FoundThing placed(FoundThing thing, const OutlinePlace& place, std::uint32_t part, bool is_another) {
  thing.id.part = part, thing.is_another = is_another;
  thing.at = place.at, thing.along = place.along;
  thing.width_m = place.width_m, thing.depth_m = place.depth_m;
  return thing;
}

// A closed way is a line if things on it may stand in a way (a ring of bollards); others are areas.
bool runs_along_line(const ReadContext& context, const source::Way& way, const Polyline& axis, Stand stand) {
  return axis.front() != axis.back() || (stand == Stand::kInWay && !says_yes(context.tag(way.tags, "area")));
}

void add_in_area(const FoundThing& thing, const Ring& ring, std::uint32_t part, std::vector<FoundThing>& found) {
  const Box2 box = box_of(ring);
  if (ring.size() < 3 || std::max(box.width(), box.height()) > kLargestArea_m) return;
  const bool is_another = !found.empty() && found.back().id.osm == thing.id.osm;
  found.push_back(placed(thing, place_in_area(ring, thing.width_m, thing.depth_m), part, is_another));
}

void add_way(const ReadContext& context, const source::Way& way, const MatchedThing& match,
             std::vector<FoundThing>& found) {
  Polyline axis = located(context, way).axis;
  if (axis.size() < 2 || !is_near(context, axis)) return;
  const source::Location where = context.osm.nodes_of(way).front().at;
  const FoundThing thing = found_thing(context, {OsmType::kWay, way.id}, way.tags, where, match);
  if (!runs_along_line(context, way, axis, match.row->stand)) {
    axis.pop_back();
    return add_in_area(thing, axis, 0, found);
  }
  std::uint32_t part = 0;
  for (const OutlinePlace& place : places_on_line(axis, match.row->stand, thing.width_m, thing.depth_m)) {
    found.push_back(placed(thing, place, part, part > 0));
    ++part;
  }
}

void add_multipolygon(const ReadContext& context, const source::Area& area, const MatchedThing& match,
                      std::vector<FoundThing>& found) {
  const source::Location where = context.osm.points_of(context.osm.rings_of(area).front()).front();
  const FoundThing thing = found_thing(context, area.from, area.tags, where, match);
  for (const LocatedPolygon& each : located(context, area)) add_in_area(thing, each.polygon.outer, each.part, found);
}

std::vector<OsmId> trees_and_lamps(const Features& features) {
  std::vector<OsmId> ids;
  for (const PointFeature& point : features.points)
    if (point.kind == PointKind::kTree || point.kind == PointKind::kStreetLamp) ids.push_back(point.id.osm);
  std::ranges::sort(ids);
  return ids;
}

}  // namespace

std::vector<FoundThing> find_things(const ReadContext& context, const ThingTable& table, const Features& features) {
  const RowsOfKeys rows = rows_of_keys(table);
  const std::vector<OsmId> points = trees_and_lamps(features), others = read_elements(features, context.report);
  const auto match = [&](const std::vector<OsmId>& read, OsmId id, source::Range tags) {
    const MatchedThing fit = match_tags(context, tags, table, rows);
    return fit.row != nullptr && !std::ranges::binary_search(read, id) ? fit : MatchedThing{};
  };
  std::vector<FoundThing> found;
  for (const source::Node& node : context.osm.nodes) {
    const OsmId id{OsmType::kNode, node.id};
    if (const auto fit = match(points, id, node.tags); fit.row != nullptr)
      found.push_back(found_thing(context, id, node.tags, node.at, fit));
  }
  for (const source::Way& way : context.osm.ways)
    if (const auto fit = match(others, {OsmType::kWay, way.id}, way.tags); fit.row != nullptr)
      add_way(context, way, fit, found);
  for (const source::Area& area : context.osm.areas)
    if (area.from.type == OsmType::kRelation)
      if (const auto fit = match(others, area.from, area.tags); fit.row != nullptr)
        add_multipolygon(context, area, fit, found);
  return found;
}

}  // namespace citykiln::map
