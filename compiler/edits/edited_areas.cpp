#include "compiler/edits/edited_areas.h"

#include <algorithm>
#include <map>
#include <set>

#include "compiler/edits/edited_tags.h"
#include "compiler/source/areas/assemble_areas.h"
#include "compiler/source/areas/mended_rings.h"

namespace citykiln::edits {
namespace {

using source::OsmData;

std::uint32_t size_of(const auto& vector) { return static_cast<std::uint32_t>(vector.size()); }

// Appends rings to those of the map.
source::Range append_rings(OsmData& map, std::span<const source::MendedPolygon> polygons) {
  source::Range range{size_of(map.rings), 0};
  for (std::uint32_t part = 0; part < polygons.size(); ++part)
    for (std::size_t ring = 0; ring < polygons[part].size(); ++ring) {
      const std::vector<source::Location>& points = polygons[part][ring];
      map.rings.push_back({{size_of(map.ring_points), size_of(points)}, part, ring == 0});
      map.ring_points.insert(map.ring_points.end(), points.begin(), points.end());
    }
  range.count = size_of(map.rings) - range.first;
  return range;
}

void report_broken(OsmId id, Report& report) { report.drop(report.account("edits", "area"), Code::kBrokenArea, id); }

// The ways and relations that have moved nodes.
std::set<OsmId> moved_elements(const OsmData& map, std::span<const std::int64_t> ways) {
  std::set<OsmId> moved;
  for (const std::int64_t way : ways) moved.insert({OsmType::kWay, way});
  for (const source::Relation& relation : map.relations)
    for (std::uint32_t i = 0; i < relation.members.count; ++i) {
      const OsmId member = map.members[relation.members.first + i].object;
      if (member.type == OsmType::kWay && std::ranges::binary_search(ways, member.id))
        moved.insert({OsmType::kRelation, relation.id});
    }
  return moved;
}

using MovedPlaces = std::map<source::Location, source::Location>;

std::vector<source::AreaLine> moved_rings(const OsmData& map, const source::Area& area, const MovedPlaces& to) {
  std::vector<source::AreaLine> rings;
  for (const source::AreaRing& ring : map.rings_of(area)) {
    source::AreaLine& line = rings.emplace_back();
    line.is_inner = !ring.is_outer;
    for (const source::Location at : map.points_of(ring)) {
      const auto found = to.find(at);
      line.points.push_back(found == to.end() ? at : found->second);
    }
    if (!line.points.empty()) line.points.push_back(line.points.front());
  }
  return rings;
}

// Writes moved points over those of an area, whose rings are too long to be mended.
void overwrite_rings(OsmData& map, const source::Area& area, std::span<const source::AreaLine> rings) {
  for (std::uint32_t i = 0; i < area.rings.count; ++i) {
    const source::Range points = map.rings[area.rings.first + i].points;
    std::copy_n(rings[i].points.begin(), points.count, map.ring_points.begin() + points.first);
  }
}

void move_area(OsmData& map, source::Area& area, const MovedPlaces& to, Report& report) {
  const std::vector<source::AreaLine> rings = moved_rings(map, area, to);
  std::size_t points = 0;
  for (const source::AreaLine& ring : rings) points += ring.points.size();
  if (points > source::kMostMended) {
    overwrite_rings(map, area, rings);
    return;
  }
  area.rings = append_rings(map, source::mended_polygons(rings));
  if (area.rings.count == 0) report_broken(area.from, report);
}

source::Area* area_of(OsmData& map, OsmId id, std::size_t count) {
  const auto end = map.areas.begin() + static_cast<std::ptrdiff_t>(count);
  const auto found = std::lower_bound(map.areas.begin(), end, id,
                                      [](const source::Area& area, OsmId wanted) { return area.from < wanted; });
  return found != end && found->from == id ? &*found : nullptr;
}

}  // namespace

bool describes_area(const OsmData& map, const source::Way& way) {
  const auto nodes = map.nodes_of(way);
  if (nodes.size() < 4 || map.value_of(way.tags, "area") == "no") return false;
  if (nodes.front().id != nodes.back().id && nodes.front().at != nodes.back().at) return false;
  return std::ranges::any_of(map.tags_of(way.tags),
                             [&](const source::Tag& tag) { return source::is_descriptive(map.strings[tag.key]); });
}

bool append_area(OsmData& map, const source::Way& way, Report& report) {
  source::AreaLine ring;
  for (const source::NodeRef& node : map.nodes_of(way)) ring.points.push_back(node.at);
  const OsmId id{OsmType::kWay, way.id};
  const source::Range rings = append_rings(map, source::mended_polygons(std::span(&ring, 1)));
  if (rings.count == 0)
    report_broken(id, report);
  else
    map.areas.push_back({id, rings, way.tags});
  return rings.count > 0;
}

void sort_areas(OsmData& map, std::size_t first) {
  const auto middle = map.areas.begin() + static_cast<std::ptrdiff_t>(first);
  const auto is_before = [](const source::Area& a, const source::Area& b) { return a.from < b.from; };
  std::sort(middle, map.areas.end(), is_before);
  std::inplace_merge(map.areas.begin(), middle, map.areas.end(), is_before);
}

void change_areas(OsmData& map, const Edits& edits, std::span<const Match> matches, const std::vector<bool>& were_areas,
                  Report& report) {
  const std::size_t old_count = map.areas.size();
  std::set<OsmId> gone;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Match& match = matches[i];
    if (match.id.type == OsmType::kNode || (!changes_tags(edits, match) && !is_dropped(edits, match))) continue;
    const bool is_way = match.id.type == OsmType::kWay;
    const bool is_area = !is_dropped(edits, match) && (!is_way || describes_area(map, map.ways[match.index]));
    source::Area* area = area_of(map, match.id, old_count);
    if (area != nullptr && is_area) area->tags = add_changed_tags(map, area->tags, edits, match);
    if (area != nullptr && !is_area) gone.insert(match.id);
    if (area == nullptr && is_way && is_area && !were_areas[i]) append_area(map, map.ways[match.index], report);
  }
  sort_areas(map, old_count);
  if (!gone.empty()) std::erase_if(map.areas, [&](const source::Area& area) { return gone.contains(area.from); });
}

void move_areas(OsmData& map, const NodeMoves& moves, std::span<const std::int64_t> ways, Report& report) {
  if (ways.empty()) return;
  MovedPlaces to;
  for (const auto& [node, move] : moves) to[move.from] = move.to;
  for (const OsmId id : moved_elements(map, ways))
    if (source::Area* area = area_of(map, id, map.areas.size())) move_area(map, *area, to, report);
  std::erase_if(map.areas, [](const source::Area& area) { return area.rings.count == 0; });
}

}  // namespace citykiln::edits
