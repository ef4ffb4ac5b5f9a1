#include "compiler/roads/pieces/cross_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::roads {
namespace {

// Longest end segment that is joined to the next road by a mitre. Every tile that touches a segment of this length also
// knows the next road. Longer end segments end square, with a joint.
constexpr double kLongestJoined_m = 40;

// Minimum distance between two lines across a segment, at either edge.
constexpr double kLeastSide_m = 0.0625;

struct Reaches {
  double left_m, right_m;
};

// The extent of a line along its segment, measured at the edges from the line's point: least_m <= 0 <= most_m.
struct Lean {
  double least_m, most_m;
};
Lean lean_of(Vec2 out, Vec2 along, Reaches reaches) {
  const double a = dot(out, along) * reaches.left_m, b = -dot(out, along) * reaches.right_m;
  return {std::min(a, b), std::max(a, b)};
}

// State while a road is cut into slices.
struct Slicer {
  const Road& road;
  const StripEnds& ends;
  Reaches reaches;
  double tile_m;
  std::span<const LaneChange> changes;
  std::vector<double> along{};
  std::vector<double> edge_bends{};         // bends of the edges, from width limits and lane changes
  std::vector<std::optional<Vec2>> outs{};  // the mitre at each point, if there is one

  Vec2 direction(std::size_t i) const { return unit(road.axis[i + 1] - road.axis[i]); }
  double length(std::size_t i) const { return distance(road.axis[i], road.axis[i + 1]); }
  std::size_t segments() const { return road.axis.size() - 1; }

  bool is_long_end(std::size_t i) const {
    return (i == 0 && length(0) > kLongestJoined_m) || (i == segments() && length(i - 1) > kLongestJoined_m);
  }

  std::optional<Vec2> mitre_at(std::size_t i) const {
    if (is_long_end(i)) return std::nullopt;
    const Vec2 before = i > 0 ? direction(i - 1) : ends.before ? unit(road.axis.front() - *ends.before) : direction(0);
    const Vec2 after = i < segments() ? direction(i) : ends.after ? unit(*ends.after - road.axis.back()) : before;
    return dot(before, after) > 0 ? std::optional(mitre_of(before, after)) : std::nullopt;
  }

  // The reaches of the line at a point: in a lane change edges lie farther out.
  Reaches reaches_at(std::size_t i) const {
    Reaches all = reaches;
    for (const LaneChange& change : changes) {
      if (change.share_at(along[i]) <= 0) continue;
      all.left_m = std::max(all.left_m, change.offsets_m.front());
      all.right_m = std::max(all.right_m, -change.offsets_m.back());
    }
    return all;
  }

  // A mitre may lean over at most half of either segment, so no two mitres cross.
  void find_outs() {
    for (std::size_t i = 0; i < road.axis.size(); ++i) {
      outs.push_back(mitre_at(i));
      for (const std::size_t s : {i - 1, i}) {
        if (!outs[i] || s >= segments()) continue;
        const Lean lean = lean_of(*outs[i], direction(s), reaches_at(i));
        if (std::max(-lean.least_m, lean.most_m) > (length(s) - kLeastSide_m) / 2) outs[i].reset();
      }
    }
  }

