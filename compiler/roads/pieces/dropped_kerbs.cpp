#include "compiler/roads/pieces/dropped_kerbs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/geometry/line_part.h"
#include "compiler/roads/pieces/lane_strips.h"
#include "compiler/roads/pieces/tactile_paving.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::roads {
namespace {

constexpr std::uint8_t kAnyMappedKerb = map::kLoweredKerb | map::kFlushKerb | map::kRaisedKerb;

bool is_dropped(const RoadStretch& stretch) { return (stretch.traits & (map::kLoweredKerb | map::kFlushKerb)) != 0; }

bool is_painted_crossing(const RoadStretch& stretch) {
  return stretch.stretch == StretchKind::kZebra || stretch.stretch == StretchKind::kCrossing;
}

// Completes what is mapped by what is usual.
std::uint8_t with_usual_traits(std::uint8_t traits, map::CountryGroup country, StretchKind stretch) {
  if ((traits & kAnyMappedKerb) == 0) traits |= map::kLoweredKerb;
  const bool is_open = (traits & (map::kTactileSlabs | map::kNoTactileSlabs)) == 0;
  if (is_open && is_tactile_usual(country, stretch)) traits |= map::kTactileSlabs;
  return traits;
}

// Replaces a part of a stretch by copies of it, of which `change` alters the middle one.
template <typename Change>
void cut_out(std::vector<RoadStretch>& stretches, double from_m, double to_m, Change change) {
  const auto about =
      std::ranges::find_if(stretches, [&](const RoadStretch& s) { return s.from_m <= from_m && to_m <= s.to_m; });
  if (about == stretches.end() || is_painted_crossing(*about)) return;
  const RoadStretch whole = *about;
  const auto place = stretches.erase(about);
  std::vector<RoadStretch> parts;
  for (const auto& [a_m, b_m] : {std::pair{whole.from_m, from_m}, {from_m, to_m}, {to_m, whole.to_m}}) {
    if (b_m <= a_m) continue;
    parts.push_back(whole);
    parts.back().from_m = a_m, parts.back().to_m = b_m;
    if (a_m == from_m && b_m == to_m) change(parts.back());
  }
  stretches.insert(place, parts.begin(), parts.end());
}

bool is_in_junction(std::span<const JunctionInterval> intervals, double from_m, double to_m) {
  return std::ranges::any_of(intervals, [&](const JunctionInterval& each) {
    return from_m < each.at_m + each.after_m && to_m > each.at_m - each.before_m;
  });
}

void add_plain_crossings(const Road& road, std::span<const JunctionInterval> intervals, bool assumes,
                         std::vector<RoadStretch>& stretches) {
  std::vector<double> along;
  for (const map::TrackPoint& point : road.points) {
    if (point.kind != map::TrackPointKind::kPlainCrossing) continue;
    if (along.empty()) along = distances_along(road);
    const double from_m = along[point.vertex] - kPlainCrossing_m / 2, to_m = from_m + kPlainCrossing_m;
    if (is_in_junction(intervals, from_m - kKerbRamp_m, to_m + kKerbRamp_m)) continue;
    cut_out(stretches, from_m, to_m, [&](RoadStretch& middle) {
      middle.traits = assumes ? with_usual_traits(point.traits, road.country, StretchKind::kAlong) : point.traits;
    });
  }
}

std::vector<RoadStretch> cut_at_ramps(const std::vector<RoadStretch>& stretches) {
  std::vector<double> ends_m;
  for (const RoadStretch& stretch : stretches)
    if (is_dropped(stretch))
      for (const double end_m : {stretch.from_m - kKerbRamp_m, stretch.to_m + kKerbRamp_m}) ends_m.push_back(end_m);
  return cut_stretches(stretches, std::move(ends_m), [](const RoadStretch& s) { return !is_dropped(s); });
}

// The ramp of one side, from the edges of the road in the middle of a crossing.
void add_side(Vec2 at, Vec2 along, const RoadEdges& edges, bool is_left, KerbRamp ramp, std::vector<KerbRamp>& ramps) {
  const double kerb_m = is_left ? edges.kerb_left_m : edges.kerb_right_m,
               outer_m = is_left ? edges.left_m : edges.right_m;
  if (outer_m - kerb_m <= kKerb_m) return;
  ramp.along = along, ramp.outward = left_of(along) * (is_left ? 1.0 : -1.0);
  ramp.at = at + ramp.outward * kerb_m, ramp.reach_m = outer_m - kerb_m;
  ramps.push_back(ramp);
}

double ramp_reach_m(const KerbRamp& ramp) { return ramp.half_m + kKerbRamp_m + ramp.reach_m + 2; }

double share_outside(double from_m, double length_m, double at_m) {
  return std::clamp(1 - (at_m - from_m) / length_m, 0.0, 1.0);
}

// 1 where the kerb is low, 0 where ramps end. Islands between the kerbs are not lowered.
double share_at(const KerbRamp& ramp, Vec2 p) {
  constexpr double kIslands_m = 1.5;
  const Vec2 off = p - ramp.at;
  const double out_m = dot(off, ramp.outward);
  if (out_m < -kIslands_m || out_m >= ramp.reach_m) return 0;
  return share_outside(ramp.half_m, kKerbRamp_m, std::abs(dot(off, ramp.along))) *
         share_outside(kKerb_m, ramp.reach_m - kKerb_m, out_m);
}

}  // namespace

