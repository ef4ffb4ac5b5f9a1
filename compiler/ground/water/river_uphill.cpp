#include "compiler/ground/water/river_uphill.h"

#include <algorithm>
#include <cassert>

namespace citykiln::ground {
namespace {

constexpr double kClearRise_m = 10, kClearRiseFromSea_m = 3, kClearRiseGoingOn_m = 30;
constexpr double kClearer = 4;

// How many lines, as mapped, enter and leave each node.
struct Degrees {
  std::vector<int> in, out;
};

Degrees degrees_of(const RiverNetwork& network) {
  Degrees degrees{std::vector<int>(network.nodes.size()), std::vector<int>(network.nodes.size())};
  for (const RiverLine& line : network.lines)
    for (std::size_t i = 0; i + 1 < line.stops.size(); ++i) {
      if (line.stops[i].node == line.stops[i + 1].node) continue;
      ++degrees.out[line.stops[i].node], ++degrees.in[line.stops[i + 1].node];
    }
  return degrees;
}

std::vector<double> lands_along(const RiverNetwork& network, const RiverLine& line) {
  std::vector<double> lands;
  for (const RiverStation& stop : line.stops)
    if (network.nodes[stop.node].is_known()) lands.push_back(network.nodes[stop.node].land_m);
  return lands;
}

// Returns the fill needed for water to run from the first to the last.
double fill_m(const std::vector<double>& lands) {
  double fill = 0, highest = lands.back();
  for (std::size_t i = lands.size(); i-- > 0;) {
    highest = std::max(highest, lands[i]);
    fill += highest - lands[i];
  }
  return fill;
}

double mean_m(auto first, auto last) {
  double sum = 0;
  for (auto at = first; at != last; ++at) sum += *at;
  return sum / static_cast<double>(last - first);
}

double land_rise_m(const std::vector<double>& lands) {
  const auto third = static_cast<std::ptrdiff_t>(lands.size() + 2) / 3;
  return mean_m(lands.end() - third, lands.end()) - mean_m(lands.begin(), lands.begin() + third);
}

double clear_rise_m(const RiverNetwork& network, const Degrees& degrees, const std::vector<bool>& seas,
                    const RiverLine& line) {
  const std::uint32_t from = line.stops.front().node, to = line.stops.back().node;
  if (network.is_water(from) && seas[from]) return kClearRiseFromSea_m;
  return degrees.in[from] > 0 && degrees.out[to] > 0 ? kClearRiseGoingOn_m : kClearRise_m;
}

}  // namespace

std::vector<double> uphill_rise_m(const RiverNetwork& network, const std::vector<bool>& seas,
                                  std::size_t stream_count) {
  assert(seas.size() == network.water_count && stream_count <= network.lines.size());
  const Degrees degrees = degrees_of(network);
  std::vector<double> rises(stream_count, 0);
  for (std::size_t l = 0; l < stream_count; ++l) {
    std::vector<double> lands = lands_along(network, network.lines[l]);
    if (lands.size() < 2) continue;
    const double rise = land_rise_m(lands);
    if (rise < clear_rise_m(network, degrees, seas, network.lines[l])) continue;
    const double as_mapped = fill_m(lands);
    std::reverse(lands.begin(), lands.end());
    if (as_mapped > kClearer * fill_m(lands)) rises[l] = rise;
  }
  return rises;
}

}  // namespace citykiln::ground
