// Rays that judge views, and the places where a person could stand.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "preview/camera/camera.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// Directions that are tried at each place.
inline constexpr int kDirections = 24;

/// The unit vector of a direction 0 … kDirections - 1, counter-clockwise from east; other numbers go round.
Vec3 level(int direction);

/// Casts rays in the plane's frame.
struct ViewProbe {
  const World& world;

  /// Length of free sight, at most `limit`.
  double sight_m(Vec3 from, Vec3 direction, double limit) const;
  /// Whether the ray ends on a wall or roof nearer than this.
  bool meets_building(Vec3 from, Vec3 direction, double near) const;
  /// The least free sight in all level directions, at most `limit`.
  double room_m(Vec3 from, double limit) const;
  /// Length of free sight ahead for a person: at eye height, past parapets below, and a few degrees to both sides.
  double walk_m(Vec3 eye, Vec3 direction, double limit) const;
};

/// The farthest surface of 9 by 9 rays through a square picture; infinity if any of them meets nothing.
double farthest_in_picture_m(const World& world, const Camera& camera);

/// Middles of the triangles of some materials, the nearest to `core` first, at least `apart_m` apart, at most `count`.
/// O(n log n).
std::vector<Vec3> places_near(std::span<const bake::BakedTile> tiles, Vec3 core,
                              const std::function<bool(materials::Material)>& counts, double apart_m, int count);

}  // namespace citykiln::preview