std::vector<RoadStretch> with_dropped_kerbs(const Road& road, std::vector<RoadStretch> stretches,
                                            std::span<const JunctionInterval> intervals, bool assumes) {
  if (!map::is_street(road.surface) || road.points.empty()) return stretches;
  if (raised_left_m(road) == 0 && raised_right_m(road) == 0) return stretches;
  for (RoadStretch& stretch : stretches)
    if (assumes && is_painted_crossing(stretch))
      stretch.traits = with_usual_traits(stretch.traits, road.country, stretch.stretch);
  add_plain_crossings(road, intervals, assumes, stretches);
  return cut_at_ramps(stretches);
}

void add_kerb_ramps(const Road& road, std::span<const RoadStretch> stretches, std::vector<KerbRamp>& ramps) {
  std::vector<double> along;
  for (const RoadStretch& stretch : stretches) {
    if (!is_dropped(stretch)) continue;
    if (along.empty()) along = distances_along(road);
    const double middle_m = (stretch.from_m + stretch.to_m) / 2;
    const Vec2 a = point_at(road.axis, along, stretch.from_m), b = point_at(road.axis, along, stretch.to_m);
    if (a == b) continue;
    const KerbRamp ramp{.at = {},
                        .along = {},
                        .outward = {},
                        .half_m = (stretch.to_m - stretch.from_m) / 2,
                        .lip_m = (stretch.traits & map::kFlushKerb) != 0 ? 0 : kKerbLip_m};
    const RoadEdges edges = road_edges_at(road, middle_m);
    for (const bool is_left : {true, false}) add_side((a + b) * 0.5, unit(b - a), edges, is_left, ramp, ramps);
  }
}

std::vector<KerbRamp> kerb_ramps_of(std::span<const Road> roads, std::span<const Junction> junctions, double tile_m,
                                    bool assumes) {
  std::vector<KerbRamp> ramps;
  const std::vector<std::vector<JunctionInterval>> intervals = junction_intervals_of(roads, junctions);
  for (std::size_t i = 0; i < roads.size(); ++i)
    if (!roads[i].points.empty())
      add_kerb_ramps(roads[i],
                     with_dropped_kerbs(roads[i], stretches_of(roads[i], intervals[i], tile_m), intervals[i], assumes),
                     ramps);
  return ramps;
}

KerbRampIndex index_kerb_ramps(std::vector<KerbRamp> ramps) {
  constexpr double kBucket_m = 16;
  std::vector<Box2> boxes;
  for (const KerbRamp& ramp : ramps) boxes.push_back(Box2{ramp.at, ramp.at}.widened(ramp_reach_m(ramp)));
  return {std::move(ramps), grid_of(boxes, kBucket_m)};
}

double dropped_m(const KerbRampIndex& index, Vec2 p, double kerb_m) {
  double most_m = 0;
  for (const std::uint32_t i : boxes_about(index.grid, p)) {
    const KerbRamp& ramp = index.ramps[i];
    most_m = std::max(most_m, share_at(ramp, p) * std::max(0.0, kerb_m - ramp.lip_m));
  }
  return most_m;
}

}  // namespace citykiln::roads
