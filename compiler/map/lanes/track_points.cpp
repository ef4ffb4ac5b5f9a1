#include "compiler/map/lanes/track_points.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>
#include <string_view>

#include "compiler/map/lanes/track_rules.h"

namespace citykiln::map {
namespace {

struct MarkRow {
  std::string_view key, value;
  TrackPointKind kind;
};
constexpr MarkRow kMarks[] = {
#define TRACK_POINT(key, value, kind) {key, value, TrackPointKind::kind},
#include "compiler/map/line_rules.inc"
#undef TRACK_POINT
};

// The first word of crossing:markings decides: zebra:double, ladder:skewed.
bool is_striped(std::string_view markings) {
  const std::string_view word = markings.substr(0, markings.find(':'));
  return word == "zebra" || word == "ladder";
}

std::optional<TrackPointKind> crossing_kind(const ReadContext& context, source::Range tags) {
  const std::string_view crossing = context.tag(tags, "crossing"), markings = context.tag(tags, "crossing:markings");
  if (markings == "no") return std::nullopt;
  if (is_striped(markings) || crossing == "zebra" || context.tag(tags, "crossing_ref") == "zebra")
    return TrackPointKind::kZebra;
  const bool says_more = !markings.empty() && markings != "yes";
  if (says_more) return TrackPointKind::kCrossing;
  if (crossing == "unmarked" || crossing == "informal" || crossing == "no") return std::nullopt;
  return crossing == "uncontrolled" ? TrackPointKind::kZebra : TrackPointKind::kCrossing;
}

// A node with traffic signals may also be tagged as a crossing.
std::optional<TrackPointKind> crossing_of(const ReadContext& context, source::Range tags) {
  const std::string_view highway = context.tag(tags, "highway");
  const bool is_beside_signals = highway == "traffic_signals" && !context.tag(tags, "crossing").empty();
  return highway == "crossing" || is_beside_signals ? crossing_kind(context, tags) : std::nullopt;
}

std::int8_t facing_of(const ReadContext& context, source::Range tags) {
  std::string_view direction = context.tag(tags, "traffic_signals:direction");
  if (direction.empty()) direction = context.tag(tags, "direction");
  return direction == "forward" ? std::int8_t{1} : direction == "backward" ? std::int8_t{-1} : std::int8_t{0};
}

void add_marks(const ReadContext& context, const source::Node& node, std::vector<NodeMark>& marks) {
  if (const auto kind = crossing_of(context, node.tags))
    marks.push_back({node.id, *kind, facing_of(context, node.tags)});
  for (const MarkRow& row : kMarks)
    if (context.tag(node.tags, row.key) == row.value)
      marks.push_back({node.id, row.kind, facing_of(context, node.tags)});
}

// The sorted nodes of all ways on the ground whose row of the table `is_wanted`.
template <typename IsWanted>
std::vector<std::int64_t> nodes_on_ground(const ReadContext& context, IsWanted is_wanted) {
  std::vector<std::int64_t> ids;
  for (const source::Way& way : context.osm.ways) {
    const TrackRow* row = track_row([&](std::string_view key) { return context.tag(way.tags, key); });
    if (row == nullptr || !is_wanted(*row) || tagged_passage(context, way.tags) != Passage::kGround) continue;
    for (const auto& node : context.osm.nodes_of(way)) ids.push_back(node.id);
  }
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

// A node of a railway and of a way for feet or wheels is a level crossing without tags, too. Tramways are paved anyway.
void add_untagged_level_crossings(const ReadContext& context, std::vector<NodeMark>& marks) {
  const auto is_railway = [](const TrackRow& row) { return row.surface == LandCoverClass::kRailway; };
  const auto is_highway = [](const TrackRow& row) { return row.key == "highway"; };
  const std::vector<std::int64_t> rails = nodes_on_ground(context, is_railway);
  if (rails.empty()) return;
  std::vector<std::int64_t> crossed;
  std::ranges::set_intersection(rails, nodes_on_ground(context, is_highway), std::back_inserter(crossed));
  for (const std::int64_t id : crossed) marks.push_back({id, TrackPointKind::kLevelCrossing, 0});
}

}  // namespace

std::vector<NodeMark> node_marks(const ReadContext& context) {
  std::vector<NodeMark> marks;
  for (const source::Node& node : context.osm.nodes) add_marks(context, node, marks);
  add_untagged_level_crossings(context, marks);
  std::sort(marks.begin(), marks.end());
  return marks;
}

std::vector<TrackPoint> points_of(const ReadContext& context, const source::Way& way, const LocatedLine& line,
                                  const std::vector<NodeMark>& marks) {
  assert(line.vertices.size() == context.osm.nodes_of(way).size());
  std::vector<TrackPoint> points;
  const auto nodes = context.osm.nodes_of(way);
  const bool is_closed = nodes.size() > 2 && nodes.front().id == nodes.back().id;
  for (std::size_t i = 0; i + (is_closed ? 1 : 0) < nodes.size(); ++i) {
    const NodeMark first{nodes[i].id, {}, -1};
    for (auto mark = std::lower_bound(marks.begin(), marks.end(), first);
         mark != marks.end() && mark->node_id == nodes[i].id; ++mark)
      points.push_back({line.vertices[i], mark->kind, mark->facing});
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace citykiln::map
