#include "compiler/ground/grade_limits.h"

#include <algorithm>
#include <cmath>

#include "compiler/ground/graph_walk.h"
#include "compiler/ground/pinned.h"

namespace citykiln::ground {
namespace {

// The lower ends of legs that are too steep: nothing else lowers anything.
std::vector<std::uint32_t> feet_of_steep_legs(const ProfileGraph& graph, std::span<const double> z_m) {
  std::vector<std::uint32_t> feet;
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
    const auto is_steep = [&](const Leg& leg) { return z_m[leg.to] - z_m[n] > limit_of(graph, leg) * leg.length_m; };
    if (std::ranges::any_of(graph.legs_of(n), is_steep)) feet.push_back(n);
  }
  return feet;
}

std::vector<double> negated(std::span<const double> z_m) {
  std::vector<double> turned;
  for (const double z : z_m) turned.push_back(-z);
  return turned;
}

}  // namespace

// A walk goes on where it lowers the heights given, whatever other walks did there: so each foot acts
// for itself, and their order is nothing.
std::vector<double> lowered_to_limits(const ProfileGraph& graph, std::span<const double> z_m) {
  std::vector<double> low(z_m.begin(), z_m.end());
  GraphWalk walk(graph);
  for (const std::uint32_t foot : feet_of_steep_legs(graph, z_m)) {
    const GraphWalk::Start start{z_m[foot], foot};
    walk.from(
        std::span(&start, 1), z_m[foot] + kGradeReach_m,
        [&](const Leg& leg) { return limit_of(graph, leg) * leg.length_m; },
        [&](std::uint32_t node, double up_m) {
          if (node != foot && up_m >= z_m[node]) return false;
          low[node] = std::min(low[node], up_m);
          return distance(graph.nodes[node].at, graph.nodes[foot].at) < kGradeReach_m;
        });
  }
  return low;
}

std::vector<double> limit_grades(const ProfileGraph& graph, std::span<const double> z_m) {
  const std::vector<double> upper = lowered_to_limits(graph, z_m), lower = lowered_to_limits(graph, negated(z_m));
  GraphWalk walk(graph);
  const std::vector<double> ceiling = caps_of_pinned(graph, walk, z_m),
                            floor = caps_of_pinned(graph, walk, negated(z_m));
  std::vector<double> limited(z_m.begin(), z_m.end());
  for (std::uint32_t n = 0; n < limited.size(); ++n) {
    const double half_m = (upper[n] - lower[n]) / 2;
    const double near_m = std::clamp(half_m, z_m[n] - kMostEarth_m, z_m[n] + kMostEarth_m);
    limited[n] = std::max(std::min(near_m, ceiling[n]), -floor[n]);
  }
  return limited;
}

}  // namespace citykiln::ground
