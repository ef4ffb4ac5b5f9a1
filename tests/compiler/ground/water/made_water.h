// Made-up terrain and water.
#pragma once

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "compiler/geometry/snap.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// Returns land of 4 km by 4 km from {0, 0}, with samples 32 m apart.
inline map::Heightfield made_land(const std::function<double(Vec2)>& height_m) {
  map::Heightfield land{{0, 0}, {32, 32}, 129, 129, {}, 0};
  for (int j = 0; j < land.rows; ++j)
    for (int i = 0; i < land.columns; ++i)
      land.heights.push_back(static_cast<std::int32_t>(height_m(land.vertex(i, j)) / map::kHeightQuantum_m));
  return land;
}

inline roads::Strip made_stream(std::int64_t id, Polyline axis, double width_m = 4) {
  return {{{OsmType::kWay, id}, 0}, std::move(axis), map::LandCoverClass::kRiver, width_m / 2, width_m / 2};
}

inline LandCoverPolygon made_water(std::int64_t id, map::LandCoverClass surface, Ring ring) {
  if (signed_area_m2(ring) < 0) std::ranges::reverse(ring);
  const auto area_m2 = static_cast<std::uint32_t>(signed_area_m2(ring));
  return {{{OsmType::kWay, id}, 0}, surface, area_m2, {std::move(ring)}};
}

/// Returns a square shore of 32 edges about a point.
inline Ring made_shore(Vec2 centre, double radius_m) {
  Ring ring;
  for (int i = 0; i < 8; ++i) ring.push_back(centre + Vec2{radius_m, -radius_m + radius_m * i / 4});
  for (int i = 0; i < 8; ++i) ring.push_back(centre + Vec2{radius_m - radius_m * i / 4, radius_m});
  for (int i = 0; i < 8; ++i) ring.push_back(centre + Vec2{-radius_m, radius_m - radius_m * i / 4});
  for (int i = 0; i < 8; ++i) ring.push_back(centre + Vec2{-radius_m + radius_m * i / 4, -radius_m});
  return ring;
}

}  // namespace citykiln::ground
