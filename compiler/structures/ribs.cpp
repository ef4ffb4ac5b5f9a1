#include "compiler/structures/ribs.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::structures {
namespace {

// A mitre is at most this many times as long as half the width; sharper bends are bevelled.
constexpr double kMaxMitre = 2;

// Ribs are at least this far apart: nearer knots of the profile are ignored.
constexpr double kMinRibSpacing_m = 0.25;

// The bisector of two directions, scaled to reach the edges of both strips. If the bend is walked in the opposite
// direction it is the same line, bit for bit.
Vec2 mitre(Vec2 before, Vec2 after) {
  const Vec2 middle = unit(before + after);
  // the axis turns back by 180 degrees
  if (middle == Vec2{}) return left_of(before);
  const double cos = (dot(middle, before) + dot(middle, after)) / 2;
  return left_of(middle) * std::min(1 / std::max(cos, 1e-9), kMaxMitre);
}

// A span that ends square to the road on the ground has the same edges as that road there.
Vec2 out_of_end(const SpanEnd& end, Vec2 at, Vec2 own, bool is_begin) {
  const Vec2 beyond = unit(is_begin ? at - end.beyond : end.beyond - at);
  switch (end.kind) {
    case EndKind::kJoint:
      return is_begin ? mitre(beyond, own) : mitre(own, beyond);
    case EndKind::kGround:
      return left_of(dot(beyond, own) * kMaxMitre >= 1 ? beyond : own);
    default:
      return left_of(own);
  }
}

struct Axis {
  const Span& span;
  std::vector<double> along_m;

  Vec2 direction(std::size_t segment) const { return unit(span.axis[segment + 1] - span.axis[segment]); }
  std::size_t last() const { return span.axis.size() - 1; }

  Rib rib(Vec2 at, Vec2 out, double at_m) const {
    if (span.profile.empty()) return {at, out, 0, 0, at_m};
    const Knot knot = knot_at(span.profile, at_m);
    return {at, out, knot.z_m, knot.tilt, at_m};
  }
  Rib at_vertex(std::size_t i) const {
    Vec2 out;
    if (i == 0)
      out = out_of_end(span.from, span.axis[0], direction(0), true);
    else if (i == last())
      out = out_of_end(span.to, span.axis[i], direction(i - 1), false);
    else
      out = mitre(direction(i - 1), direction(i));
    return rib(span.axis[i], out, along_m[i]);
  }
  Rib within(std::size_t segment, double at_m) const {
    return rib(span.axis[segment] + direction(segment) * (at_m - along_m[segment]), left_of(direction(segment)), at_m);
  }
  std::size_t segment_at(double at_m) const {
    const auto next = std::ranges::upper_bound(along_m, at_m) - along_m.begin();
    return std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - 1, 0)), last() - 1);
  }
};

std::vector<Rib> all_ribs(const Axis& axis) {
  std::vector<Rib> ribs;
  for (std::size_t i = 0; i <= axis.last(); ++i) {
    ribs.push_back(axis.at_vertex(i));
    if (i == axis.last()) break;
    for (const Knot& knot : axis.span.profile)
      if (knot.at_m > axis.along_m[i] + kMinRibSpacing_m && knot.at_m < axis.along_m[i + 1] - kMinRibSpacing_m)
        ribs.push_back(axis.within(i, knot.at_m));
  }
  return ribs;
}

// Removes what lies on a road that passes an end.
void cut_ends(const Axis& axis, std::vector<Rib>& ribs) {
  const Span& span = axis.span;
  const double from_m = axis.along_m.front() + span.from.cut_m, to_m = axis.along_m.back() - span.to.cut_m;
  if (span.from.cut_m > 0) {
    std::erase_if(ribs, [&](const Rib& rib) { return rib.along_m < from_m + kMinRibSpacing_m; });
    ribs.insert(ribs.begin(), axis.within(axis.segment_at(from_m), from_m));
  }
  if (span.to.cut_m > 0) {
    std::erase_if(ribs, [&](const Rib& rib) { return rib.along_m > to_m - kMinRibSpacing_m; });
    ribs.push_back(axis.within(axis.segment_at(to_m), to_m));
  }
  if (from_m + kMinRibSpacing_m > to_m) ribs.clear();
}

struct Simplification {
  std::span<const Rib> ribs;
  double left_m, right_m, tolerance_m;
  SimplifiedRibs result{};

  // The distance of a rib's edge points from the straight edges between two others.
  double error_m(std::size_t i, std::size_t a, std::size_t b) const {
    double error_m = 0;
    for (const double edge_m : {left_m, -right_m}) {
      const Vec3 p = point_on(ribs[i], edge_m, 0);
      const Vec3 nearest = nearest_point(point_on(ribs[a], edge_m, 0), point_on(ribs[b], edge_m, 0), p);
      error_m = std::max(error_m, length(p - nearest));
    }
    return error_m;
  }
  // Adds the ribs after a up to b.
  void simplify(std::size_t a, std::size_t b) {
    std::size_t farthest = a;
    double largest_m = 0;
    for (std::size_t i = a + 1; i < b; ++i)
      if (const double here_m = error_m(i, a, b); here_m > largest_m) largest_m = here_m, farthest = i;
    if (largest_m > tolerance_m) {
      simplify(a, farthest);
      simplify(farthest, b);
      return;
    }
    result.error_m = std::max(result.error_m, largest_m);
    result.ribs.push_back(ribs[b]);
  }
};

}  // namespace

Vec3 point_on(const Rib& rib, double left_m, double rise_m) {
  return snapped(at_height(rib.at + rib.out * left_m, rib.z_m + rib.tilt * left_m + rise_m));
}

std::vector<Rib> ribs_of(const Span& span) {
  if (span.axis.size() < 2) return {};
  const Axis axis{span, roads::distances_along(span)};
  std::vector<Rib> ribs = all_ribs(axis);
  cut_ends(axis, ribs);
  return ribs.size() < 2 ? std::vector<Rib>() : ribs;
}

SimplifiedRibs simplify_ribs(std::span<const Rib> ribs, double left_m, double right_m, double tolerance_m) {
  assert(tolerance_m >= 0);
  if (ribs.size() < 2) return {};
  Simplification simplification{ribs, left_m, right_m, tolerance_m};
  simplification.result.ribs.push_back(ribs.front());
  simplification.simplify(0, ribs.size() - 1);
  return std::move(simplification.result);
}

}  // namespace citykiln::structures
