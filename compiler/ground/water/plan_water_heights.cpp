#include "compiler/ground/water/plan_water_heights.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "compiler/geometry/profile.h"
#include "compiler/ground/water/fit_rivers.h"
#include "compiler/ground/water/river_areas.h"
#include "compiler/ground/water/river_depth.h"
#include "compiler/ground/water/river_network.h"
#include "compiler/ground/water/river_profile.h"
#include "compiler/ground/water/standing_water.h"
#include "compiler/ground/water/uphill_lines.h"

namespace citykiln::ground {
namespace {

// Smaller differences are not reported.
constexpr double kMoved_m = 0.5, kOffLand_m = 10;
// The floor of a valley beside a line counts at any depth.
constexpr double kFloor_m = std::numeric_limits<double>::infinity();

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

// Reverses streams and covered waterways that are mapped uphill; returns whether there were any.
bool turn_uphill(std::vector<roads::Strip>& streams, std::vector<Polyline>& covered, const RiverNetwork& network,
                 const std::vector<bool>& seas, Report& report) {
  const std::vector<double> rises = uphill_rise_m(network, seas);
  for (std::size_t i = 0; i < streams.size(); ++i) {
    if (rises[i] == 0) continue;
    std::ranges::reverse(streams[i].axis);
    std::swap(streams[i].left_m, streams[i].right_m);
    report.add(Code::kWaterwayReversed, streams[i].id.osm, rises[i]);
  }
  for (std::size_t i = 0; i < covered.size(); ++i)
    if (rises[streams.size() + i] != 0) std::ranges::reverse(covered[i]);
  return std::ranges::any_of(rises, [](double rise) { return rise != 0; });
}

Code code_of(Apart apart) {
  switch (apart) {
    case Apart::kRises:
      return Code::kWaterwayRises;
    case Apart::kLake:
      return Code::kWaterwayOffLake;
    case Apart::kNeighbours:
      return Code::kWaterwayOffNeighbours;
    case Apart::kNot:
      break;
  }
  return Code::kRiverOffTerrain;
}

// Gives streams their profiles. Streams that are left out get none and lie on the terrain.
void set_profiles(std::vector<roads::Strip>& streams, const RiverNetwork& network, const FittedRivers& fitted,
                  double step_m, Report& report) {
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const RiverLine& line = network.lines[i];
    const bool is_apart = fitted.apart[i] != Apart::kNot;
    // a rise within one grid step is a broken sample, a bridge or a tree
    const double off_m =
        is_apart ? fitted.off_m[i]
                 : sustained_depth_m(network, line, heights_of_stops(line, fitted.heights), step_m, kFloor_m);
    if (!is_apart) streams[i].profile = profile_of(line, fitted.heights);
    if (is_apart || off_m > kOffLand_m) report.add(code_of(fitted.apart[i]), streams[i].id.osm, off_m);
    const auto is_on_cycle = [&](const RiverStation& stop) {
      return !network.is_water(stop.node) && fitted.heights.is_cycle[stop.node];
    };
    if (!is_apart && std::ranges::any_of(line.stops, is_on_cycle))
      report.add(Code::kWaterwayCycle, streams[i].id.osm, length_m(streams[i].axis));
  }
}

std::vector<double> max_depths_of(std::span<const roads::Strip> streams) {
  std::vector<double> depths_m;
  for (const roads::Strip& stream : streams) depths_m.push_back(max_depth_m(stream.left_m + stream.right_m));
  return depths_m;
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
  std::vector<Polyline> covered_axes(covered.begin(), covered.end());
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
    return make_river_network(waters.streams, covered_axes, waters.surfaces, standing, heights);
  };
  RiverNetwork network = network_now();
  if (turn_uphill(waters.streams, covered_axes, network, seas, report)) network = network_now();
  const FittedRivers found =
      fit_rivers(network, seas, max_depths_of(waters.streams), kSustained * heights.longer_sample_step_m());

  set_profiles(waters.streams, network, found, heights.longer_sample_step_m(), report);
  set_levels(waters.surfaces, standing, found.heights, heights, report);
  for (std::size_t i = 0; i < waters.streams.size(); ++i)
    waters.streams[i].influence_radius_m = areas.influence_radius_m[i];
  return waters;
}

}  // namespace citykiln::ground
