// Rays that judge views, and places where a person could stand.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "preview/camera/camera.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// Level directions that are tried at each place.
inline constexpr int kDirections = 24;

/// Returns the unit vector of a level direction 0 … kDirections - 1, counter-clockwise from east. Other numbers wrap
/// around.
Vec3 horizontal(int direction);

/// Rays in a world. Positions are plane metres, directions are unit vectors.
struct ViewProbe {
  const World& world;

  /// Returns the distance to the first surface along a ray, at most `limit` metres.
  double sight_m(Vec3 from, Vec3 direction, double limit) const;
  /// True if the ray's first hit is a wall or roof nearer than `near` metres.
  bool meets_building(Vec3 from, Vec3 direction, double near) const;
  /// Returns the least sight_m() of all level directions.
  double room_m(Vec3 from, double limit) const;
  /// Returns the free distance ahead of a person, at most `limit` metres: the least sight_m() at eye height, 1.2 m
  /// lower (where a parapet or rising ground may be in the way), and a few degrees to both sides.
  double walk_m(Vec3 eye, Vec3 direction, double limit) const;
};

/// Returns the distance of the farthest surface that 9 by 9 rays through a square picture hit; infinity if any of the
/// rays hits nothing.
double farthest_in_picture_m(const World& world, const Camera& camera);

/// Returns the middles of triangles, the nearest to `core` first, at least `apart_m` apart, at most `count`. O(n log
/// n).
/// @param counts  True for the materials whose triangles are considered.
std::vector<Vec3> places_near(std::span<const bake::BakedTile> tiles, Vec3 core,
                              const std::function<bool(materials::Material)>& counts, double apart_m, int count);

}  // namespace citykiln::preview
