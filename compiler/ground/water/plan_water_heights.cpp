#include "compiler/ground/water/plan_water_heights.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "compiler/geometry/profile.h"
#include "compiler/ground/water/river_areas.h"
#include "compiler/ground/water/river_depth.h"
#include "compiler/ground/water/river_heights.h"
#include "compiler/ground/water/river_network.h"
#include "compiler/ground/water/river_profile.h"
#include "compiler/ground/water/standing_water.h"

namespace citykiln::ground {
namespace {

// ---- waterways that are mapped uphill -------------------------------------------------------------------------------

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

// Returns for each line that is clearly mapped uphill the height by which it would rise; 0 for other lines. A line is
// clearly mapped uphill if its last third is at least 10 m above its first third, and one direction would need four
// times as much fill as the other. The 10 m are 3 m if the line begins in the sea, and 30 m if it continues another
// line, as these are rarely mapped wrong. O(stations).
//
// @param seas  Per standing water: true if it is the sea.
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

// Smaller differences are not reported.
constexpr double kMoved_m = 0.5, kOffLand_m = 10;

bool has_heights(const map::Heightfield& heights) {
  return std::ranges::any_of(heights.heights, [](std::int32_t h) { return h != 0; });
}

// Returns what is level: standing water, and river areas without an axis.
std::vector<bool> find_level(const Waters& waters, const RiverAreas& areas, const map::Heightfield& heights,
                             Report& report) {
  std::vector<bool> stands = areas.has_no_axis;
  for (std::size_t i = 0; i < stands.size(); ++i) {
    const LandCoverPolygon& surface = waters.surfaces[i];
    if (is_standing(surface.surface)) stands[i] = true;
    if (!areas.has_no_axis[i]) continue;
    const Shore shore = shore_of(surface.rings, heights);
    report.add(Code::kRiverAreaWithoutAxis, surface.id.osm, shore.high_m - shore.low_m);
  }
  return stands;
}

std::vector<bool> seas_of(const StandingWaters& standing) {
  std::vector<bool> seas;
  for (const StandingWater& water : standing.waters) seas.push_back(water.is_sea);
  return seas;
}

// Reverses streams that are mapped uphill; returns whether there were any.
bool turn_uphill(std::vector<roads::Strip>& streams, const RiverNetwork& network, const std::vector<bool>& seas,
                 Report& report) {
  bool has_turned = false;
  const std::vector<double> rises = uphill_rise_m(network, seas, streams.size());
  for (std::size_t i = 0; i < streams.size(); ++i) {
    if (rises[i] == 0) continue;
    std::ranges::reverse(streams[i].axis);
    std::swap(streams[i].left_m, streams[i].right_m);
    report.add(Code::kWaterwayReversed, streams[i].id.osm, rises[i]);
    has_turned = true;
  }
  return has_turned;
}

void diagnose_stream(const roads::Strip& stream, const RiverNetwork& network, const RiverLine& line,
                     const RiverHeights& heights, Report& report) {
  double off_m = 0;
  bool is_cycle = false;
  for (const RiverStation& stop : line.stops) {
    const RiverNode& node = network.nodes[stop.node];
    if (network.is_water(stop.node)) continue;
    if (node.is_known()) off_m = std::max(off_m, std::abs(heights.height_m[stop.node] - node.land_m));
    is_cycle = is_cycle || heights.is_cycle[stop.node];
  }
  if (off_m > kOffLand_m) report.add(Code::kRiverOffTerrain, stream.id.osm, off_m);
  if (is_cycle) report.add(Code::kWaterwayCycle, stream.id.osm, length_m(stream.axis));
}

// Gives streams their profiles. Streams that would be too deep or too high get none and lie on the terrain.
void set_profiles(std::vector<roads::Strip>& streams, const RiverNetwork& network, const RiverHeights& heights,
                  const map::Heightfield& land, Report& report) {
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const double off_m = sustained_depth_m(network, network.lines[i], heights, kSustained * land.longer_step_m());
    if (off_m <= max_depth_m(streams[i].left_m + streams[i].right_m))
      streams[i].profile = profile_of(network.lines[i], heights);
    diagnose_stream(streams[i], network, network.lines[i], heights, report);
  }
}

void set_levels(std::vector<LandCoverPolygon>& surfaces, const StandingWaters& standing, const RiverHeights& heights,
                const map::Heightfield& land, Report& report) {
  for (std::uint32_t w = 0; w < standing.waters.size(); ++w) {
    const double moved_m = std::abs(heights.height_m[w] - standing.waters[w].level_m);
    if (moved_m > kMoved_m) report.add(Code::kLakeLevelMoved, standing.waters[w].id.osm, moved_m);
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const std::uint32_t w = standing.water_of[i];
    if (w == kNoWater) continue;
    surfaces[i].level_m = heights.height_m[w];
    if (!standing.waters[w].is_sea)
      surfaces[i] = without_spikes(std::move(surfaces[i]), heights.height_m[w], land, report);
  }
}

}  // namespace

Waters plan_water_heights(std::vector<LandCoverPolygon> surfaces, std::vector<roads::Strip> streams,
                          std::span<const Polyline> covered, const map::Heightfield& heights, Report& report) {
  Waters waters{std::move(surfaces), std::move(streams)};
  std::ranges::stable_sort(waters.streams, {}, &roads::Strip::id);
  if (!has_heights(heights)) return waters;

  // what is level, and its level by its shore
  const RiverAreas areas = find_river_axes(waters.surfaces, waters.streams, heights.box());
  const std::vector<bool> stands = find_level(waters, areas, heights, report);
  const StandingWaters standing = find_standing_waters(waters.surfaces, stands, heights, report);
  const std::vector<bool> seas = seas_of(standing);

  // what runs: its direction, then its heights
  const auto network_now = [&] {
    return make_river_network(waters.streams, covered, waters.surfaces, standing, heights);
  };
  RiverNetwork network = network_now();
  if (turn_uphill(waters.streams, network, seas, report)) network = network_now();
  const RiverHeights found = find_river_heights(network, seas);

  set_profiles(waters.streams, network, found, heights, report);
  set_levels(waters.surfaces, standing, found, heights, report);
  for (std::size_t i = 0; i < waters.streams.size(); ++i)
    waters.streams[i].influence_radius_m = areas.influence_radius_m[i];
  return waters;
}

}  // namespace citykiln::ground