  // The line at point i, as one of its two segments uses it.
  CrossLine line_at(std::size_t i, std::size_t segment) const {
    return {road.axis[i], outs[i].value_or(left_of(direction(segment))), along[i]};
  }
};

// Adds the distances at which the strip about a segment enters and leaves the one-metre margin of a tile border, for
// one coordinate.
void add_borders(const Slicer& slicer, std::size_t segment, double Vec2::*axis, std::vector<double>& lines) {
  constexpr double kNear_m = 1;
  const Vec2 a = slicer.road.axis[segment], b = slicer.road.axis[segment + 1], out = left_of(slicer.direction(segment));
  const double per_metre = slicer.direction(segment).*axis;
  if (std::abs(per_metre) < 0x1p-10) return;
  const double left = out.*axis * slicer.reaches.left_m, right = -(out.*axis) * slicer.reaches.right_m;
  const double low = std::min(left, right) - kNear_m, high = std::max(left, right) + kNear_m;
  const double first = std::floor((std::min(a.*axis, b.*axis) + low) / slicer.tile_m) + 1;
  for (double k = first; k * slicer.tile_m <= std::max(a.*axis, b.*axis) + high; ++k)
    for (const double edge : {low, high})
      lines.push_back(slicer.along[segment] + (k * slicer.tile_m - edge - a.*axis) / per_metre);
}

// The distances of lines inside a segment, clear of the lines at its ends. Tile borders come first: every tile knows
// them, so all tiles drop the same lines.
std::vector<double> lines_within(const Slicer& slicer, std::span<const RoadStretch> stretches, std::size_t segment) {
  std::vector<double> wanted, lines;
  add_borders(slicer, segment, &Vec2::x, wanted);
  add_borders(slicer, segment, &Vec2::y, wanted);
  std::sort(wanted.begin(), wanted.end());
  for (const RoadStretch& run : stretches) wanted.push_back(run.from_m);
  wanted.insert(wanted.end(), slicer.edge_bends.begin(), slicer.edge_bends.end());
  const Vec2 direction = slicer.direction(segment);
  const double from = slicer.along[segment] + kLeastSide_m +
                      lean_of(slicer.line_at(segment, segment).out, direction, slicer.reaches).most_m;
  const double to = slicer.along[segment + 1] - kLeastSide_m +
                    lean_of(slicer.line_at(segment + 1, segment).out, direction, slicer.reaches).least_m;
  for (std::size_t w = 0; w < wanted.size(); ++w) {
    const auto is_close = [&](double line) { return std::abs(line - wanted[w]) < kLeastSide_m; };
    if (wanted[w] > from && wanted[w] < to && std::ranges::none_of(lines, is_close)) lines.push_back(wanted[w]);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

// The index of the stretch at a distance.
std::uint32_t stretch_at(std::span<const RoadStretch> stretches, double along_m) {
  const auto after = std::ranges::upper_bound(stretches, along_m, {}, &RoadStretch::from_m);
  return after == stretches.begin() ? 0 : static_cast<std::uint32_t>(after - stretches.begin()) - 1;
}

CrossLine cross_line_between(const Slicer& slicer, std::size_t segment, double along_m) {
  const Vec2 a = slicer.road.axis[segment], b = slicer.road.axis[segment + 1];
  const double share = (along_m - slicer.along[segment]) / (slicer.along[segment + 1] - slicer.along[segment]);
  return {a + (b - a) * share, left_of(slicer.direction(segment)), along_m};
}

void slice_segment(const Slicer& slicer, std::span<const RoadStretch> stretches, std::size_t segment,
                   std::vector<Slice>& slices) {
  CrossLine start = slicer.line_at(segment, segment);
  const auto push = [&](const CrossLine& end) {
    const double middle = (start.along_m + end.along_m) / 2;
    slices.push_back(
        {.along = slicer.direction(segment), .start = start, .end = end, .stretch = stretch_at(stretches, middle)});
    start = end;
  };
  for (const double along_m : lines_within(slicer, stretches, segment))
    push(cross_line_between(slicer, segment, along_m));
  push(slicer.line_at(segment + 1, segment));
}

}  // namespace

Slices slices_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches, double left_m,
                 double right_m, std::span<const LaneChange> changes, double tile_m) {
  assert(road.axis.size() >= 2 && tile_m > 0);
  assert(left_m >= 0 && right_m >= 0);
  Slicer slicer{road, ends, {left_m, right_m}, tile_m, changes, distances_along(road), bends_of_edges(road)};
  for (const LaneChange& change : changes) slicer.edge_bends.push_back(change.cut_m);
  slicer.find_outs();
  Slices all;
  for (std::size_t s = 0; s < slicer.segments(); ++s) {
    if (s == 0 && !slicer.outs[0] && ends.before)
      all.bends.push_back(
          {.at = road.axis[0], .before = unit(road.axis[0] - *ends.before), .after = slicer.direction(0)});
    slice_segment(slicer, stretches, s, all.slices);
    if (slicer.outs[s + 1]) continue;
    const auto last = static_cast<std::uint32_t>(all.slices.size()) - 1;
    if (s + 1 < slicer.segments())
      all.bends.push_back(
          {.at = road.axis[s + 1], .before = slicer.direction(s), .after = slicer.direction(s + 1), .slice = last});
    else if (ends.after)
      all.bends.push_back({.at = road.axis.back(),
                           .before = slicer.direction(s),
                           .after = unit(*ends.after - road.axis.back()),
                           .slice = last});
  }
  return all;
}

}  // namespace citykiln::roads
