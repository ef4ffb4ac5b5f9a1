#include "compiler/map/lanes/track_points.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

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
  if (crossing == "no") return std::nullopt;
  if (markings == "no") return TrackPointKind::kPlainCrossing;
  if (is_striped(markings) || crossing == "zebra" || context.tag(tags, "crossing_ref") == "zebra")
    return TrackPointKind::kZebra;
  const bool says_more = !markings.empty() && markings != "yes";
  if (says_more) return TrackPointKind::kCrossing;
  if (crossing == "unmarked" || crossing == "informal") return TrackPointKind::kPlainCrossing;
  return crossing == "uncontrolled" ? TrackPointKind::kZebra : TrackPointKind::kCrossing;
}

// A node with traffic signals may also be tagged as a crossing.
std::optional<TrackPointKind> crossing_of(const ReadContext& context, source::Range tags) {
  const std::string_view highway = context.tag(tags, "highway");
  const bool is_beside_signals = highway == "traffic_signals" && !context.tag(tags, "crossing").empty();
  return highway == "crossing" || is_beside_signals ? crossing_kind(context, tags) : std::nullopt;
}

bool is_crossing(TrackPointKind kind) {
  return kind == TrackPointKind::kZebra || kind == TrackPointKind::kCrossing || kind == TrackPointKind::kPlainCrossing;
}

std::int8_t facing_of(const ReadContext& context, source::Range tags) {
  std::string_view direction = context.tag(tags, "traffic_signals:direction");
  if (direction.empty()) direction = context.tag(tags, "direction");
  return direction == "forward" ? std::int8_t{1} : direction == "backward" ? std::int8_t{-1} : std::int8_t{0};
}

std::uint8_t kerb_traits(std::string_view kerb) {
  if (kerb == "lowered" || kerb == "sloped" || kerb == "rolled") return kLoweredKerb;
  if (kerb == "flush" || kerb == "no") return kFlushKerb;
  return kerb == "raised" ? kRaisedKerb : 0;
}

// The traits by the tags of one node.
std::uint8_t traits_of(const ReadContext& context, source::Range tags) {
  std::uint8_t traits = kerb_traits(context.tag(tags, "kerb"));
  const std::string_view slabs = context.tag(tags, "tactile_paving");
  if (slabs == "yes" || slabs == "incorrect") traits |= kTactileSlabs;
  if (slabs == "no") traits |= kNoTactileSlabs;
  if (context.tag(tags, "crossing:island") == "yes") traits |= kCrossingIsland;
  return traits;
}

void add_marks(const ReadContext& context, const source::Node& node, std::vector<NodeMark>& marks) {
  if (const auto kind = crossing_of(context, node.tags))
    marks.push_back({node.id, *kind, facing_of(context, node.tags), traits_of(context, node.tags)});
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

constexpr std::uint8_t kAnyKerb = kLoweredKerb | kFlushKerb | kRaisedKerb, kAnySlabs = kTactileSlabs | kNoTactileSlabs;

// Nodes where a kerb is mapped, and its traits, sorted.
std::vector<std::pair<std::int64_t, std::uint8_t>> mapped_kerbs(const ReadContext& context) {
  std::vector<std::pair<std::int64_t, std::uint8_t>> kerbs;
  for (const source::Node& node : context.osm.nodes)
    if (!context.tag(node.tags, "kerb").empty() || context.tag(node.tags, "barrier") == "kerb")
      if (const std::uint8_t traits = traits_of(context, node.tags); traits != 0) kerbs.emplace_back(node.id, traits);
  std::ranges::sort(kerbs);
  return kerbs;
}

// The lowest of the kerbs on both sides counts, and slabs on either side.
std::uint8_t joined_traits(std::uint8_t a, std::uint8_t b) {
  const std::uint8_t all = a | b;
  std::uint8_t joined = 0;
  for (const std::uint8_t kerb : {kFlushKerb, kLoweredKerb, kRaisedKerb})
    if ((joined & kAnyKerb) == 0) joined |= all & kerb;
  joined |= (all & kTactileSlabs) != 0 ? kTactileSlabs : all & kNoTactileSlabs;
  return joined;
}

bool is_path(const ReadContext& context, const source::Way& way) {
  const std::string_view highway = context.tag(way.tags, "highway");
  return highway == "footway" || highway == "path" || highway == "cycleway";
}

// Gives crossings the traits of the kerbs that are the next nodes of a path across them.
void add_traits_of_kerbs(const ReadContext& context, std::vector<NodeMark>& marks) {
  const std::vector<std::pair<std::int64_t, std::uint8_t>> kerbs = mapped_kerbs(context);
  if (kerbs.empty()) return;
  const auto traits_at = [&](std::int64_t id) -> std::uint8_t {
    const auto kerb = std::ranges::lower_bound(kerbs, std::pair{id, std::uint8_t{0}});
    return kerb != kerbs.end() && kerb->first == id ? kerb->second : std::uint8_t{0};
  };
  for (const source::Way& way : context.osm.ways) {
    if (!is_path(context, way)) continue;
    const auto nodes = context.osm.nodes_of(way);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::uint8_t beside = 0;
      if (i > 0) beside = joined_traits(beside, traits_at(nodes[i - 1].id));
      if (i + 1 < nodes.size()) beside = joined_traits(beside, traits_at(nodes[i + 1].id));
      if (beside == 0) continue;
      for (auto mark = std::ranges::lower_bound(marks, nodes[i].id, {}, &NodeMark::node_id);
           mark != marks.end() && mark->node_id == nodes[i].id; ++mark) {
        if (!is_crossing(mark->kind)) continue;
        if ((mark->traits & kAnyKerb) == 0) mark->traits |= beside & kAnyKerb;
        if ((mark->traits & kAnySlabs) == 0) mark->traits |= beside & kAnySlabs;
      }
    }
  }
}

}  // namespace

std::vector<NodeMark> node_marks(const ReadContext& context) {
  std::vector<NodeMark> marks;
  for (const source::Node& node : context.osm.nodes) add_marks(context, node, marks);
  add_untagged_level_crossings(context, marks);
  std::sort(marks.begin(), marks.end());
  add_traits_of_kerbs(context, marks);
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
      points.push_back(
          {.vertex = line.vertices[i], .kind = mark->kind, .facing = mark->facing, .traits = mark->traits});
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace citykiln::map
