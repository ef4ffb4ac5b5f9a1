#include "compiler/ground/water/river_profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::ground {
namespace {

constexpr double kKnot_m = 0.125;

struct RiverKnot {
  Knot knot;
  bool is_kept;
};

double rounded_down(double height_m) { return std::floor(height_m / kProfileQuantum_m) * kProfileQuantum_m; }

// rounding down keeps descending heights descending
std::vector<RiverKnot> river_knots_of(const RiverLine& line, const RiverHeights& heights) {
  std::vector<RiverKnot> places;
  const auto add = [&](double at_m, double z_m, bool is_pinned) {
    if (places.empty() || places.back().knot.at_m < at_m) places.push_back({{at_m, z_m, 0}, is_pinned});
  };
  for (const RiverStation& stop : line.stops) {
    const double z_m = rounded_down(heights.height_m[stop.node]);
    add(std::floor(stop.at_m / kKnot_m) * kKnot_m, z_m, stop.is_pinned);
    add(std::ceil(stop.at_m / kKnot_m) * kKnot_m, z_m, stop.is_pinned);
  }
  return places;
}

double off_m(const Knot& a, const Knot& b, const Knot& between) {
  const double z_m = a.z_m + (b.z_m - a.z_m) * ((between.at_m - a.at_m) / (b.at_m - a.at_m));
  return std::abs(between.z_m - z_m);
}

// Douglas and Peucker (1973): keeps the worst place between two kept ones until none is off by the tolerance.
void keep_worst(std::vector<RiverKnot>& places, std::size_t first, std::size_t last) {
  std::vector<std::pair<std::size_t, std::size_t>> spans = {{first, last}};
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    double worst_m = kKnotTolerance_m;
    std::size_t worst = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = off_m(places[from].knot, places[to].knot, places[i].knot);
      if (off >= worst_m) worst_m = off, worst = i;
    }
    if (worst == from) continue;
    places[worst].is_kept = true;
    spans.emplace_back(from, worst);
    spans.emplace_back(worst, to);
  }
}

}  // namespace

Profile profile_of(const RiverLine& line, const RiverHeights& heights) {
  assert(!line.stops.empty());
  std::vector<RiverKnot> places = river_knots_of(line, heights);
  places.front().is_kept = places.back().is_kept = true;
  std::size_t last_kept = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (!places[i].is_kept) continue;
    const std::size_t from = last_kept;
    last_kept = i;
    keep_worst(places, from, i);
  }
  Profile profile;
  for (const RiverKnot& place : places) {
    // of three level knots the middle one is redundant
    const std::size_t n = profile.size();
    const bool is_level = n > 1 && profile[n - 2].z_m == profile[n - 1].z_m && profile[n - 1].z_m == place.knot.z_m;
    if (place.is_kept && is_level) profile.pop_back();
    if (place.is_kept) profile.push_back(place.knot);
  }
  if (profile.size() == 2 && profile[0].z_m == profile[1].z_m) profile.pop_back();
  return profile;
}

}  // namespace citykiln::ground
