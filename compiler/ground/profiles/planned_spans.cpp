#include "compiler/ground/profiles/planned_spans.h"

#include <algorithm>

#include "compiler/ground/grading/span_influence.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/roads/roads_on_ground.h"

namespace citykiln::ground {
namespace {

struct Samples {
  int all = 0, covered = 0;
};

Samples sample_cover(const roads::Road& tunnel, double from_m, double to_m, const map::Heightfield& heights) {
  const double ceiling_m = bore_height_m(tunnel);
  const std::vector<double> along = roads::distances_along(tunnel.axis, 0);
  Samples samples;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const double long_m = along[i + 1] - along[i];
    for (double at_m = along[i]; at_m < along[i + 1]; at_m += kCoverSample_m) {
      if (at_m < from_m || at_m > to_m) continue;
      const Vec2 at = tunnel.axis[i] + (tunnel.axis[i + 1] - tunnel.axis[i]) * ((at_m - along[i]) / long_m);
      ++samples.all;
      samples.covered += height_m_at(heights, at) >= knot_at(tunnel.profile, at_m).z_m + ceiling_m;
    }
  }
  return samples;
}

// Samples as structures::is_underground() does, which also knows how a tunnel ends.
bool is_bored(const roads::Road& tunnel, const map::Heightfield& heights) {
  if (tunnel.profile.empty()) return false;
  const double long_m = roads::distances_along(tunnel.axis, 0).back();
  const double end_m = std::min(kPortalLength_m, std::max(0.0, long_m / 2 - kCoverSample_m));
  const Samples samples = sample_cover(tunnel, end_m, long_m - end_m, heights);
  return samples.covered >= kMinCoveredShare * samples.all;
}

// The place at a distance along a road that is not trimmed.
Vec2 place_on_road(const roads::Road& road, const std::vector<double>& along, double at_m) {
  std::size_t i = 0;
  while (i + 2 < along.size() && along[i + 1] < at_m) ++i;
  const double share = std::clamp((at_m - along[i]) / (along[i + 1] - along[i]), 0.0, 1.0);
  return road.axis[i] + (road.axis[i + 1] - road.axis[i]) * share;
}

}  // namespace

bool enters_from_above(const roads::Road& tunnel, const map::Heightfield& heights) {
  // a way farther below the ground has come down before the tunnel begins
  constexpr double kBelowGround_m = 1.75;
  const bool is_path = map::values_of(tunnel.surface).group == map::LandCoverGroup::kPath;
  if (tunnel.profile.empty() || !(is_path || tunnel.surface == map::LandCoverClass::kServiceRoad)) return false;
  const std::vector<double> along = roads::distances_along(tunnel.axis, 0);
  const double long_m = along.back(), inside_m = std::min(kPortalLength_m, long_m / 2);
  const auto goes_down = [&](double end_m, double inner_m) {
    const double z_m = knot_at(tunnel.profile, end_m).z_m;
    return z_m > height_m_at(heights, place_on_road(tunnel, along, end_m)) - kBelowGround_m &&
           height_m_at(heights, place_on_road(tunnel, along, inner_m)) < z_m + bore_height_m(tunnel) / 2;
  };
  return goes_down(0, inside_m) || goes_down(long_m, long_m - inside_m);
}

PlannedSpans planned_spans(const map::FeatureView& features, const Profiles& profiles,
                           const map::Heightfield& heights) {
  PlannedSpans spans;
  std::size_t off = 0;
  for (const map::Track& track : features.tracks) {
    if (!leaves_ground(track)) continue;
    const Profile& profile = profiles.off_ground[off++];
    if (!has_profile(track.surface)) continue;
    roads::Road road = roads::road_of(track);
    road.profile = profile;
    if (track.passage == map::Passage::kBridge)
      spans.decks.push_back(std::move(road));
    else if (is_bored(road, heights) && !enters_from_above(road, heights))
      spans.bores.push_back(std::move(road));
  }
  return spans;
}

}  // namespace citykiln::ground
