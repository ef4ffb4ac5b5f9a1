#include "compiler/ground/water/river_depth.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

namespace citykiln::ground {
namespace {

// A place with its height above the terrain; none where nothing is known or the water stands.
struct DepthSample {
  double at_m;
  std::optional<double> above_m;
};

std::vector<DepthSample> depth_samples_of(const RiverNetwork& network, const RiverLine& line,
                                          std::span<const double> heights_m, double aside_m) {
  std::vector<DepthSample> places;
  for (std::size_t i = 0; i < line.stops.size(); ++i) {
    const RiverNode& node = network.nodes[line.stops[i].node];
    const bool is_compared = !network.is_water(line.stops[i].node) && node.is_known();
    places.push_back({line.stops[i].at_m, {}});
    if (is_compared) places.back().above_m = above_land_m(node, heights_m[i], aside_m);
  }
  return places;
}

}  // namespace

double above_land_m(const RiverNode& node, double height_m, double aside_m) {
  const double low_m = std::max(node.low_m, node.land_m - aside_m);
  return std::max(height_m - node.land_m, 0.0) + std::min(height_m - low_m, 0.0);
}

double max_depth_m(double width_m) {
  assert(width_m >= 0);
  constexpr double kStream_m = 2, kRiver_m = 8;
  return width_m < kStream_m ? kMaxDitchDepth_m : width_m < kRiver_m ? kMaxStreamDepth_m : kMaxRiverDepth_m;
}

double sustained_depth_m(const RiverNetwork& network, const RiverLine& line, std::span<const double> heights_m,
                         double run_m, double aside_m) {
  assert(run_m >= 0 && heights_m.size() == line.stops.size());
  const std::vector<DepthSample> places = depth_samples_of(network, line, heights_m, aside_m);
  double deepest_m = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double least_m = INFINITY;
    for (std::size_t j = i; j < places.size() && places[j].above_m; ++j) {
      if ((*places[j].above_m > 0) != (*places[i].above_m > 0)) break;
      least_m = std::min(least_m, std::abs(*places[j].above_m));
      if (places[j].at_m - places[i].at_m > run_m) {
        deepest_m = std::max(deepest_m, least_m);
        break;
      }
    }
  }
  return deepest_m;
}

}  // namespace citykiln::ground
