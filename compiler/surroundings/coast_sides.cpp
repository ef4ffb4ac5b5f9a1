#include "compiler/surroundings/coast_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/geometry/segment.h"

namespace citykiln::surroundings {
namespace {

constexpr std::size_t kSegmentsOfRun = 16;

bool is_before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// Ends that occur once.
std::vector<Vec2> free_ends_of(std::span<const Polyline> coasts) {
  std::vector<Vec2> ends;
  for (const Polyline& coast : coasts)
    if (coast.size() >= 2) ends.push_back(coast.front()), ends.push_back(coast.back());
  std::ranges::sort(ends, is_before);
  std::vector<Vec2> free;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const bool is_repeated = (i > 0 && ends[i - 1] == ends[i]) || (i + 1 < ends.size() && ends[i + 1] == ends[i]);
    if (!is_repeated) free.push_back(ends[i]);
  }
  return free;
}

double squared(Vec2 v) { return dot(v, v); }

double squared_distance(const Box2& box, Vec2 p) {
  return squared(
      {std::max({box.min.x - p.x, p.x - box.max.x, 0.0}), std::max({box.min.y - p.y, p.y - box.max.y, 0.0})});
}

}  // namespace

// If segments meet in the nearest point, the one that is seen most from the side decides.
struct CoastSides::Nearest {
  double squared_m = std::numeric_limits<double>::infinity(), sine = 0;
  Vec2 at;
  bool is_sea = false;
};

CoastSides::CoastSides(std::span<const Polyline> coasts) : ends_(free_ends_of(coasts)) {
  for (const Polyline& coast : coasts)
    for (std::size_t first = 0; first + 1 < coast.size(); first += kSegmentsOfRun) {
      const std::size_t last = std::min(first + kSegmentsOfRun, coast.size() - 1);
      const std::span<const Vec2> points(coast.data() + first, last - first + 1);
      runs_.push_back({points, box_of(points)});
    }
}

void CoastSides::look_in(const Run& run, Vec2 place, Nearest& nearest) const {
  for (std::size_t i = 0; i + 1 < run.points.size(); ++i) {
    const Vec2 a = run.points[i], b = run.points[i + 1];
    if (a == b) continue;
    const Vec2 at = nearest_point(a, b, place);
    const double squared_m = squared(place - at);
    if (squared_m > nearest.squared_m) continue;
    const double side = cross(b - a, place - a), sine = std::abs(side) / length(b - a);
    if (squared_m == nearest.squared_m && sine <= nearest.sine) continue;
    nearest = {squared_m, sine, at, side < 0};
  }
}

std::optional<CoastSide> CoastSides::at(Vec2 place) const {
  if (runs_.empty()) return std::nullopt;
  const auto away = [&](const Run& run) { return squared_distance(run.box, place); };
  Nearest nearest;
  look_in(*std::ranges::min_element(runs_, {}, away), place, nearest);
  for (const Run& run : runs_)
    if (away(run) <= nearest.squared_m) look_in(run, place, nearest);
  return CoastSide{.is_sea = nearest.is_sea,
                   .is_beyond = std::ranges::binary_search(ends_, nearest.at, is_before),
                   .away_m = std::sqrt(nearest.squared_m)};
}

}  // namespace citykiln::surroundings
