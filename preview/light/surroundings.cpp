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

// How high a ray is above the ground around at a distance. The Earth falls away from a tangent by its square.
double above_m(const Surroundings& around, Vec3 from, Vec3 direction, double at_m) {
  const double level2 = direction.x * direction.x + direction.y * direction.y;
  const double rise_m = direction.z * at_m + at_m * at_m * level2 / (2 * sky::kEarth_m);
  return from.z + rise_m - edge_at(around, in_plan(from + direction * at_m)).height_m;
}

// Where a ray first goes below the ground around, from a distance on to another: steps that grow, then halving.
std::optional<double> first_below(const Surroundings& around, Vec3 from, Vec3 direction, double begin_m, double end_m) {
  constexpr double kFirstStep_m = 10, kGrowth = 1.2;
  constexpr int kHalvings = 24;
  if (above_m(around, from, direction, begin_m) < kClearance_m) return begin_m;
  double low = begin_m;
  for (double step_m = kFirstStep_m; low < end_m; step_m *= kGrowth) {
    double high = std::min(low + step_m, end_m);
    if (above_m(around, from, direction, high) >= 0) {
      low = high;
      continue;
    }
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (above_m(around, from, direction, middle) < 0 ? high : low) = middle;
    }
    return high;
  }
  return std::nullopt;
}

// The distance between a place and a box.
double away_m(const Box2& box, Vec2 p) {
  return length(
      Vec2{std::max({box.min.x - p.x, 0.0, p.x - box.max.x}), std::max({box.min.y - p.y, 0.0, p.y - box.max.y})});
}

Edge mixed(const Edge& a, const Edge& b, double share) {
  return {preview::mixed(a.albedo, b.albedo, share), std::lerp(a.sea, b.sea, share),
          std::lerp(a.height_m, b.height_m, share)};
}

}  // namespace

Edge mean_of(const std::vector<Edge>& ring) {
  Edge mean;
  double land = 0;
  for (const Edge& edge : ring) {
    mean.sea += edge.sea / static_cast<double>(ring.size());
    mean.height_m += edge.height_m / static_cast<double>(ring.size());
    mean.albedo = mean.albedo + edge.albedo * (1 - edge.sea), land += 1 - edge.sea;
  }
  if (land > 0) mean.albedo = mean.albedo * (1 / land);
  return mean;
}

std::optional<GroundPoint> meet_ground(const Surroundings& around, Vec3 from, Vec3 direction) {
  constexpr double kFarthest_m = 4e5;  // the horizon of an eye 12 km up
  if (direction.z >= 0) return std::nullopt;
  const auto [entered_m, left_m] = crossing_m(around.box, in_plan(from), in_plan(direction));
  // from outside, the ground may be before the box
  std::optional<double> met;
  if (entered_m > 0) met = first_below(around, from, direction, 0, entered_m);
  if (!met) met = first_below(around, from, direction, left_m, kFarthest_m);
  if (!met) return std::nullopt;
  return GroundPoint{*met, edge_at(around, in_plan(from + direction * *met))};
}

Edge edge_at(const Surroundings& around, Vec2 place) {
  assert(!around.ring.empty());
  const auto count = static_cast<int>(around.ring.size());
  const double at = turn_of(at_height(place - around.box.centre(), 0)) * count;
  const int low = std::min(static_cast<int>(at), count - 1);
  const Edge own = mixed(around.ring[low], around.ring[(low + 1) % count], at - low);
  const double away = away_m(around.box, place);
  return mixed(own, around.mean, away / (away + kFade_m));
}

}  // namespace citykiln::preview
