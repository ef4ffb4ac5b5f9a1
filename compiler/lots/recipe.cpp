#include "compiler/lots/recipe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln::lots {

Frame frame_at(const FramePlace& place) {
  const Vec2 inward = direction_of(static_cast<double>(place.heading) / kHeadings);
  return {place.origin, left_of(inward) * -1, inward};
}

FramePlace place_of(const Frame& frame) {
  const double turns = arctangent2_deg(frame.inward.y, frame.inward.x) / 360;
  const int heading = static_cast<int>(std::floor(turns * kHeadings + 0.5)) & (kHeadings - 1);
  return {snapped_to(kYardStep_m, frame.origin), static_cast<std::uint16_t>(heading)};
}

double setback_of(const Ring& building, const FramePlace& place) {
  const Frame frame = frame_at(place);
  double least_m = std::numeric_limits<double>::infinity();
  for (const Vec2 p : building) least_m = std::min(least_m, frame.local(p).y);
  return building.empty() ? 0 : std::max(0.0, std::floor(least_m / kYardStep_m) * kYardStep_m);
}

}  // namespace citykiln::lots
