#include "compiler/roads/trim.h"

#include <algorithm>
#include <cassert>

namespace citykiln::roads {
namespace {

// The points [first, last] of an axis.
struct Run {
  std::size_t first, last;
};

std::vector<Run> runs_near(const Polyline& axis, const Box2& reach) {
  std::vector<Run> runs;
  bool continues = false;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const bool touches = box_of_segment(axis[i], axis[i + 1]).touches(reach);
    if (touches && !continues) runs.push_back({i, i});
    if (touches) runs.back().last = i + 1;
    continues = touches;
  }
  return runs;
}

bool touches(const Polyline& axis, std::size_t segment, const Box2& box) {
  return box_of_segment(axis[segment], axis[segment + 1]).touches(box);
}

// Merges runs that share a segment.
std::vector<Run> joined(const std::vector<Run>& runs) {
  std::vector<Run> all;
  for (const Run run : runs) {
    if (!all.empty() && run.first < all.back().last)
      all.back().last = run.last;
    else
      all.push_back(run);
  }
  return all;
}

// Extends a run by one segment at each end whose segment touches the box: mitres there depend on the next segment.
std::vector<Run> with_neighbours(const Polyline& axis, std::vector<Run> runs, const Box2& box) {
  for (Run& run : runs) {
    const bool more_before = run.first > 0 && touches(axis, run.first, box);
    const bool more_after = run.last + 1 < axis.size() && touches(axis, run.last - 1, box);
    if (more_before) --run.first;
    if (more_after) ++run.last;
  }
  return joined(runs);
}

Polyline part_of(const Polyline& axis, Run run) {
  return {axis.begin() + static_cast<std::ptrdiff_t>(run.first),
          axis.begin() + static_cast<std::ptrdiff_t>(run.last) + 1};
}

// Keeps the limits along the run and the nearest one on either side: limits in between depend on both.
std::vector<WidthLimit> limits_between(const std::vector<WidthLimit>& width_limits, double from_m, double to_m) {
  auto first = std::ranges::lower_bound(width_limits, from_m, {}, &WidthLimit::at_m);
  auto last = std::ranges::upper_bound(width_limits, to_m, {}, &WidthLimit::at_m);
  if (first != width_limits.begin()) --first;
  if (last != width_limits.end()) ++last;
  std::vector<WidthLimit> kept(first, last);
  if (!kept.empty()) kept.front().is_wall = false;
  return kept;
}

// The run of a road or strip, without what roads have besides. @param along  distances_along() of the whole.
template <typename Way>
Way part_of(const Way& whole, const std::vector<double>& along, Run run) {
  Way part = whole;
  part.axis = part_of(whole.axis, run);
  part.start_along_m = along[run.first];
  const auto knots = between(whole.profile, along[run.first], along[run.last]);
  part.profile.assign(knots.begin(), knots.end());
  return part;
}

Road part_of(const Road& road, Run run) {
  const std::vector<double> along = distances_along(road);
  Road part = part_of(road, along, run);
  part.width_limits = {limits_between(road.width_limits.left, along[run.first], along[run.last]),
                       limits_between(road.width_limits.right, along[run.first], along[run.last])};
  std::erase_if(part.points, [&](const map::TrackPoint& p) { return p.vertex < run.first || p.vertex > run.last; });
  for (map::TrackPoint& p : part.points) p.vertex -= static_cast<std::uint32_t>(run.first);
  return part;
}

}  // namespace

std::vector<Road> trimmed_to(const Road& road, const Box2& box, double halo_m) {
  assert(road.axis.size() >= 2 && halo_m >= 0);
  // ground cells read one metre beyond their border
  const Box2 near = box.widened(max_offset_m(road) + 1);
  std::vector<Road> parts;
  for (const Run run : with_neighbours(road.axis, runs_near(road.axis, near.widened(halo_m)), near))
    parts.push_back(part_of(road, run));
  return parts;
}

std::vector<Strip> trimmed_to(const Strip& strip, const Box2& box, double halo_m) {
  assert(strip.axis.size() >= 2 && halo_m >= 0);
  std::vector<Strip> parts;
  for (const Run run :
       runs_near(strip.axis, box.widened(strip.left_m + strip.right_m + strip.influence_radius_m + halo_m)))
    parts.push_back(part_of(strip, distances_along(strip.axis, strip.start_along_m), run));
  return parts;
}

}  // namespace citykiln::roads
