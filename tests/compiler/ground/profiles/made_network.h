// Networks and heightmaps for tests of profiles.
#pragma once

#include <algorithm>
#include <functional>

#include "compiler/contract/random_sequence.h"
#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/roads/roads_on_ground.h"

namespace citykiln::ground {

inline constexpr auto kStreet = map::LandCoverClass::kResidentialRoad;
inline constexpr auto kFootway = map::LandCoverClass::kPavedFootPath;

/// Returns a heightfield about the origin with the heights of a function.
inline map::Heightfield field_from(const std::function<double(double, double)>& height_m, double half_m = 2048,
                                   double step_m = 64) {
  const int n = static_cast<int>(2 * half_m / step_m) + 1;
  map::Heightfield field{{-half_m, -half_m}, {step_m, step_m}, n, n, {}, 0};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      field.heights.push_back(static_cast<std::int32_t>(
          std::floor(height_m(-half_m + i * step_m, -half_m + j * step_m) / map::kHeightQuantum_m)));
  return field;
}

/// Returns hills of `hills_m`, with noise of `noise_m` like that of radar samples.
inline map::Heightfield hilly_field(std::uint64_t seed, double hills_m, double noise_m, double half_m = 2048) {
  const RandomSequence draw(seed, StableId{1}, "hills");
  std::uint32_t next = 0;
  return field_from(
      [&](double x, double y) {
        const auto wave = [](double v) { return v - std::floor(v); };
        const auto bump = [&](double v) { return 4 * wave(v) * (1 - wave(v)); };
        return 100 + hills_m * bump(x / 611 + 0.2) * bump(y / 733 + 0.4) + draw.between(-noise_m, noise_m, next++);
      },
      half_m);
}

/// A way. The id of a map node is a function of its position.
inline map::Track track(std::int64_t id, Polyline axis,
                        map::LandCoverClass surface = map::LandCoverClass::kResidentialRoad,
                        map::Passage passage = map::Passage::kGround, int layer = 0) {
  map::Track t;
  t.id = {{OsmType::kWay, id}, 0};
  t.surface = surface;
  t.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  t.passage = passage;
  t.layer = static_cast<std::int8_t>(layer);
  for (const Vec2 p : axis)
    t.node_ids.push_back(static_cast<std::int64_t>(p.x * 128) * 100000000 + static_cast<std::int64_t>(p.y * 128));
  t.axis = std::move(axis);
  return t;
}

/// Returns streets every 96 m or so, bent and shifted.
inline map::Features street_grid(std::uint64_t seed, int count, Vec2 from = {-480, -480}) {
  constexpr map::LandCoverClass kClasses[] = {map::LandCoverClass::kResidentialRoad, map::LandCoverClass::kServiceRoad,
                                              map::LandCoverClass::kTertiaryRoad, map::LandCoverClass::kFarmTrack};
  const RandomSequence draw(seed, StableId{2}, "streets");
  const auto at = [&](int i, int j) {
    const auto index = static_cast<std::uint32_t>((i + 100) * 1000 + j + 100) * 2;
    return Vec2{std::floor((from.x + 96 * i + draw.between(-20, 20, index)) * 128) / 128,
                std::floor((from.y + 96 * j + draw.between(-20, 20, index + 1)) * 128) / 128};
  };
  map::Features f;
  std::int64_t id = 0;
  for (int k = 0; k < count; ++k) {
    Polyline along, across;
    for (int i = 0; i < count; ++i) along.push_back(at(i, k)), across.push_back(at(k, i));
    const auto c = static_cast<std::uint32_t>(k);
    f.tracks.push_back(track(++id, along, kClasses[draw.below(4, c)]));
    f.tracks.push_back(track(++id, across, kClasses[draw.below(4, c + 1000)]));
  }
  return f;
}

struct Planned {
  Profiles profiles;
  ProfileMeasures measures;
  Report report;
  std::vector<roads::Junction> junctions;
};

inline Planned planned(map::Features features, const map::Heightfield& heights) {
  Planned p;
  map::Features sorted = features;
  std::ranges::sort(sorted.tracks, {}, &map::Track::id);
  std::vector<roads::Road> roads = roads::roads_on_ground(sorted, p.report);
  p.junctions = roads::plan_junctions(roads, p.report);
  p.profiles = plan_profiles(features, roads, p.junctions, {}, {}, heights, p.report);
  p.measures = measure_profiles(features, p.profiles);
  return p;
}

inline double height_m(const Profile& profile, double at_m) { return profile.empty() ? 0 : knot_at(profile, at_m).z_m; }

}  // namespace citykiln::ground
