#include "compiler/roads/pieces/stretches.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace citykiln::roads {
namespace {

using map::TrackPointKind;

constexpr double kLeastApproach_m = 3;
// Distances from the crossing to the stop line before it, and from the junction to the crossing.
constexpr double kBeforeCrossing_m = 1, kBehindCrossing_m = 0.5;
// A crossing up to this far beyond a junction belongs to it and moves to its mouth.
constexpr double kNearJunction_m = 6;
// Half the length of rails that a level crossing covers if no way on the ground has its node.
constexpr double kHalfLevelCrossing_m = 4.5;

double half_level_crossing_m(const map::TrackPoint& point) {
  return point.reach_quarters > 0 ? point.reach_quarters / 4.0 : kHalfLevelCrossing_m;
}

std::optional<StretchKind> crossing_of(TrackPointKind kind) {
  if (kind == TrackPointKind::kZebra) return StretchKind::kZebra;
  if (kind == TrackPointKind::kCrossing) return StretchKind::kCrossing;
  return std::nullopt;
}

std::optional<StretchKind> hump_of(TrackPointKind kind) {
  if (kind == TrackPointKind::kHump) return StretchKind::kHump;
  if (kind == TrackPointKind::kSpeedTable) return StretchKind::kSpeedTable;
  if (kind == TrackPointKind::kSpeedCushions) return StretchKind::kSpeedCushions;
  return std::nullopt;
}

// State while a road is cut into stretches. Distances are along the way.
struct StretchBuilder {
  const Road& road;
  std::span<const JunctionInterval> intervals;
  double tile_m;
  std::vector<double> along;
  std::vector<RoadStretch> special{};
  std::vector<bool> is_used{};  // whether a junction's approach uses the track point

  double first() const { return along.front(); }
  double last() const { return along.back(); }
};

// The box of the axis between two distances.
Box2 box_between(const StretchBuilder& builder, double from_m, double to_m) {
  Box2 box;
  const auto& axis = builder.road.axis;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const double length = builder.along[i + 1] - builder.along[i];
    const double s = std::max(from_m, builder.along[i]), t = std::min(to_m, builder.along[i + 1]);
    if (s > t) continue;
    for (const double at : {s, t})
      box.grow(axis[i] + (axis[i + 1] - axis[i]) * (length > 0 ? (at - builder.along[i]) / length : 0));
  }
  return box;
}

// True where every tile that the run touches knows all that it depends on, so that all of them decide alike.
bool is_agreed(const StretchBuilder& builder, double run_from_m, double run_to_m, double known_from_m,
               double known_to_m) {
  // ground cells read one metre beyond their border
  const Box2 run = box_between(builder, run_from_m, run_to_m).widened(max_offset_m(builder.road) + 1);
  const Box2 needed = box_between(builder, known_from_m, known_to_m);
  const auto number = [&](double v) { return std::floor(v / builder.tile_m); };
  if (number(run.min.x) == number(run.max.x) && number(run.min.y) == number(run.max.y)) return true;
  for (double x = number(run.min.x); x <= number(run.max.x); ++x)
    for (double y = number(run.min.y); y <= number(run.max.y); ++y) {
      const Vec2 corner{x * builder.tile_m, y * builder.tile_m};
      const Box2 known = Box2{corner, corner + Vec2{builder.tile_m, builder.tile_m}}.widened(kJunctionHalo_m);
      if (!known.contains(needed.min) || !known.contains(needed.max)) return false;
    }
  return true;
}

// The crossing nearest to the junction's mouth on one side of it.
std::optional<std::size_t> crossing_near(const StretchBuilder& builder, double at_m, double mouth_m, int step) {
  std::optional<std::size_t> nearest;
  const auto out_m = [&](std::size_t i) { return (builder.along[builder.road.points[i].vertex] - at_m) * step; };
  for (std::size_t i = 0; i < builder.road.points.size(); ++i) {
    if (!crossing_of(builder.road.points[i].kind) || out_m(i) <= 0 || out_m(i) > mouth_m + kNearJunction_m) continue;
    if (!nearest || out_m(i) < out_m(*nearest)) nearest = i;
  }
  return nearest;
}

// The length available to an arm's approach: half the way to the next junction, up to the next change of width, or to
// the end of the road.
double room_m(const StretchBuilder& builder, std::size_t gap, int step) {
  const double at = builder.intervals[gap].at_m;
  const bool is_last = step > 0 ? gap + 1 == builder.intervals.size() : gap == 0;
  if (is_last) return step > 0 ? builder.last() - at : at - builder.first();
  const JunctionInterval& next = builder.intervals[step > 0 ? gap + 1 : gap - 1];
  const double there = std::abs(next.at_m - at);
  return next.is_change ? there - (step > 0 ? next.before_m : next.after_m) : there / 2;
}

// The distances of an approach's parts from the junction's node, outwards.
struct Approach {
  double mouth_m, crossing_m, line_m, end_m;
};

void add_run(StretchBuilder& builder, double at_m, int step, double from_m, double to_m, RoadStretch run) {
  run.from_m = step > 0 ? at_m + from_m : at_m - to_m;
  run.to_m = step > 0 ? at_m + to_m : at_m - from_m;
  if (run.stretch == StretchKind::kStart || run.stretch == StretchKind::kZebra || run.stretch == StretchKind::kCrossing)
    run.zero_m = run.from_m;
  if (run.stretch == StretchKind::kEnd) run.zero_m = run.to_m - kLayoutLength_m;
  builder.special.push_back(run);
}

