#include "compiler/ground/water/uphill_lines.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

namespace citykiln::ground {
namespace {

constexpr double kClearRise_m = 10, kClearRiseFromSea_m = 3, kClearRiseGoingOn_m = 30;
constexpr double kClearer = 4;

// How many lines, as mapped, enter and leave each node, and how many begin or end there.
struct Degrees {
  std::vector<int> in, out, ends;
};

Degrees degrees_of(const RiverNetwork& network) {
  const std::size_t n = network.nodes.size();
  Degrees degrees{std::vector<int>(n), std::vector<int>(n), std::vector<int>(n)};
  for (const RiverLine& line : network.lines) {
    ++degrees.ends[line.stops.front().node], ++degrees.ends[line.stops.back().node];
    for (std::size_t i = 0; i + 1 < line.stops.size(); ++i) {
      if (line.stops[i].node == line.stops[i + 1].node) continue;
      ++degrees.out[line.stops[i].node], ++degrees.in[line.stops[i + 1].node];
    }
  }
  return degrees;
}

constexpr std::uint32_t kNoLine = 0xffffffffu;

// True if one line ends at a node, another begins, and nothing else meets them.
bool is_link(const RiverNetwork& network, const Degrees& degrees, std::uint32_t node) {
  return !network.is_water(node) && degrees.in[node] == 1 && degrees.out[node] == 1 && degrees.ends[node] == 2;
}

// Returns the lines in chains, which are one waterway that is mapped in parts, from the first part to the last.
std::vector<std::vector<std::uint32_t>> chains_of(const RiverNetwork& network, const Degrees& degrees) {
  std::vector<std::uint32_t> begins_at(network.nodes.size(), kNoLine);
  for (std::uint32_t l = 0; l < network.lines.size(); ++l) begins_at[network.lines[l].stops.front().node] = l;
  std::vector<std::vector<std::uint32_t>> chains;
  std::vector<bool> is_known(network.lines.size(), false);
  const auto add_chain = [&](std::uint32_t first) {
    std::vector<std::uint32_t>& chain = chains.emplace_back();
    for (std::uint32_t l = first; !is_known[l];) {
      is_known[l] = true;
      chain.push_back(l);
      const std::uint32_t end = network.lines[l].stops.back().node;
      if (is_link(network, degrees, end)) l = begins_at[end];
    }
  };
  for (std::uint32_t l = 0; l < network.lines.size(); ++l)
    if (!is_link(network, degrees, network.lines[l].stops.front().node)) add_chain(l);
  for (std::uint32_t l = 0; l < network.lines.size(); ++l)  // circles
    if (!is_known[l]) add_chain(l);
  return chains;
}

std::vector<double> lands_along(const RiverNetwork& network, std::span<const std::uint32_t> chain) {
  std::vector<double> lands;
  for (const std::uint32_t l : chain)
    for (const RiverStation& stop : network.lines[l].stops)
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
                    std::span<const std::uint32_t> chain) {
  const std::uint32_t from = network.lines[chain.front()].stops.front().node,
                      to = network.lines[chain.back()].stops.back().node;
  if (network.is_water(from) && seas[from]) return kClearRiseFromSea_m;
  return degrees.in[from] > 0 && degrees.out[to] > 0 ? kClearRiseGoingOn_m : kClearRise_m;
}

}  // namespace

std::vector<double> uphill_rise_m(const RiverNetwork& network, const std::vector<bool>& seas) {
  assert(seas.size() == network.water_count);
  const Degrees degrees = degrees_of(network);
  std::vector<double> rises(network.lines.size(), 0);
  for (const std::vector<std::uint32_t>& chain : chains_of(network, degrees)) {
    std::vector<double> lands = lands_along(network, chain);
    if (lands.size() < 2) continue;
    const double rise = land_rise_m(lands);
    if (rise < clear_rise_m(network, degrees, seas, chain)) continue;
    const double as_mapped = fill_m(lands);
    std::reverse(lands.begin(), lands.end());
    if (as_mapped > kClearer * fill_m(lands))
      for (const std::uint32_t l : chain) rises[l] = rise;
  }
  return rises;
}

}  // namespace citykiln::ground
