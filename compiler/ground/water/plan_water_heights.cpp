#include "compiler/ground/water/plan_water_heights.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/profile.h"
#include "compiler/ground/water/river_areas.h"
#include "compiler/ground/water/river_depth.h"
#include "compiler/ground/water/river_heights.h"
#include "compiler/ground/water/river_network.h"
#include "compiler/ground/water/river_profile.h"
#include "compiler/ground/water/river_uphill.h"
#include "compiler/ground/water/standing_water.h"

namespace citykiln::ground {
namespace {

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
  for (std::size_t i = 0; i < waters.streams.size(); ++i) waters.streams[i].reach_m = areas.reach_m[i];
  return waters;
}

}  // namespace citykiln::ground
