// Overlapping polygons with many corners that cross the cell's border.
#pragma once

#include <cmath>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/arrangement.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

inline constexpr Box2 kWavyCell{{-128, 0}, {0, 128}};

/// Returns lobed rings of 60 corners with noise, of all sizes, in and about kWavyCell.
inline std::vector<LandCoverPolygon> wavy_surfaces(std::uint64_t seed, int count, double noise_m) {
  constexpr map::LandCoverClass kClasses[] = {map::LandCoverClass::kMeadow, map::LandCoverClass::kForest,
                                              map::LandCoverClass::kLake, map::LandCoverClass::kResidentialRoad,
                                              map::LandCoverClass::kBuilding};
  std::vector<LandCoverPolygon> surfaces;
  const RandomSequence draw(seed, StableId{20}, "surfaces");
  std::uint32_t next = 0;
  for (int s = 0; s < count; ++s) {
    const Vec2 centre{draw.between(-140, 12, next), draw.between(-12, 140, next + 1)};
    const double radius_m = draw.between(2, 40, next + 2);
    next += 3;
    Ring ring;
    for (int i = 0; i < 60; ++i, next += 2) {
      const double turn = 2 * 3.14159265 * i / 60;
      const double at_m = radius_m * (1 + 0.3 * std::sin(5 * turn));
      const Vec2 p{centre.x + at_m * std::cos(turn) + draw.between(-noise_m, noise_m, next),
                   centre.y + at_m * std::sin(turn) + draw.between(-noise_m, noise_m, next + 1)};
      ring.push_back(plane_point(grid_point(p)));
    }
    surfaces.push_back({{{OsmType::kWay, s + 1}, 0}, kClasses[s % 5], static_cast<std::uint32_t>(radius_m), {ring}});
  }
  return surfaces;
}

}  // namespace citykiln::ground
