#include "compiler/wires/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/wires/sag.h"
#include "compiler/wires/supports.h"

namespace citykiln::wires {
namespace {

// Roads and bridges that lines cross, with a spatial index.

// The segments of roads, railways and bridges.
struct Crossings {
  struct Segment {
    Vec2 a, b;
    std::optional<double> a_m, b_m;  ///< Heights of a bridge at its ends; empty on the ground.
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};

// A place where a line crosses a road.
struct Crossing {
  double t = 0;                    ///< The share of the line.
  std::optional<double> deck_m{};  ///< The height of a bridge; empty on the ground.
};

constexpr double kCrossingBucket_m = 64;

bool is_crossed(map::LandCoverClass surface) {
  const map::LandCoverGroup group = map::values_of(surface).group;
  return group == map::LandCoverGroup::kRoad || group == map::LandCoverGroup::kRail;
}

// Segments of a road; with a profile, their heights.
template <typename Road>
void add_segments(const Road& road, bool is_bridge, Crossings& crossings, std::vector<Box2>& boxes) {
  if (!is_crossed(road.surface)) return;
  double along_m = road.start_along_m;
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    Crossings::Segment segment{road.axis[i], road.axis[i + 1], {}, {}};
    const double end_m = along_m + distance(segment.a, segment.b);
    if (is_bridge && !road.profile.empty())
      segment.a_m = knot_at(road.profile, along_m).z_m, segment.b_m = knot_at(road.profile, end_m).z_m;
    along_m = end_m;
    crossings.segments.push_back(segment);
    boxes.push_back(box_of_segment(segment.a, segment.b));
  }
}

Crossings index_crossings(std::span<const roads::Road> roads, std::span<const structures::Span> bridges) {
  Crossings crossings;
  std::vector<Box2> boxes;
  for (const roads::Road& road : roads) add_segments(road, false, crossings, boxes);
  for (const structures::Span& bridge : bridges) add_segments(bridge, true, crossings, boxes);
  crossings.grid = grid_of(boxes, kCrossingBucket_m);
  return crossings;
}

// Returns the crossings of the line from a to b, in no order that matters. O(segments near it).
std::vector<Crossing> crossings_of(const Crossings& crossings, Vec2 a, Vec2 b) {
  std::vector<Crossing> found;
  for (const std::uint32_t i : boxes_about(crossings.grid, box_of_segment(a, b))) {
    const Crossings::Segment& segment = crossings.segments[i];
    const auto shares = crossing_shares(a, b, segment.a, segment.b);
    if (!shares) continue;
    Crossing crossing{shares->first, {}};
    if (segment.a_m) crossing.deck_m = *segment.a_m + (*segment.b_m - *segment.a_m) * shares->second;
    found.push_back(crossing);
  }
  return found;
}

// Nearer supports hold no wires between them.
constexpr double kShortestSpan_m = 2;
// Distance of the places where a wire's height above the ground is measured.
constexpr double kGroundStep_m = 8;
// Wires are this much higher above the middle of a road than they have to be, since its sides may be higher.
constexpr double kRoadMargin_m = 0.5;
// The earth wire is strung tighter than the conductors.
constexpr double kEarthWireSag = 0.8;
// Between the places where it is measured, a wire may be higher above the ground by this.
constexpr double kAboveMargin_m = 2;

constexpr std::uint8_t kEarthWire_mm = 12, kCable_mm = 25;
// A bundle of n wires is one wire with the section of all; more than four count as four.
constexpr std::array<std::uint8_t, 5> kBundle_mm = {15, 15, 21, 26, 30};
constexpr double kFourWires_kv = 380, kTwoWires_kv = 220;

std::uint8_t radius_mm_of(const map::PowerLine& line) {
  const int assumed = line.voltage_kv >= kFourWires_kv ? 4 : line.voltage_kv >= kTwoWires_kv ? 2 : 1;
  const int wires = line.bundle > 0 ? line.bundle : assumed;
  return kBundle_mm[static_cast<std::size_t>(std::min(wires, 4))];
}

const SagClass& sag_class_of(const map::PowerLine& line) {
  if (line.kind == map::PowerLineKind::kAerialway) return kAerialwaySag;
  return line.kind == map::PowerLineKind::kLine ? kLineSag : kMinorLineSag;
}

// The data that all spans need.
struct SpanPlanner {
  const map::FeatureView& features;
  const Surroundings& around;
  Supports supports;
  Crossings crossings;
  std::set<std::int64_t> mapped;  // nodes of things, built or not

