#include "compiler/map/things/locate_things.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "compiler/geometry/snap.h"
#include "compiler/map/readers/for_each_line.h"
#include "compiler/map/tagged_words.h"
#include "compiler/map/tags/read_elements.h"
#include "compiler/map/tags/tag_values.h"
#include "compiler/map/things/outline_places.h"

namespace citykiln::map {
namespace {

// Finds what the table of things describes among the nodes, ways and areas of an extract.

// A row, and the value of the first tag that it tests; a null row if none fits.
struct MatchedThing {
  const ThingRow* row = nullptr;
  std::string_view value;
};

// A thing on the map, and the first row that fits it.
struct FoundThing {
  ObjectId id;
  source::Range tags;
  source::Location where;  ///< A point of its element.
  MatchedThing match;
  Vec2 at;                                        ///< Its middle, snapped.
  double width_m = 0, depth_m = 0, height_m = 0;  ///< By the outline, else by tags, else by the row.
  bool has_height = false;                        ///< True if tags say height_m.
  std::optional<Vec2> along{};                    ///< The direction of its width if an outline says it.
  bool is_another = false;                        ///< True for a second thing of one element.
};

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

// Returns the nodes that have a row in the table and are no trees or lamps, and the ways and areas that have one and
// are no feature of another kind; outline_places.h says where on these things stand. Areas wider than 128 m have
// none. A size that cannot be read is diagnosed kBadTagValue. O(elements · rows of their keys).
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

constexpr double kMostCapacity = 1000;
constexpr double kHighestFoot_m = 1000;

bool is_road_of_things(const Track& track) {
  return values_of(track.surface).group == LandCoverGroup::kRoad || track.is_rail;
}

Vec2 direction_at_vertex(const Polyline& axis, std::size_t vertex) {
  const Vec2 before = vertex > 0 ? unit(axis[vertex] - axis[vertex - 1]) : Vec2{},
             after = vertex + 1 < axis.size() ? unit(axis[vertex + 1] - axis[vertex]) : Vec2{};
  const Vec2 mean = unit(before + after);
  return mean == Vec2{} ? (after == Vec2{} ? before : after) : mean;
}

ThingWay way_at(const Track& track, std::size_t vertex) {
  const double length_to_m = length_m(Polyline(track.axis.begin(), track.axis.begin() + static_cast<long>(vertex) + 1));
  return {.id = track.id,
          .along = direction_at_vertex(track.axis, vertex),
          .surface = track.surface,
          .side = track.side,
          .passage = track.passage,
          .is_oneway = track.is_oneway,
          .is_nearer_to_end = 2 * length_to_m > length_m(track.axis)};
}

// The way of each node: a road or railway, else a path; the first one by id.
std::map<std::int64_t, ThingWay> ways_of_nodes(const std::vector<FoundThing>& found, const Features& features) {
  std::map<std::int64_t, ThingWay> ways;
  for (const FoundThing& thing : found)
    if (thing.id.osm.type == OsmType::kNode) ways[thing.id.osm.id] = {};
  for (const bool is_road : {true, false})
    for (const Track& track : features.tracks) {
      if (is_road_of_things(track) != is_road) continue;
      for (std::size_t vertex = 0; vertex < track.node_ids.size() && vertex < track.axis.size(); ++vertex) {
        const auto way = ways.find(track.node_ids[vertex]);
        if (way != ways.end() && way->second.id.osm.type == OsmType::kNone) way->second = way_at(track, vertex);
      }
    }
  return ways;
}

// The direction of power lines at the points where they end: of two that meet, that of a line through both.
std::map<Vec2, Vec2> directions_at_ends(const std::vector<PowerLine>& lines) {
  std::map<Vec2, std::vector<Vec2>> outward;
  for (const PowerLine& line : lines) {
    outward[line.axis.front()].push_back(direction_at_vertex(line.axis, 0));
    outward[line.axis.back()].push_back(direction_at_vertex(line.axis, line.axis.size() - 1) * -1.0);
  }
  std::map<Vec2, Vec2> directions;
  for (const auto& [at, ends] : outward) {
    const Vec2 through = ends.size() == 2 ? unit(ends[1] - ends[0]) : ends[0];
    directions.emplace(at, through == Vec2{} ? ends[0] : through);
  }
  return directions;
}

// The direction of a power line at each of its points, and across walls and fences that of a way through them.
std::map<Vec2, Vec2> directions_of_lines(const Features& features) {
  std::map<Vec2, Vec2> directions;
  for (const PowerLine& line : features.power_lines)
    for (std::size_t i = 1; i + 1 < line.axis.size(); ++i)
      directions.emplace(line.axis[i], direction_at_vertex(line.axis, i));
  directions.merge(directions_at_ends(features.power_lines));
  for (const Barrier& barrier : features.barriers)
    for (std::size_t i = 0; i < barrier.axis.size(); ++i)
      directions.emplace(barrier.axis[i], left_of(direction_at_vertex(barrier.axis, i)));
  return directions;
}

std::set<std::int64_t> nodes_of_lines(const Features& features) {
  std::set<std::int64_t> nodes;
  for (const PowerLine& line : features.power_lines) nodes.insert(line.node_ids.begin(), line.node_ids.end());
  return nodes;
}

// forward and backward are for the traffic; other values are bearings.
void read_direction(const ReadContext& context, OsmId id, source::Range tags, ThingFeature& thing) {
  for (const std::string_view key : {"direction", "traffic_signals:direction", "traffic_sign:direction"}) {
    const std::string_view value = context.tag(tags, key);
    if (value.empty()) continue;
    if (value == "forward" || value == "backward") {
      thing.facing = value == "forward" ? std::int8_t{1} : std::int8_t{-1};
    } else if (value != "both") {
      thing.bearing_deg = parsed_text(context, id, key, value, bearing_deg_of);
    }
    return;
  }
}

bool may_be_on_roof(const ThingRow& row) { return row.stand == Stand::kRoof || row.stand == Stand::kThroughRoof; }

// By its location, whatever it is; by its level, if it is a thing of roofs.
bool is_on_roof(const ReadContext& context, const FoundThing& found) {
  const std::string& key = found.match.row->tags.front().front().key;
  if (standing_of_object(context.osm, found.tags, key).storey != Storey::kAbove) return false;
  return may_be_on_roof(*found.match.row) || is_located_on_roof(context.osm, found.tags);
}

bool is_stop(const ThingRow& row) { return row.name == "bus_stop" || row.name == "tram_stop"; }

std::uint8_t stop_equipment(const ReadContext& context, source::Range tags) {
  std::uint8_t has = 0;
  if (says_yes(context.tag(tags, "shelter"))) has |= kStopShelter;
  if (says_yes(context.tag(tags, "bench"))) has |= kStopBench;
  if (says_yes(context.tag(tags, "bin"))) has |= kStopBin;
  return has;
}

ThingFeature thing_of(const ReadContext& context, const FoundThing& found, const ThingWay& way) {
  const OsmId id = found.id.osm;
  ThingFeature thing{.id = found.id,
                     .at = found.at,
                     .kind = found.match.row->name,
                     .value = std::string(found.match.value),
                     .width_m = found.width_m,
                     .depth_m = found.depth_m,
                     .height_m = found.height_m,
                     .along = found.along};
  thing.colour = parsed_tag(context, id, found.tags, "colour", colour_of);
  const std::string_view material = context.tag(found.tags, "material");
  thing.material = thing_material_of(material).value_or(in_lower_case(material));
  thing.text = digits_of(context.tag(found.tags, "maxspeed"), context.tag(found.tags, "traffic_sign"));
  thing.capacity = static_cast<std::uint16_t>(
      number_within(context, id, "capacity", context.tag(found.tags, "capacity"), 0, kMostCapacity).value_or(0));
  thing.has_height = found.has_height;
  thing.min_height_m = snapped(tagged_length_m(context, id, found.tags, "min_height", 0, kHighestFoot_m).value_or(0));
  thing.is_on_roof = is_on_roof(context, found);
  if (is_stop(*found.match.row)) thing.stop_has = stop_equipment(context, found.tags);
  read_direction(context, id, found.tags, thing);
  thing.way = way;
  thing.country = country_group_at(LonLat{found.where.lon_deg(), found.where.lat_deg()});
  thing.is_in_way = found.match.row->stand == Stand::kInWay || found.match.row->stand == Stand::kOverRoad;
  return thing;
}

// A thing on a bridge or in a tunnel has no ground to stand on yet.
std::optional<Code> reason_without_thing(const ReadContext& context, const FoundThing& found, const ThingWay& way) {
  const std::string& key = found.match.row->tags.front().front().key;
  const auto reason = reason_without(context, found.tags, key);
  if (reason && !(reason == Code::kAboveGround && is_on_roof(context, found))) return reason;
  if (way.id.osm.type == OsmType::kNone || way.passage == Passage::kGround) return std::nullopt;
  return way.passage == Passage::kBridge ? Code::kAboveGround : Code::kUnderground;
}

// The way that a node belongs to, else the direction of the power line or fence at its place.
ThingWay way_at_place(const FoundThing& found, const std::map<std::int64_t, ThingWay>& ways,
                      const std::map<Vec2, Vec2>& lines) {
  if (found.id.osm.type != OsmType::kNode) return {};
  ThingWay way = ways.at(found.id.osm.id);
  if (const auto line = lines.find(found.at); way.id.osm.type == OsmType::kNone && line != lines.end())
    way.along = line->second;
  return way;
}

}  // namespace

std::string digits_of(std::string_view maxspeed, std::string_view traffic_sign) {
  constexpr std::string_view kDigits = "0123456789";
  constexpr std::size_t kMostDigits = 3;
  std::string_view text = maxspeed;
  if (text.empty()) {
    const std::size_t at =
        traffic_sign.find('[') != std::string_view::npos ? traffic_sign.find('[') : traffic_sign.rfind('-');
    if (at != std::string_view::npos) text = traffic_sign.substr(at + 1);
  }
  const std::string_view digits = text.substr(0, std::min(text.find_first_not_of(kDigits), text.size()));
  return std::string(digits.size() <= kMostDigits ? digits : "");
}

LocatedThings locate_things(const ReadContext& context, const ThingTable& table, const Features& features) {
  const std::vector<FoundThing> found = find_things(context, table, features);
  const std::map<std::int64_t, ThingWay> ways = ways_of_nodes(found, features);
  const std::map<Vec2, Vec2> lines = directions_of_lines(features);
  const std::set<std::int64_t> supports = nodes_of_lines(features);
  LocatedThings located;
  Account account;
  for (const FoundThing& each : found) {
    const bool counts = context.report.counts(each.id.osm);
    (each.is_another ? account.split : account.in) += counts;
    const ThingWay way = way_at_place(each, ways, lines);
    const auto reason = reason_without_thing(context, each, way);
    if (!context.extent.contains(each.at)) {
      context.report.drop(account, Code::kOutsideBounds, each.id.osm);
      const bool is_support = each.id.osm.type == OsmType::kNode && supports.contains(each.id.osm.id);
      if (!reason && is_support) located.supports_beyond.push_back(thing_of(context, each, way));
      continue;
    }
    if (reason) {
      context.report.drop(account, *reason, each.id.osm);
      continue;
    }
    account.out += counts;
    located.things.push_back(thing_of(context, each, way));
  }
  context.report.account("map", "thing") = account;
  return located;
}

}  // namespace citykiln::map
