#include "compiler/roads/width_limits/limit_widths.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/roads/network.h"
#include "compiler/roads/width_limits/building_obstacles.h"
#include "compiler/roads/width_limits/fit_width_limits.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::roads {
namespace {

enum Channel : std::size_t { kLeft, kRight, kFromCut, kChannels };

// Above any limit, with room for one more step.
constexpr std::int16_t kFar = 0x7ffe;

// A path may run this far into a building: it ends at a door, and its corners enter a wall that is not square to it.
constexpr double kDoorstep_m = 1;

// A road sampled at every step: limits of both sides in units, and the number of steps to the nearest cut.
struct SampledRoad {
  std::int32_t first = 0;
  std::array<std::vector<std::int16_t>, kChannels> channels;  // empty where nothing limits the road
  bool is_active() const { return !channels[kLeft].empty(); }
};

SampledRoad sampled(const Road& road) {
  const std::vector<double> along = distances_along(road);
  const auto first = static_cast<std::int32_t>(std::floor(along.front() / kStep_m));
  const auto last = static_cast<std::int32_t>(std::ceil(along.back() / kStep_m));
  SampledRoad samples{first, {}};
  for (auto& channel : samples.channels) channel.assign(static_cast<std::size_t>(last - first) + 1, kFar);
  return samples;
}

// Limits the slope to one unit a step.
void spread(std::vector<std::int16_t>& values) {
  for (std::size_t i = 1; i < values.size(); ++i)
    values[i] = std::min(values[i], static_cast<std::int16_t>(values[i - 1] + 1));
  for (std::size_t i = values.size() - 1; i > 0; --i)
    values[i - 1] = std::min(values[i - 1], static_cast<std::int16_t>(values[i] + 1));
}

// A connection from one end of a road to an end of another.
struct Connection {
  bool from_front;
  std::uint32_t to;
  bool to_front;
};

using Connections = std::vector<std::vector<Connection>>;

Connections connections_of(std::span<const Road> roads) {
  Connections connections(roads.size());
  for (const Joint& joint : joints_of(roads))
    for (const auto& [a, b] : {std::pair(joint.a, joint.b), std::pair(joint.b, joint.a)})
      connections[a.road].push_back({a.step > 0, b.road, b.step > 0});
  return connections;
}

// Samples the roads with obstacles and all roads connected to them, since limits continue across their ends.
void activate(std::span<const Road> roads, const Connections& connections, std::vector<std::uint32_t> waiting,
              std::vector<SampledRoad>& samples) {
  while (!waiting.empty()) {
    const std::uint32_t road = waiting.back();
    waiting.pop_back();
    if (samples[road].is_active()) continue;
    samples[road] = sampled(roads[road]);
    for (const Connection& connection : connections[road]) waiting.push_back(connection.to);
  }
}

// Copies a road's values at its end to the next road; true where that lowered any.
bool copy_to_next(const SampledRoad& from, const Connection& connection, SampledRoad& to) {
  // where two heads or two tails meet, left and right are swapped
  const bool is_turned = connection.from_front == connection.to_front;
  bool is_lower = false;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const std::size_t other = c == kFromCut || !is_turned ? c : kLeft + kRight - c;
    const auto& values = from.channels[c];
    std::int16_t& there = connection.to_front ? to.channels[other].front() : to.channels[other].back();
    const std::int16_t here = connection.from_front ? values.front() : values.back();
    is_lower |= here < there;
    there = std::min(there, here);
  }
  return is_lower;
}

// Spreads all values along the roads and across their ends until nothing changes. Values only decrease and are bounded,
// so it ends.
void spread_all(const Connections& connections, std::vector<SampledRoad>& samples) {
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t road = 0; road < samples.size(); ++road)
    if (samples[road].is_active()) waiting.push_back(road);
  while (!waiting.empty()) {
    const std::uint32_t road = waiting.back();
    waiting.pop_back();
    for (auto& channel : samples[road].channels) spread(channel);
    for (const Connection& connection : connections[road])
      if (copy_to_next(samples[road], connection, samples[connection.to])) waiting.push_back(connection.to);
  }
}

void mark_cut(const Road& road, const Arm& arm, const Cut& cut, std::span<const Vec2> nodes, SampledRoad& samples) {
  const std::vector<double> along = distances_along(road);
  const double from = along[arm.vertex];
  const double to =
      cut.length_m == kWholeLink_m ? along[end_of_link(road, arm, nodes)] : from + arm.step * cut.length_m;
  const auto step = [&](double along_m) {
    return std::clamp(static_cast<std::int32_t>(along_m / kStep_m) - samples.first, 0,
                      static_cast<std::int32_t>(samples.channels[kFromCut].size()) - 1);
  };
  const auto low = step(std::floor(std::min(from, to) / kStep_m) * kStep_m),
             high = step(std::ceil(std::max(from, to) / kStep_m) * kStep_m);
  for (std::int32_t i = low; i <= high; ++i) samples.channels[kFromCut][static_cast<std::size_t>(i)] = 0;
}

void mark_cuts(std::span<const Road> roads, std::span<const Junction> junctions, std::vector<SampledRoad>& samples) {
  const auto arms = arms_of(junctions, roads);
  for (std::size_t j = 0; j < junctions.size(); ++j)
    for (std::size_t a = 0; a < std::min(arms[j].size(), junctions[j].cuts.size()); ++a) {
      const Arm& arm = arms[j][a];
      if (samples[arm.road].is_active())
        mark_cut(roads[arm.road], arm, junctions[j].cuts[a], junctions[j].nodes, samples[arm.road]);
    }
}

