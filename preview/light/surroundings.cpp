#include "preview/light/surroundings.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/sky/atmosphere/air.h"
#include "preview/light/direction_table.h"

namespace citykiln::preview {
namespace {

// An eye stands at least so far above the ground around.
constexpr double kEyeHeight_m = 1.5;

}  // namespace

std::optional<GroundPoint> meet_ground(const Surroundings& around, Vec3 from, Vec3 direction) {
  const double ground_m = std::min(around.height_m, from.z - kEyeHeight_m);
  const double r = sky::kEarth_m + from.z, above_m = from.z - ground_m;
  // (r² - ground²) without its cancellation
  const double squares = above_m * (2 * r - above_m), b = r * direction.z, d = b * b - squares;
  if (direction.z >= 0 || d < 0) return std::nullopt;
  const double distance_m = squares / (-b + std::sqrt(d));
  return GroundPoint{distance_m, in_plan(from) + in_plan(direction) * distance_m};
}

Edge edge_at(const Surroundings& around, Vec2 place) {
  assert(!around.ring.empty());
  const auto count = static_cast<int>(around.ring.size());
  const double at = turn_of(at_height(place - around.centre, 0)) * count;
  const int low = std::min(static_cast<int>(at), count - 1);
  const Edge &a = around.ring[low], &b = around.ring[(low + 1) % count];
  const double share = at - low;
  return {mixed(a.albedo, b.albedo, share), a.sea + (b.sea - a.sea) * share};
}

}  // namespace citykiln::preview
