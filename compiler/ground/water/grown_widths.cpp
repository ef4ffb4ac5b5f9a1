#include "compiler/ground/water/grown_widths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "compiler/contract/erase_repeated.h"

namespace citykiln::ground {
namespace {

// A waterway that begins this near to the border comes from outside.
constexpr double kBorder_m = 1;
constexpr double kWidthStep_m = 0.125;

// For each waterway those that it runs into.
std::vector<std::vector<std::uint32_t>> waterways_after(std::span<const map::Waterway> waterways) {
  std::vector<std::pair<Vec2, std::uint32_t>> points;
  for (std::uint32_t w = 0; w < waterways.size(); ++w)
    for (std::size_t i = 0; i + 1 < waterways[w].axis.size(); ++i) points.emplace_back(waterways[w].axis[i], w);
  sort_unique(points);
  std::vector<std::vector<std::uint32_t>> after(waterways.size());
  for (std::uint32_t w = 0; w < waterways.size(); ++w) {
    const Vec2 mouth = waterways[w].axis.back();
    auto at = std::ranges::lower_bound(points, std::pair(mouth, std::uint32_t{0}));
    for (; at != points.end() && at->first == mouth; ++at)
      if (at->second != w) after[w].push_back(at->second);
  }
  return after;
}

// The length upstream at which a watercourse is this wide.
double length_for_m(double width_m) {
  const double ratio = width_m / kWidthAtOneKilometre_m;
  return 1000 * ratio * ratio;
}

double width_for_m(double length_m) { return kWidthAtOneKilometre_m * std::sqrt(length_m / 1000); }

bool enters(const map::Waterway& water, const Box2& extent) {
  return !extent.widened(-kBorder_m).contains(water.axis.front());
}

// Returns all waterways, each after those that run into it. A circle begins with its lowest number.
std::vector<std::uint32_t> ordered_downstream(const std::vector<std::vector<std::uint32_t>>& after) {
  std::vector<int> before(after.size(), 0);
  for (const auto& nexts : after)
    for (const std::uint32_t next : nexts) ++before[next];
  std::vector<std::uint32_t> order;
  std::vector<bool> is_listed(after.size(), false);
  const auto list = [&](std::uint32_t w) { order.push_back(w), is_listed[w] = true; };
  std::size_t done = 0;
  for (const bool is_circle : {false, true})
    for (std::uint32_t first = 0; first < after.size(); ++first) {
      if (!is_listed[first] && (before[first] == 0 || is_circle)) list(first);
      for (; done < order.size(); ++done)
        for (const std::uint32_t next : after[order[done]])
          if (--before[next] == 0 && !is_listed[next]) list(next);
    }
  return order;
}

// Returns for each waterway the length of all that run into it. In a circle, the last does not run into the first.
std::vector<double> lengths_upstream(std::span<const map::Waterway> waterways, const Box2& extent) {
  const auto after = waterways_after(waterways);
  std::vector<double> upstream(waterways.size(), 0);
  for (std::uint32_t w = 0; w < waterways.size(); ++w)
    if (enters(waterways[w], extent)) upstream[w] = length_for_m(waterways[w].width_m);
  std::vector<bool> is_done(waterways.size(), false);
  for (const std::uint32_t w : ordered_downstream(after)) {
    is_done[w] = true;
    const double part_m = (upstream[w] + length_m(waterways[w].axis)) / static_cast<double>(after[w].size());
    for (const std::uint32_t next : after[w])
      if (!is_done[next]) upstream[next] += part_m;
  }
  return upstream;
}

double rounded_to_step(double width_m) { return std::floor(width_m / kWidthStep_m + 0.5) * kWidthStep_m; }

}  // namespace

std::vector<double> grown_widths_m(std::span<const map::Waterway> waterways, const Box2& extent) {
  const std::vector<double> upstream = lengths_upstream(waterways, extent);
  std::vector<double> widths_m;
  for (std::size_t w = 0; w < waterways.size(); ++w) {
    const map::Waterway& water = waterways[w];
    const double grown_m = width_for_m(upstream[w] + length_m(water.axis) / 2);
    widths_m.push_back(water.most_width_m == 0
                           ? water.width_m
                           : std::clamp(rounded_to_step(grown_m), water.least_width_m, water.most_width_m));
  }
  return widths_m;
}

}  // namespace citykiln::ground
