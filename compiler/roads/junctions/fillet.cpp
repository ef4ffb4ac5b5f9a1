#include "compiler/roads/junctions/fillet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "compiler/geometry/segment.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {
namespace {

// A segment of an axis, offset sideways.
struct OffsetSegment {
  Vec2 from, to;
  Vec2 axis_from, along;  // its start on the axis, and its unit direction
  double before_m = 0;    // length of the axis before axis_from
  double length_m = 0;
  std::size_t segment = 0;
};

// Offsets the axis by `off_m` to the left (to the right where negative) with mitred bends, up to the first bend of more
// than a right angle. Segments that the inside of a bend reverses are left out.
std::vector<OffsetSegment> offset_axis(const Polyline& axis, double off_m) {
  std::vector<OffsetSegment> stretches;
  double before_m = 0;
  Vec2 from = axis[0] + left_of(unit(axis[1] - axis[0])) * off_m;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const Vec2 along = unit(axis[i + 1] - axis[i]);
    const Vec2 after = i + 2 < axis.size() ? unit(axis[i + 2] - axis[i + 1]) : along;
    const double length_m = distance(axis[i], axis[i + 1]);
    const bool is_last = dot(along, after) <= 0;
    const Vec2 off = is_last ? left_of(along) : mitre_of(along, after);
    const Vec2 to = axis[i + 1] + off * off_m;
    if (dot(to - from, along) > 0) stretches.push_back({from, to, axis[i], along, before_m, length_m, i});
    if (is_last) break;
    from = to;
    before_m += length_m;
  }
  return stretches;
}

TangentPoint touch_at(const OffsetSegment& stretch, Vec2 centre, double off_m) {
  const double along_m = std::min(dot(centre - stretch.axis_from, stretch.along), stretch.length_m);
  return {stretch.axis_from + stretch.along * along_m + left_of(stretch.along) * off_m, stretch.before_m + along_m,
          stretch.segment};
}

std::optional<Vec2> meeting(const OffsetSegment& a, const OffsetSegment& b) {
  const Vec2 u = a.to - a.from, v = b.to - b.from, gap = b.from - a.from;
  const double det = cross(u, v);
  // kerbs that cross in the other direction meet again behind an island
  if (det <= 0) return std::nullopt;
  const double s = cross(gap, v) / det, t = cross(gap, u) / det;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return a.from + u * s;
}

// Extends a kerb backwards beyond its node: a wide road that ends on a narrow one at an obtuse angle meets its kerb
// there.
void begin_earlier(std::vector<OffsetSegment>& stretches, double by_m) {
  if (stretches.empty() || stretches.front().segment != 0) return;
  stretches.front().from = stretches.front().from - stretches.front().along * by_m;
}

bool is_obtuse(const ArmPath& arm, const ArmPath& next) {
  constexpr double kStraightCosine = -0.94;
  const Vec2 a = unit(arm.axis[1] - arm.axis[0]), b = unit(next.axis[1] - next.axis[0]);
  return cross(a, b) > 0 && dot(a, b) < 0 && dot(a, b) > kStraightCosine;
}

}  // namespace

ArmPath arm_path(std::span<const Road> roads, const Arm& arm) {
  Polyline axis = arm_axis(roads, arm, kJunctionRadius_m);
  // arm_axis() repeats a vertex that lies exactly at the length
  if (axis.size() > 2 && axis.back() == axis[axis.size() - 2]) axis.pop_back();
  return {std::move(axis), arm_left_m(roads, arm), arm_right_m(roads, arm), roads[arm.road].section.axis_drift};
}

std::optional<Fillet> fillet_between(const ArmPath& arm, const ArmPath& next, double radius_m) {
  assert(arm.axis.size() >= 2 && next.axis.size() >= 2);
  assert(radius_m >= 0);
  constexpr double kClear_m = 0.02;
  const double off = arm.left_m + radius_m, off_next = next.right_m + radius_m;
  std::vector<OffsetSegment> left = offset_axis(arm.axis, off), right = offset_axis(next.axis, -off_next);
  if (is_obtuse(arm, next)) begin_earlier(left, arm.left_m), begin_earlier(right, next.right_m);
  std::optional<Fillet> nearest;
  for (const OffsetSegment& a : left)
    for (const OffsetSegment& b : right) {
      const auto centre = meeting(a, b);
      if (!centre) continue;
      const Fillet found{*centre, radius_m, touch_at(a, *centre, arm.left_m), touch_at(b, *centre, -next.right_m)};
      if (nearest && found.arm.along_m + found.next.along_m >= nearest->arm.along_m + nearest->next.along_m) continue;
      if (distance_to_polyline(arm.axis, *centre) < off - kClear_m ||
          distance_to_polyline(next.axis, *centre) < off_next - kClear_m)
        continue;
      nearest = found;
    }
  return nearest;
}

std::optional<Fillet> largest_fillet(const ArmPath& arm, const ArmPath& next, double wanted_radius_m,
                                     const FilletLimits& limits) {
  assert(wanted_radius_m >= 0);
  const auto fitting = [&](double radius_m) {
    auto fillet = fillet_between(arm, next, radius_m);
    if (fillet && (fillet->arm.along_m > limits.along_arm_m || fillet->next.along_m > limits.along_next_m))
      fillet.reset();
    return fillet;
  };
  if (auto wanted = fitting(wanted_radius_m)) return wanted;
  std::optional<Fillet> best = fitting(0);
  constexpr double kSteps = 2;  // steps per metre
  double low = 0, high = std::ceil(wanted_radius_m * kSteps);
  while (low + 1 < high) {
    const double middle = std::floor((low + high) / 2);
    if (auto fillet = fitting(middle / kSteps)) {
      best = fillet, low = middle;
    } else {
      high = middle;
    }
  }
  return best;
}

}  // namespace citykiln::roads
