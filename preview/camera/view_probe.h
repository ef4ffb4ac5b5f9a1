// Rays that judge views, and places where a person could stand.
#pragma once

#include <functional>
#include <optional>
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

/// True for materials of the ground that one can stand on: land, paved ground, markings, snow. Not water.
bool is_ground(materials::Material material);
/// True for materials of plants: bark, leaves, hedges.
bool is_plant(materials::Material material);

/// Rays in a world. Positions are plane metres, directions are unit vectors.
struct ViewProbe {
  const World& world;

  /// Returns the distance to the first surface along a ray, at most `limit` metres.
  double sight_m(Vec3 from, Vec3 direction, double limit) const;
  /// Returns the first surface along a ray that is no plant, with its distance from `from`. Gives up at the 256th leaf.
  std::optional<Hit> first_beyond_plants(Vec3 from, Vec3 direction) const;
  /// True if the ray's first hit is a wall or roof nearer than `near` metres.
  bool meets_building(Vec3 from, Vec3 direction, double near) const;
  /// Returns the least sight_m() of all level directions.
  double room_m(Vec3 from, double limit) const;
  /// True if nothing is above a place: a ray upwards meets only the sky.
  bool is_under_the_sky(Vec3 from) const;
  /// Returns the place at a height above the topmost ground at `at`, where a person or a tripod stands: nothing but
  /// plants is above the place, a metre or more. Empty: there is no ground, or something else is above the place.
  /// @param from_m  A height above all surfaces.
  std::optional<Vec3> place_above_ground(Vec2 at, double above_m, double from_m) const;
  /// Returns the free distance ahead of a person, at most `limit` metres: the least sight_m() at eye height, 1.2 m
  /// lower (where a parapet or rising ground may be in the way), and a few degrees to both sides.
  double walk_m(Vec3 eye, Vec3 direction, double limit) const;
};

/// Returns the distance of the farthest surface that 9 by 9 rays through a square picture hit; infinity if any of the
/// rays hits nothing.
double farthest_in_picture_m(const World& world, const Camera& camera);

/// The content of a wide picture, 16 by 9, by rays through it.
struct PictureContent {
  double variety_bits = 0;  ///< The entropy of the materials that the rays meet; the sky counts as a material.
  double close_walls = 0;   ///< The share of the rays that meet a building nearer than 7 m.
};
/// Returns what 32 by 18 rays through a picture meet. Views with much variety show more of a scene (Vázquez et al.
/// 2001, "Viewpoint selection using viewpoint entropy", there of faces).
PictureContent content_of(const World& world, const Camera& camera);

/// Returns places on triangles, the nearest to `core` first, at least `apart_m` apart, at most `count`. Large triangles
/// have several places. O(n log n).
/// @param counts  True for the primitives whose triangles are considered.
std::vector<Vec3> places_near(std::span<const bake::BakedTile> tiles, Vec3 core,
                              const std::function<bool(const bake::Primitive&)>& counts, double apart_m, int count);

}  // namespace citykiln::preview
