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

// Largest error of the distance to the ground around, as a share of it.
constexpr double kExactness = 1e-4;

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

// How high a ray is over sea level at a distance. The Earth falls away from a tangent by its square.
double height_m(Vec3 from, Vec3 direction, double at_m) {
  const double level2 = direction.x * direction.x + direction.y * direction.y;
  return from.z + direction.z * at_m + at_m * at_m * level2 / (2 * sky::kEarth_m);
}

// The distance between a place and a box.
double away_m(const Box2& box, Vec2 p) {
  return length(
      Vec2{std::max({box.min.x - p.x, 0.0, p.x - box.max.x}), std::max({box.min.y - p.y, 0.0, p.y - box.max.y})});
}

// A place between two edges of the ring, and how far the mean has replaced them.
struct RingPlace {
  std::size_t low, high;
  double share, faded;
};

RingPlace ring_place(const Surroundings& around, Vec2 place) {
  const std::size_t count = around.ring.size();
  const double at = turn_of(at_height(place - around.box.centre(), 0)) * static_cast<double>(count);
  const std::size_t low = std::min(static_cast<std::size_t>(at), count - 1);
  const double away = away_m(around.box, place);
  return {low, low + 1 == count ? 0 : low + 1, at - static_cast<double>(low), away / (away + kFade_m)};
}

// The height of edge_at.
double ground_height_m(const Surroundings& around, Vec2 place) {
  const auto [low, high, share, faded] = ring_place(around, place);
  const double own = std::lerp(around.ring[low].height_m, around.ring[high].height_m, share);
  return std::lerp(own, around.mean.height_m, faded);
}

// How high a ray is above the ground around at a distance.
double above_m(const Surroundings& around, Vec3 from, Vec3 direction, double at_m) {
  return height_m(from, direction, at_m) - ground_height_m(around, in_plan(from + direction * at_m));
}

// The distance at which a falling ray comes down to a height; infinity where it passes above it.
double down_to_m(Vec3 from, Vec3 direction, double target_m) {
  const double curve = (direction.x * direction.x + direction.y * direction.y) / (2 * sky::kEarth_m);
  const double over = from.z - target_m, root2 = direction.z * direction.z - 4 * curve * over;
  if (over <= 0) return 0;
  return root2 < 0 ? std::numeric_limits<double>::infinity() : 2 * over / (std::sqrt(root2) - direction.z);
}

// Where a ray goes below the ground, between a place above it and one below, to a ten thousandth of the distance. False
// position, with the weight of an end that stays halved (the Illinois algorithm; Dowell, Jarratt, BIT 11, 1971).
double crossing_of(const Surroundings& around, Vec3 from, Vec3 direction, double low_m, double high_m) {
  double above = above_m(around, from, direction, low_m), below = above_m(around, from, direction, high_m);
  for (int i = 0, side = 0; i < 40 && high_m - low_m > kExactness * high_m; ++i) {
    const double at = (low_m * below - high_m * above) / (below - above);
    const double gap = above_m(around, from, direction, at);
    if (std::abs(gap) < 1e-3) return at;
    if (gap > 0) {
      low_m = at, above = gap;
      if (std::exchange(side, 1) == 1) below /= 2;
    } else {
      high_m = at, below = gap;
      if (std::exchange(side, -1) == -1) above /= 2;
    }
  }
  return high_m;
}

// Where a ray first goes below the ground around, from a distance on to another: steps that grow, in the part of the
// ray that is neither above all ground nor below.
std::optional<double> first_below(const Surroundings& around, Vec3 from, Vec3 direction, double begin_m, double end_m) {
  constexpr double kFirstStep_m = 10, kGrowth = 1.2;
  if (above_m(around, from, direction, begin_m) < kClearance_m) return begin_m;
  double low = std::max(begin_m, down_to_m(from, direction, around.highest_m));
  end_m = std::min(end_m, std::max(low, down_to_m(from, direction, around.lowest_m)) * (1 + kExactness));
  for (double step_m = std::max(kFirstStep_m, low * (kGrowth - 1)); low < end_m; step_m *= kGrowth) {
    const double high = std::min(low + step_m, end_m);
    if (above_m(around, from, direction, high) < 0) return crossing_of(around, from, direction, low, high);
    low = high;
  }
  return std::nullopt;
}

Edge mixed_edges(const Edge& a, const Edge& b, double share) {
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

void bound_heights(Surroundings& around) {
  const auto [low, high] = std::ranges::minmax(around.ring, {}, &Edge::height_m);
  around.lowest_m = low.height_m, around.highest_m = high.height_m;
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
  const auto [low, high, share, faded] = ring_place(around, place);
  return mixed_edges(mixed_edges(around.ring[low], around.ring[high], share), around.mean, faded);
}

}  // namespace citykiln::preview
