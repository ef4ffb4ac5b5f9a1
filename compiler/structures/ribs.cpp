#include "compiler/structures/ribs.h"

#include <algorithm>

#include "compiler/geometry/snap.h"

namespace citykiln::structures {
namespace {

// A mitre is at most this many times the half width; sharper bends are cut off.
constexpr double kLongestMitre = 2;

// A knot nearer to a bend than this is as good as on it.
constexpr double kApart_m = 0.25;

// Half way between two directions, so long that it reaches the edges of both strips. The same line, to the bit, for the
// same bend walked back.
Vec2 mitre(Vec2 before, Vec2 after) {
  const Vec2 middle = unit(before + after);
  // where the axis turns straight back there is no middle
  if (middle == Vec2{}) return left_of(before);
  const double cos = (dot(middle, before) + dot(middle, after)) / 2;
  return left_of(middle) * std::min(1 / std::max(cos, 1e-9), kLongestMitre);
}

// Where a span ends square to the road on the ground its edges are as far from the axis as that road's.
Vec2 out_of_end(const SpanEnd& end, Vec2 at, Vec2 own, bool is_begin) {
  const Vec2 beyond = unit(is_begin ? at - end.beyond : end.beyond - at);
  switch (end.kind) {
    case EndKind::kJoint:
      return is_begin ? mitre(beyond, own) : mitre(own, beyond);
    case EndKind::kGround:
      return left_of(dot(beyond, own) * kLongestMitre >= 1 ? beyond : own);
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
      if (knot.at_m > axis.along_m[i] + kApart_m && knot.at_m < axis.along_m[i + 1] - kApart_m)
        ribs.push_back(axis.within(i, knot.at_m));
  }
  return ribs;
}

// Without what lies on a road that passes an end.
void cut_ends(const Axis& axis, std::vector<Rib>& ribs) {
  const Span& span = axis.span;
  const double from_m = axis.along_m.front() + span.from.cut_m, to_m = axis.along_m.back() - span.to.cut_m;
  if (span.from.cut_m > 0) {
    std::erase_if(ribs, [&](const Rib& rib) { return rib.along_m < from_m + kApart_m; });
    ribs.insert(ribs.begin(), axis.within(axis.segment_at(from_m), from_m));
  }
  if (span.to.cut_m > 0) {
    std::erase_if(ribs, [&](const Rib& rib) { return rib.along_m > to_m - kApart_m; });
    ribs.push_back(axis.within(axis.segment_at(to_m), to_m));
  }
  if (from_m + kApart_m > to_m) ribs.clear();
}

double off_line_m(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double length2 = dot(along, along);
  const double t = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0;
  return length(p - (a + along * t));
}

struct Thinning {
  std::span<const Rib> ribs;
  double left_m, right_m, tolerance_m;
  SimplifiedRibs few{};

  double off_m(std::size_t i, std::size_t a, std::size_t b) const {
    double off = 0;
    for (const double edge_m : {left_m, -right_m})
      off = std::max(
          off, off_line_m(point_on(ribs[i], edge_m, 0), point_on(ribs[a], edge_m, 0), point_on(ribs[b], edge_m, 0)));
    return off;
  }
  // Those strictly between, and then the last.
  void thin(std::size_t a, std::size_t b) {
    std::size_t farthest = a;
    double off = 0;
    for (std::size_t i = a + 1; i < b; ++i)
      if (const double here = off_m(i, a, b); here > off) off = here, farthest = i;
    if (off > tolerance_m) {
      thin(a, farthest);
      thin(farthest, b);
      return;
    }
    few.error_m = std::max(few.error_m, off);
    few.ribs.push_back(ribs[b]);
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
  if (ribs.size() < 2) return {};
  Thinning thinning{ribs, left_m, right_m, tolerance_m};
  thinning.few.ribs.push_back(ribs.front());
  thinning.thin(0, ribs.size() - 1);
  return std::move(thinning.few);
}

}  // namespace citykiln::structures
