#include "compiler/geometry/profile.h"

#include <algorithm>
#include <cassert>

namespace citykiln {

Knot knot_at(std::span<const Knot> profile, double at_m) {
  assert(!profile.empty());
  const auto after = std::ranges::lower_bound(profile, at_m, {}, &Knot::at_m);
  if (after == profile.begin()) return {at_m, profile.front().z_m, profile.front().tilt};
  if (after == profile.end()) return {at_m, profile.back().z_m, profile.back().tilt};
  const Knot &a = after[-1], &b = *after;
  const double t = (at_m - a.at_m) / (b.at_m - a.at_m);
  return {at_m, a.z_m + (b.z_m - a.z_m) * t, a.tilt + (b.tilt - a.tilt) * t};
}

std::span<const Knot> between(std::span<const Knot> profile, double from_m, double to_m) {
  assert(from_m <= to_m);
  auto first = std::ranges::lower_bound(profile, from_m, {}, &Knot::at_m);
  auto last = std::ranges::upper_bound(profile, to_m, {}, &Knot::at_m);
  if (first != profile.begin()) --first;
  if (last != profile.end()) ++last;
  return {first, last};
}

}  // namespace citykiln