void mark_obstacles(const BuildingObstacles& beside, SampledRoad& samples) {
  for (const Obstacle& o : beside.obstacles) {
    const std::int64_t i = o.at_steps - samples.first;
    std::vector<std::int16_t>& side = samples.channels[o.is_left ? kLeft : kRight];
    // the step after the road's end
    if (i < 0 || i >= static_cast<std::int64_t>(side.size())) continue;
    side[static_cast<std::size_t>(i)] = std::min(side[static_cast<std::size_t>(i)], o.half_units);
  }
}

// The widths of one side from the carriageway's middle, in units: full, required at cuts, and minimum.
struct Widths {
  int whole, at_cut, least;
};

Widths widths_of(const Road& road, double raised_m) {
  const auto units = [](double m) { return static_cast<int>(std::ceil(m / kUnit_m)); };
  const double half = width_m(road) / 2;
  const int whole = units(half + raised_m);
  // fitting may lower the limit by kSlack_units
  const int at_cut = units(half + std::min(raised_m, kMinPavement_m)) + kSlack_units;
  return {whole, std::min(whole, at_cut), static_cast<int>(std::floor(min_half_width_m(road) / kUnit_m))};
}

// Opens the limit of one side at junction cuts; returns the largest reduction.
int open_at_cuts(const Widths& widths, const std::vector<std::int16_t>& from_cut, std::vector<std::int16_t>& side) {
  int most = 0;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const int open = std::max<int>({side[i], widths.at_cut - from_cut[i], widths.least});
    side[i] = static_cast<std::int16_t>(std::min(open, widths.whole));
    most = std::max(most, widths.whole - side[i]);
  }
  return most;
}

// The length of the road that buildings still cover, 0 where that is a doorstep.
double covered_m(const BuildingObstacles& beside, const SampledRoad& samples) {
  std::vector<std::int32_t> steps;
  for (const Obstacle& o : beside.obstacles) {
    const auto& side = samples.channels[o.is_left ? kLeft : kRight];
    const std::int64_t i = o.at_steps - samples.first;
    if (i >= 0 && i < static_cast<std::int64_t>(side.size()) && side[static_cast<std::size_t>(i)] > o.half_units)
      steps.push_back(o.at_steps);
  }
  const bool is_door = steps.empty() && static_cast<double>(beside.covered.size()) * kStep_m <= kDoorstep_m;
  if (is_door) return 0;
  steps.insert(steps.end(), beside.covered.begin(), beside.covered.end());
  std::sort(steps.begin(), steps.end());
  return static_cast<double>(std::unique(steps.begin(), steps.end()) - steps.begin()) * kStep_m;
}

// Fits the limits of both sides, and reports by how much the road lost.
void finish(SampledRoad& samples, Road& road, Report& report) {
  int most = 0;
  for (const bool is_left : {true, false}) {
    const Widths widths = widths_of(road, is_left ? raised_left_m(road) : raised_right_m(road));
    std::vector<std::int16_t>& side = samples.channels[is_left ? kLeft : kRight];
    most = std::max(most, open_at_cuts(widths, samples.channels[kFromCut], side));
    (is_left ? road.width_limits.left : road.width_limits.right) = fit_width_limits(side, widths.whole, samples.first);
  }
  if (most > 0) report.add(Code::kRoadNarrowed, road.id.osm, most * kUnit_m);
}

void report_covered(const Road& road, const BuildingObstacles& beside, const SampledRoad& samples, Report& report) {
  if (const double covered = covered_m(beside, samples); covered > 0)
    report.add(Code::kBuildingOnRoad, road.id.osm, covered);
}

}  // namespace

std::vector<Road> limit_widths(std::vector<Road> roads, std::span<const Junction> junctions,
                               std::span<const map::Footprint> footprints, std::span<const OsmId> through_buildings,
                               Report& report) {
  const ObstructingFootprints standing(footprints);
  const std::vector<StripEnds> ends = ends_of(roads);
  std::vector<BuildingObstacles> beside(roads.size());
  std::vector<std::uint32_t> touched;
  for (std::uint32_t road = 0; road < roads.size(); ++road) {
    if (family_of(roads[road].surface) == Family::kOther) continue;
    beside[road] = find_building_obstacles(roads[road], ends[road], standing);
    if (!beside[road].obstacles.empty() || !beside[road].covered.empty()) touched.push_back(road);
  }
  std::vector<SampledRoad> samples(roads.size());
  const Connections connections = connections_of(roads);
  activate(roads, connections, touched, samples);
  for (const std::uint32_t road : touched) mark_obstacles(beside[road], samples[road]);
  mark_cuts(roads, junctions, samples);
  spread_all(connections, samples);
  for (std::size_t road = 0; road < roads.size(); ++road) {
    if (!samples[road].is_active()) continue;
    finish(samples[road], roads[road], report);
    if (!std::ranges::binary_search(through_buildings, roads[road].id.osm))
      report_covered(roads[road], beside[road], samples[road], report);
  }
  return roads;
}

}  // namespace citykiln::roads
