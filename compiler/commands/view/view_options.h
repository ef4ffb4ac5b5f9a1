// Parsers of the viewer options that preview and bake share.
#pragma once

#include <functional>
#include <optional>

#include "compiler/commands/verb.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/vec.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// The size of a picture in pixels.
struct PictureSize {
  int width = 1280, height = 720;
};

/// A point as given on the command line: in plane metres, or as longitude and latitude in degrees and height in metres.
struct GivenPoint {
  Vec3 at;
  bool is_above_ground = false;  ///< True: the height is above the ground; false: above sea level.
};

/// Stores three numbers, "X,Y,Z" or "LON,LAT,HEIGHT". A height such as "+2" is above the ground.
StoreValue store_point(std::optional<GivenPoint>& point);
/// Stores "X,Y,Z".
StoreValue store_point(std::optional<Vec3>& point);

/// Stores "1280x720".
StoreValue store_size(PictureSize& size);

/// The allowed fields of view, in degrees.
inline constexpr NumberRange kFieldsOfView_deg{0, 180};

/// Returns the height of the ground at a place, in plane metres; empty outside the scene.
using GroundHeight = std::function<std::optional<double>(Vec2)>;

/// Returns a point in plane metres; empty if neither argument is given. Errors: longitude and latitude without a
/// header, which defines the plane; a height above the ground where there is no ground.
/// @param in_plane, lonlat  The point in plane metres, or as longitude, latitude and height. At most one is given.
/// @param ground_m          The height of the ground.
Result<std::optional<Vec3>> point_of(const std::optional<GivenPoint>& in_plane, const std::optional<GivenPoint>& lonlat,
                                     const std::optional<scene::Header>& header, const GroundHeight& ground_m);

/// Prints a note if the eye is below the ground.
void note_if_below_ground(Vec3 eye, const GroundHeight& ground_m, const Console& console);

}  // namespace citykiln::commands
