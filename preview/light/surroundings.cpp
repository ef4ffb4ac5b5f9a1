#include "preview/light/surroundings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "compiler/sky/atmosphere/air.h"
#include "preview/light/direction_table.h"

namespace citykiln::preview {
namespace {

// A ray leaves the box at least so far above the ground around.
constexpr double kClearance_m = 1.5;

// The distances at which a ray enters a box, 0 from inside, and leaves it; both 0 if it does not meet it.
std::pair<double, double> crossing_m(const Box2& box, Vec2 from, Vec2 direction) {
  double in = 0, out = std::numeric_limits<double>::infinity();
  const auto cut = [&](double at, double step, double low, double high) {
    if (step == 0) return void(at < low || at > high ? out = 0 : out);
    const double a = (low - at) / step, b = (high - at) / step;
    in = std::max(in, std::min(a, b)), out = std::min(out, std::max(a, b));
  };
  cut(from.x, direction.x, box.min.x, box.max.x);
  cut(from.y, direction.y, box.min.y, box.max.y);
  return in < out && std::isfinite(out) ? std::pair(in, out) : std::pair(0.0, 0.0);
}

// The distance from a height to a sphere below it.
std::optional<double> sphere_m(double height_m, double above_m, double direction_z) {
  const double r = sky::kEarth_m + height_m, b = r * direction_z;
  // r² - (r - above)² without its cancellation
  const double squares = above_m * (2 * r - above_m), d = b * b - squares;
  if (direction_z >= 0 || d < 0) return std::nullopt;
  return squares / (-b + std::sqrt(d));
}

}  // namespace

std::optional<GroundPoint> meet_ground(const Surroundings& around, Vec3 from, Vec3 direction) {
  if (direction.z >= 0) return std::nullopt;
  const auto [entered_m, left_m] = crossing_m(around.box, in_plan(from), in_plan(direction));
  // from outside, the ground may be before the box
  const Edge before = edge_at(around, in_plan(from + direction * entered_m));
  const auto near_m = sphere_m(from.z, std::max(kClearance_m, from.z - before.height_m), direction.z);
  if (entered_m > 0 && near_m && *near_m <= entered_m) return GroundPoint{*near_m, before};
  const Vec3 at = from + direction * left_m;
  const Edge edge = edge_at(around, in_plan(at));
  const auto beyond_m = sphere_m(at.z, std::max(kClearance_m, at.z - edge.height_m), direction.z);
  if (!beyond_m) return std::nullopt;
  return GroundPoint{left_m + *beyond_m, edge};
}

Edge edge_at(const Surroundings& around, Vec2 place) {
  assert(!around.ring.empty());
  const auto count = static_cast<int>(around.ring.size());
  const double at = turn_of(at_height(place - around.box.centre(), 0)) * count;
  const int low = std::min(static_cast<int>(at), count - 1);
  const Edge &a = around.ring[low], &b = around.ring[(low + 1) % count];
  const double share = at - low;
  return {mixed(a.albedo, b.albedo, share), a.sea + (b.sea - a.sea) * share,
          a.height_m + (b.height_m - a.height_m) * share};
}

}  // namespace citykiln::preview
