#include "compiler/ground/water/standing_water.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "compiler/geometry/profile.h"
#include "compiler/geometry/snap.h"

namespace citykiln::ground {
namespace {

// Docks and lagoons beside the sea are at its level where their shores are no higher than this: quays, and noise of
// heightmaps beside houses.
constexpr double kSeaShore_m = 8;
// Edges this many times longer than the median are not part of the shore.
constexpr double kLongEdge = 8;
// A shore is sampled twice per grid step, an edge at most this often.
constexpr int kMaxSamples = 64;
// Least distance from the level of a misplaced vertex and of the middles of its edges. Cliffs over fjords are nearer to
// their water.
constexpr double kSpikeEnd_m = 50, kSpikeSide_m = 20;

struct Sample {
  double height_m, length_m;
};

double median_edge_m(const Ring& ring) {
  std::vector<double> lengths;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) lengths.push_back(distance(ring[j], ring[i]));
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

void sample_edge(Vec2 a, Vec2 b, const map::Heightfield& heights, bool clips, std::vector<Sample>& samples) {
  const double length_m = distance(a, b);
  const int n = static_cast<int>(
      std::clamp(std::ceil(length_m / (heights.shorter_sample_step_m() / 2)), 1.0, double{kMaxSamples}));
  for (int i = 0; i < n; ++i) {
    const Vec2 p = a + (b - a) * ((i + 0.5) / n);
    if (!clips || heights.box().contains(p)) samples.push_back({height_m_at(heights, p), length_m / n});
  }
}

bool is_one_of(std::span<const Edge> edges, Vec2 a, Vec2 b) {
  return std::ranges::binary_search(edges, Edge{std::min(a, b), std::max(a, b)});
}

std::vector<Sample> sample_shore(std::span<const Ring> rings, const map::Heightfield& heights,
                                 std::span<const Edge> shared, bool clips) {
  std::vector<Sample> samples;
  for (const Ring& ring : rings) {
    if (ring.size() < 3) continue;
    const double longest_m = clips ? median_edge_m(ring) * kLongEdge : INFINITY;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      if (distance(ring[j], ring[i]) <= longest_m && !is_one_of(shared, ring[j], ring[i]))
        sample_edge(ring[j], ring[i], heights, clips, samples);
  }
  return samples;
}

// Returns the lowest height with more than this share of the shore at or below it. Samples must be sorted.
double quantile_m(const std::vector<Sample>& samples, double length_m, double share) {
  double below_m = 0;
  for (const Sample& sample : samples) {
    below_m += sample.length_m;
    if (below_m > share * length_m) return sample.height_m;
  }
  return samples.empty() ? 0 : samples.back().height_m;
}

double level_of(double height_m) { return std::floor(height_m / kProfileQuantum_m) * kProfileQuantum_m; }

// The standing polygons, and each one's own shore.
struct Standing {
  std::vector<std::uint32_t> members;
  std::vector<Edge> shared;
  std::vector<Shore> shores;
};

Standing ask_shores(std::span<const LandCoverPolygon> surfaces, const std::vector<bool>& stands,
                    const map::Heightfield& heights) {
  Standing standing;
  for (std::uint32_t i = 0; i < surfaces.size(); ++i)
    if (stands[i]) standing.members.push_back(i);
  standing.shared = edges_between(surfaces, standing.members);
  for (const std::uint32_t i : standing.members)
    standing.shores.push_back(shore_of(surfaces[i].rings, heights, standing.shared));
  return standing;
}

bool is_sea(const LandCoverPolygon& surface) { return surface.surface == map::LandCoverClass::kSea; }

// Returns whether two polygons with a common border are one water.
bool are_level(const LandCoverPolygon& a, const Shore& shore_a, const LandCoverPolygon& b, const Shore& shore_b) {
  if (is_sea(a) && is_sea(b)) return true;
  if (is_sea(a)) return shore_b.low_m <= kSeaShore_m;
  if (is_sea(b)) return shore_a.low_m <= kSeaShore_m;
  return std::abs(shore_a.low_m - shore_b.low_m) <= kDam_m;
}

std::vector<std::uint32_t> group_levels(std::span<const LandCoverPolygon> surfaces, const Standing& standing) {
  auto pairs = shared_borders(surfaces, standing.members);
  std::erase_if(pairs, [&](const auto& pair) {
    return !are_level(surfaces[standing.members[pair.first]], standing.shores[pair.first],
                      surfaces[standing.members[pair.second]], standing.shores[pair.second]);
  });
  return groups_of(standing.members.size(), pairs);
}

// Joins polygons to one water; their common edges are no shore.
StandingWater water_of(std::span<const LandCoverPolygon> surfaces, std::span<const std::uint32_t> members,
                       std::span<const Edge> shared, const map::Heightfield& heights) {
  StandingWater water{.id = surfaces[members.front()].id};
  std::vector<Ring> rings;
  for (const std::uint32_t i : members) {
    water.id = std::min(water.id, surfaces[i].id);
    water.is_sea |= is_sea(surfaces[i]);
    rings.insert(rings.end(), surfaces[i].rings.begin(), surfaces[i].rings.end());
  }
  const Shore shore = shore_of(rings, heights, shared);
  water.shore_m = std::floor(shore.length_m) + 1;
  water.level_m = water.is_sea ? 0 : level_of(shore.low_m);
  return water;
}

void diagnose_seas(std::span<const LandCoverPolygon> surfaces, const Standing& standing, Report& report) {
  for (std::size_t m = 0; m < standing.members.size(); ++m) {
    const double low_m = standing.shores[m].low_m;
    if (is_sea(surfaces[standing.members[m]]) && std::abs(low_m) > kSeaShore_m)
      report.add(Code::kSeaLevelOffShore, surfaces[standing.members[m]].id.osm, std::abs(low_m));
  }
}

}  // namespace

bool is_standing(map::LandCoverClass surface) {
  return map::values_of(surface).group == map::LandCoverGroup::kWater && surface != map::LandCoverClass::kRiver &&
         surface != map::LandCoverClass::kStream;
}

Shore shore_of(std::span<const Ring> rings, const map::Heightfield& heights, std::span<const Edge> shared) {
  assert(std::ranges::is_sorted(shared));
  std::vector<Sample> samples = sample_shore(rings, heights, shared, true);
  if (samples.empty()) samples = sample_shore(rings, heights, {}, false);
  std::ranges::sort(samples, {}, [](const Sample& s) { return std::pair(s.height_m, s.length_m); });
  Shore shore;
  for (const Sample& sample : samples) shore.length_m += sample.length_m;
  shore.low_m = quantile_m(samples, shore.length_m, kShoreQuantile);
  shore.high_m = quantile_m(samples, shore.length_m, 1 - kShoreQuantile);
  return shore;
}

StandingWaters find_standing_waters(std::span<const LandCoverPolygon> surfaces, const std::vector<bool>& stands,
                                    const map::Heightfield& heights, Report& report) {
  assert(stands.size() == surfaces.size());
  const Standing standing = ask_shores(surfaces, stands, heights);
  diagnose_seas(surfaces, standing, report);
  const std::vector<std::uint32_t> group = group_levels(surfaces, standing);
  std::map<std::uint32_t, std::vector<std::uint32_t>> members_of;
  for (std::size_t m = 0; m < group.size(); ++m) members_of[group[m]].push_back(standing.members[m]);

  std::vector<std::pair<StandingWater, std::vector<std::uint32_t>>> found;
  for (const auto& [first, members] : members_of)
    found.emplace_back(water_of(surfaces, members, standing.shared, heights), members);
  std::ranges::sort(found, {}, [](const auto& f) { return f.first.id; });
  StandingWaters waters{{}, std::vector<std::uint32_t>(surfaces.size(), kNoWater)};
  for (const auto& [water, members] : found) {
    for (const std::uint32_t i : members) waters.water_of[i] = static_cast<std::uint32_t>(waters.waters.size());
    waters.waters.push_back(water);
  }
  return waters;
}

LandCoverPolygon without_spikes(LandCoverPolygon surface, double level_m, const map::Heightfield& heights,
                                Report& report) {
  const auto off_m = [&](Vec2 p) { return std::abs(height_m_at(heights, p) - level_m); };
  for (Ring& ring : surface.rings) {
    if (ring.size() < 5) continue;
    const double longest_m = median_edge_m(ring) * kLongEdge;
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 before = ring[(i + ring.size() - 1) % ring.size()], at = ring[i], after = ring[(i + 1) % ring.size()];
      const bool is_far = distance(before, at) > longest_m && distance(at, after) > longest_m;
      const bool is_spike = is_far && heights.box().contains(at) && off_m(at) > kSpikeEnd_m &&
                            off_m((before + at) * 0.5) > kSpikeSide_m && off_m((at + after) * 0.5) > kSpikeSide_m;
      if (is_spike) report.add(Code::kShoreSpike, surface.id.osm, distance(at, before));
      if (!is_spike) kept.push_back(at);
    }
    if (kept.size() >= 3) ring = std::move(kept);
  }
  return surface;
}

}  // namespace citykiln::ground
