#include "compiler/map/track_points.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace citykiln::map {
namespace {

struct MarkRow {
  std::string_view key, value;
  TrackPointKind kind;
};
constexpr MarkRow kMarks[] = {{"highway", "traffic_signals", TrackPointKind::kSignals},
                              {"highway", "stop", TrackPointKind::kStop},
                              {"highway", "give_way", TrackPointKind::kGiveWay},
                              {"railway", "level_crossing", TrackPointKind::kLevelCrossing},
                              {"railway", "crossing", TrackPointKind::kLevelCrossing},
                              {"railway", "tram_level_crossing", TrackPointKind::kLevelCrossing},
                              {"railway", "tram_crossing", TrackPointKind::kLevelCrossing},
                              {"highway", "turning_circle", TrackPointKind::kTurningCircle},
                              {"highway", "turning_loop", TrackPointKind::kTurningCircle},
                              {"highway", "mini_roundabout", TrackPointKind::kMiniRoundabout}};

// crossing:markings=zebra:double, ladder:skewed and the like are read by their first word
bool is_striped(std::string_view markings) {
  const std::string_view word = markings.substr(0, markings.find(':'));
  return word == "zebra" || word == "ladder";
}

std::optional<TrackPointKind> crossing_kind(const Reading& reading, source::Range tags) {
  const std::string_view crossing = reading.tag(tags, "crossing"), markings = reading.tag(tags, "crossing:markings");
  if (markings == "no") return std::nullopt;
  if (is_striped(markings) || crossing == "zebra" || reading.tag(tags, "crossing_ref") == "zebra")
    return TrackPointKind::kZebra;
  const bool says_more = !markings.empty() && markings != "yes";
  if (says_more) return TrackPointKind::kCrossing;
  if (crossing == "unmarked" || crossing == "informal" || crossing == "no") return std::nullopt;
  return crossing == "uncontrolled" ? TrackPointKind::kZebra : TrackPointKind::kCrossing;
}

// Signals of a road may hold its crossing too, on one node.
std::optional<TrackPointKind> crossing_of(const Reading& reading, source::Range tags) {
  const std::string_view highway = reading.tag(tags, "highway");
  const bool is_beside_signals = highway == "traffic_signals" && !reading.tag(tags, "crossing").empty();
  return highway == "crossing" || is_beside_signals ? crossing_kind(reading, tags) : std::nullopt;
}

std::int8_t facing_of(const Reading& reading, source::Range tags) {
  std::string_view direction = reading.tag(tags, "traffic_signals:direction");
  if (direction.empty()) direction = reading.tag(tags, "direction");
  return direction == "forward" ? std::int8_t{1} : direction == "backward" ? std::int8_t{-1} : std::int8_t{0};
}

void add_marks(const Reading& reading, const source::Node& node, std::vector<NodeMark>& marks) {
  if (const auto kind = crossing_of(reading, node.tags))
    marks.push_back({node.id, *kind, facing_of(reading, node.tags)});
  for (const MarkRow& row : kMarks)
    if (reading.tag(node.tags, row.key) == row.value)
      marks.push_back({node.id, row.kind, facing_of(reading, node.tags)});
}

}  // namespace

std::vector<NodeMark> node_marks(const Reading& reading) {
  std::vector<NodeMark> marks;
  for (const source::Node& node : reading.osm.nodes) add_marks(reading, node, marks);
  std::sort(marks.begin(), marks.end());
  return marks;
}

std::vector<TrackPoint> points_of(const Reading& reading, const source::Way& way, const LocatedLine& line,
                                  const std::vector<NodeMark>& marks) {
  std::vector<TrackPoint> points;
  const auto nodes = reading.osm.nodes_of(way);
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