  bool is_in_extent(Vec2 p) const { return features.extent.contains(p); }
};

SpanPlanner planner_of(const map::FeatureView& features, const Surroundings& around) {
  SpanPlanner planner{features, around, {}, index_crossings(around.roads, around.bridges), {}};
  add_supports(planner.supports, around.things, around.kinds, around.seed, around.ground);
  add_supports(planner.supports, around.beyond, around.kinds, around.seed, around.ground);
  for (const map::ThingFeature& thing : around.mapped)
    if (thing.id.osm.type == OsmType::kNode) planner.mapped.insert(thing.id.osm.id);
  return planner;
}

// The wires of one kind between two supports, without sag.
void add_straight(std::vector<Wire>& wires, const Support& from, const Support& to, WireKind kind, std::size_t most,
                  std::uint8_t radius_mm) {
  const Vec2 along = to.at - from.at;
  std::vector<Vec3> a = ordered_holds(from, kind, along), b = ordered_holds(to, kind, along);
  const std::size_t count = std::min({a.size(), b.size(), most});
  a = chosen_holds(std::move(a), count, from.at, along), b = chosen_holds(std::move(b), count, to.at, along);
  const auto on_grid = [](Vec3 p) {
    return Vec3{snapped_to(kWireQuantum_m, p.x), snapped_to(kWireQuantum_m, p.y), snapped_to(kWireQuantum_m, p.z)};
  };
  for (std::size_t i = 0; i < count; ++i)
    wires.push_back({.from = on_grid(a[i]), .to = on_grid(b[i]), .radius_mm = radius_mm, .kind = kind});
}

// The ground below a wire, inside the extent, and the roads and bridges that it crosses.
std::vector<Below> places_below(const SpanPlanner& planner, const Wire& wire) {
  const Vec2 from = in_plan(wire.from), to = in_plan(wire.to);
  const int steps = std::max(1, static_cast<int>(std::ceil(distance(from, to) / kGroundStep_m)));
  std::vector<Below> below;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Vec2 at = from + (to - from) * t;
    if (planner.is_in_extent(at)) below.push_back({t, land_m(planner.around.ground, at), false});
  }
  for (const Crossing& crossing : crossings_of(planner.crossings, from, to)) {
    const Vec2 at = from + (to - from) * crossing.t;
    if (planner.is_in_extent(at))
      below.push_back({crossing.t, crossing.deck_m.value_or(land_m(planner.around.ground, at)), true});
  }
  return below;
}

// The greatest height of a wire above the ground, rounded up.
double greatest_above_m(const SpanPlanner& planner, const std::vector<Wire>& wires) {
  double greatest_m = 0;
  for (const Wire& wire : wires)
    for (const Below& place : places_below(planner, wire))
      greatest_m = std::max(greatest_m, place_on(wire, place.t).z - place.z_m);
  return std::ceil(greatest_m + kAboveMargin_m);
}

// The wires between two supports; `too_low_m` is more than 0 if they cannot hang high enough.
struct PlannedSpan {
  WireSpan span;
  double too_low_m = 0;
};

PlannedSpan span_between(const SpanPlanner& planner, const map::PowerLine& line, const Support& from,
                         const Support& to) {
  constexpr std::size_t kAll = ~std::size_t{0};
  PlannedSpan planned;
  std::vector<Wire>& wires = planned.span.wires;
  if (line.kind == map::PowerLineKind::kAerialway)
    add_straight(wires, from, to, WireKind::kCable, kAll, kCable_mm);
  else
    add_straight(wires, from, to, WireKind::kConductor, line.cables > 0 ? line.cables : kAll, radius_mm_of(line));
  std::vector<std::vector<Below>> below;
  for (const Wire& wire : wires) below.push_back(places_below(planner, wire));
  const double sag_m = sag_m_of(wires, below, distance(from.at, to.at), sag_class_of(line));
  for (std::size_t i = 0; i < wires.size(); ++i) {
    wires[i].sag_m = sag_m;
    planned.too_low_m = std::max(planned.too_low_m, shortfall_m(wires[i], below[i], kLeastOverRoad_m + kRoadMargin_m));
  }
  const std::size_t conductors = wires.size();
  if (conductors > 0) add_straight(wires, from, to, WireKind::kEarthWire, kAll, kEarthWire_mm);
  for (std::size_t i = conductors; i < wires.size(); ++i)
    wires[i].sag_m = std::floor(kEarthWireSag * sag_m / kWireQuantum_m) * kWireQuantum_m;
  planned.span.above_m = greatest_above_m(planner, wires);
  return planned;
}

bool reaches_extent(const SpanPlanner& planner, const Support& from, const Support& to) {
  return planner.features.extent.touches(box_of_segment(from.at, to.at));
}

// The spans of a map while lines are added.
struct SpanList {
  std::vector<WireSpan> spans;
  std::set<std::pair<std::int64_t, std::int64_t>> joined;  // supports that have a span
  Account account;
};

void add_span(const SpanPlanner& planner, const map::PowerLine& line, std::int64_t from, std::int64_t to,
              std::uint32_t number, SpanList& list, Report& report) {
  const Support &a = planner.supports.at(from), &b = planner.supports.at(to);
  const double length_m = distance(a.at, b.at);
  const bool is_new = list.joined.insert(std::minmax(from, to)).second;
  if (!is_new || length_m < kShortestSpan_m || !reaches_extent(planner, a, b)) return;
  const OsmId way = line.id.osm;
  list.account.in += report.counts(way);
  if (length_m > kLongestSpan_m) return report.drop(list.account, Code::kSpanTooLong, way, length_m);
  PlannedSpan planned = span_between(planner, line, a, b);
  if (planned.too_low_m > 0) return report.drop(list.account, Code::kWireTooLow, way, planned.too_low_m);
  if (planned.span.wires.empty()) return report.drop(list.account, Code::kNoPlaceForWire, way, length_m);
  planned.span.id = {way, number};
  list.account.out += report.counts(way);
  list.spans.push_back(std::move(planned.span));
}

void add_line(const SpanPlanner& planner, const map::PowerLine& line, SpanList& list, Report& report) {
  const std::int64_t* last = nullptr;
  for (std::uint32_t i = 0; i < line.node_ids.size(); ++i) {
    const std::int64_t& node = line.node_ids[i];
    if (!planner.supports.contains(node)) {
      if (planner.mapped.contains(node)) last = nullptr;
      continue;
    }
    if (last && *last != node) add_span(planner, line, *last, node, i, list, report);
    last = &node;
  }
}

}  // namespace

std::vector<WireSpan> plan(const map::FeatureView& features, const Surroundings& around, Report& report) {
  if (features.power_lines.empty()) return {};
  const SpanPlanner planner = planner_of(features, around);
  SpanList list;
  for (const map::PowerLine& line : features.power_lines) add_line(planner, line, list, report);
  std::ranges::sort(list.spans, {}, &WireSpan::id);
  report.account("wires", "span") = list.account;
  return std::move(list.spans);
}

}  // namespace citykiln::wires
