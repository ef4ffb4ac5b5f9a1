// The view along a street, from where a photographer would stand.
#pragma once

#include <optional>
#include <span>

#include "preview/camera/camera.h"
#include "preview/camera/scene_grid.h"
#include "preview/camera/view_probe.h"

namespace citykiln::preview {

/// The tiles, and what is known of them, from which views are chosen.
struct ViewScene {
  std::span<const bake::BakedTile> tiles;
  const SceneGrid& grid;
  ViewProbe look;              ///< Rays through the tiles.
  std::optional<Vec3> to_sun;  ///< Unit; empty: the sun is down, or not known.
};

/// The height of a photographer's eyes above the ground, metres.
inline constexpr double kEye_m = 1.7;

/// Returns true if a person sees freely from a place: nothing is within 2 m on any side, from the knees to the eyes,
/// and nothing within 7 m in the middle of the picture.
bool is_free_in_front(const ViewProbe& look, const Camera& camera);

/// Returns a copy of a level view, turned so that what was in its middle is a third of the picture's width from
/// one side.
/// @param side  1: at the left third, so that more of the right is seen; -1: at the right third.
Camera turned_by_a_third(const Camera& camera, int side);

/// Returns a view at eye height under the open sky (ViewProbe::place_above_ground()), with free space around and in
/// front of it (is_free_in_front()). Its kinds, the first that the scene has:
///
/// 1. along a street with buildings on both sides: the street's axis is at a third of the picture's width
/// 2. along any street or road, but not over a wide paved area such as a car park
/// 3. along a path
/// 4. over open land, towards what stands there
/// 5. at the core (SceneGrid::core_point()), above everything that is there
///
/// Kinds 1 to 4 are at eye height. The places of kinds 1 and 2 are those on asphalt nearest to the core, at most 900,
/// 10 m apart, and those on paving, at most 400. Each is tried along the directions in which one sees
/// farthest. The best has the largest product of: the share of the way ahead that has buildings on both sides within 18
/// m; the walls near the eye; the number of these buildings, up to 8; the sunlit share of their walls, if the sun is
/// up; the distance seen ahead; the variety of what the picture shows (content_of()). Alleys, views into the sun and
/// walls that fill the picture count less. The picture is turned to the sunlit side.
///
/// Deterministic. Cost: some 500,000 rays.
Camera street_view(const ViewScene& scene);

}  // namespace citykiln::preview