void add_approach(StretchBuilder& builder, std::size_t g, int step) {
  const JunctionInterval& gap = builder.intervals[g];
  const double mouth = step > 0 ? gap.after_m : gap.before_m, room = room_m(builder, g, step);
  if (mouth <= 0 || gap.is_change) return;
  Approach approach{mouth, mouth, mouth, 0};
  const auto crossing = crossing_near(builder, gap.at_m, mouth, step);
  if (crossing) {
    approach.crossing_m = mouth + kBehindCrossing_m;
    approach.line_m = approach.crossing_m + kCrossingLength_m + kBeforeCrossing_m;
  }
  approach.end_m = std::min(room, approach.line_m + kLayoutLength_m);
  if (approach.end_m < approach.line_m + kLeastApproach_m) return;
  // the next junction's approach may take half of the length needed
  const double needed = 2 * (approach.line_m + kLayoutLength_m);
  const auto along = [&](double out_m) { return gap.at_m + step * out_m; };
  const auto [run_from, run_to] = std::minmax({along(approach.mouth_m), along(approach.end_m)});
  const auto [known_from, known_to] = std::minmax({along(0), along(needed)});
  if (!is_agreed(builder, run_from, run_to, known_from, known_to)) return;
  if (crossing) {
    builder.is_used[*crossing] = true;
    add_run(builder, gap.at_m, step, approach.crossing_m, approach.crossing_m + kCrossingLength_m,
            {.stretch = *crossing_of(builder.road.points[*crossing].kind),
             .traits = builder.road.points[*crossing].traits});
  }
  add_run(builder, gap.at_m, step, approach.line_m, approach.end_m,
          {0, 0, step > 0 ? StretchKind::kStart : StretchKind::kEnd, step > 0 ? gap.after : gap.before});
}

bool overlaps(const RoadStretch& a, const RoadStretch& b) { return a.from_m < b.to_m && b.from_m < a.to_m; }

// Adds crossings and humps away from junctions, and level crossings on rails. Crossings come first: a hump on one is
// not drawn.
void add_midway(StretchBuilder& builder, std::optional<StretchKind> (*across_of)(TrackPointKind)) {
  for (std::size_t i = 0; i < builder.road.points.size(); ++i) {
    const map::TrackPoint& point = builder.road.points[i];
    const bool is_street = family_of(builder.road.surface) == Family::kStreet;
    const bool is_rail = map::values_of(builder.road.surface).group == map::LandCoverGroup::kRail;
    const bool is_level = is_rail && point.kind == TrackPointKind::kLevelCrossing;
    const auto crossing = across_of(point.kind);
    if (builder.is_used[i] || (!crossing && !is_level) || (crossing && !is_street)) continue;
    const double half = is_level ? half_level_crossing_m(point) : kCrossingLength_m / 2,
                 at = builder.along[point.vertex];
    RoadStretch run{at - half, at + half, is_level ? StretchKind::kLevelCrossing : *crossing};
    run.zero_m = run.from_m, run.traits = point.traits;
    if (is_level) run.from_m = std::max(run.from_m, builder.first()), run.to_m = std::min(run.to_m, builder.last());
    const bool fits = run.from_m >= builder.first() && run.to_m <= builder.last();
    const bool is_free = std::ranges::none_of(builder.special, [&](const auto& other) { return overlaps(run, other); });
    if (fits && is_free && is_agreed(builder, run.from_m, run.to_m, run.from_m - 8, run.to_m + 8))
      builder.special.push_back(run);
  }
}

}  // namespace

std::vector<RoadStretch> stretches_of(const Road& road, std::span<const JunctionInterval> intervals, double tile_m) {
  assert(road.axis.size() >= 2 && tile_m > 0);
  assert(std::ranges::is_sorted(intervals, {}, &JunctionInterval::at_m));
  StretchBuilder builder{road, intervals, tile_m, distances_along(road)};
  builder.is_used.assign(road.points.size(), false);
  for (std::size_t g = 0; g < intervals.size(); ++g) {
    add_approach(builder, g, -1);
    add_approach(builder, g, 1);
  }
  add_midway(builder, crossing_of);
  add_midway(builder, hump_of);
  std::ranges::sort(builder.special, {}, &RoadStretch::from_m);
  std::vector<RoadStretch> runs;
  double at = builder.first();
  const auto go_along = [&](double to_m) {
    if (to_m > at) runs.push_back({at, to_m});
    at = std::max(at, to_m);
  };
  for (const RoadStretch& run : builder.special) {
    // a junction may cover another's approach
    if (run.from_m < at || run.to_m > builder.last()) continue;
    go_along(run.from_m);
    runs.push_back(run);
    at = run.to_m;
  }
  go_along(builder.last());
  return runs;
}

std::vector<RoadStretch> cut_stretches(std::span<const RoadStretch> stretches, std::vector<double> at_m,
                                       bool (*may_cut)(const RoadStretch&)) {
  std::ranges::sort(at_m);
  std::vector<RoadStretch> cut;
  for (RoadStretch stretch : stretches) {
    const double to_m = stretch.to_m;
    for (const double here_m : at_m) {
      if (!may_cut(stretch) || here_m <= stretch.from_m || here_m >= to_m) continue;
      stretch.to_m = here_m;
      cut.push_back(stretch);
      stretch.from_m = here_m, stretch.to_m = to_m;
    }
    cut.push_back(stretch);
  }
  return cut;
}

}  // namespace citykiln::roads
