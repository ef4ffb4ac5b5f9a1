// A baked tile for tests: a square of one feature, flat or sloping.
#pragma once

#include <array>
#include <cstddef>

#include "compiler/bake/baked_tile.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::verify {

inline constexpr OsmId kGroundFeature{OsmType::kWay, 1};

/// Returns a tile with a square of 64 m from the plane's origin. The tile's origin is (0, 0, 10).
/// @param corners_m  Heights of the south-western, south-eastern, north-eastern and north-western corner above the
/// tile's origin.
inline bake::BakedTile made_ground(map::LandCoverClass surface, std::array<float, 4> corners_m) {
  bake::BakedTile tile{{0, 0}, {0, 0, 10}, 0.1, 0, {OsmId{}, kGroundFeature}, {}, {}};
  bake::Primitive ground;
  ground.material = map::values_of(surface).material;
  ground.positions = {{0, 0, corners_m[0]}, {64, 0, corners_m[1]}, {64, 64, corners_m[2]}, {0, 64, corners_m[3]}};
  ground.features = {1, 1, 1, 1};
  ground.triangles = {{0, 1, 2}, {0, 2, 3}};
  tile.primitives = {ground};
  return tile;
}

inline constexpr Box2 kMadeBox{{0, 0}, {64, 64}};

}  // namespace citykiln::verify
