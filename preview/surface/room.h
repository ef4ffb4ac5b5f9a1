// Rooms behind window panes, which tiles do not hold: boxes, made by the pane that a ray passes.
#pragma once

#include <optional>

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"
#include "preview/samples.h"

namespace citykiln::preview {

/// A rectangular pane of a wall, in the world's frame.
struct Pane {
  Vec3 corner{};                  ///< The lower left one, seen from outside.
  Vec3 across{}, up{}, inward{};  ///< Unit, at right angles; across is level, to the right.
  double width_m = 0, height_m = 0;
};

/// The pane of which a triangle, counter-clockwise from outside, is one half. Empty: it is not half of an upright
/// rectangle of at least 0.2 m.
std::optional<Pane> pane_of(const Vec3 (&triangle)[3]);

/// A way of light through the pane to a surface of the room, and from there, perhaps by other surfaces, towards the
/// eye. The pane itself, passed twice, is not part of `weight`.
struct RoomWay {
  Vec3 from{}, direction{};  ///< A point of the pane, and the unit direction, outward, from which light comes.
  Rgb weight{};              ///< Light towards the eye per light from there, over the density; 0: no light.
  Vec3 seen_at{};            ///< The first surface of the room that the eye sees.
  Rgb albedo{};              ///< Its reflectance.
  Vec3 normal{};             ///< Of it, unit, into the room.
};

/// Follows a ray into a room and out again.
///
/// The room is deeper and wider than the pane, by amounts that depend on the pane's place (in the plane: `origin` is
/// the world's), with its floor where floors usually are below panes of this height. Its walls are plain and matt.
/// Unbiased for one further reflection in the room.
/// @param at  On the pane. @param direction  Unit, inward.
RoomWay way_through_room(const Pane& pane, Vec3 origin, Vec3 at, Vec3 direction, PathDraw& draw);

}  // namespace citykiln::preview
