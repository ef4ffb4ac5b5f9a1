// Rooms behind window panes. Tiles have no rooms: a room is a box that is computed from the pane that a ray passes.
#pragma once

#include <optional>

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"
#include "preview/samples.h"

namespace citykiln::preview {

/// A rectangular pane in a wall, in the world's frame.
struct Pane {
  Vec3 corner{};                  ///< Lower left corner, seen from outside.
  Vec3 across{}, up{}, inward{};  ///< Unit vectors at right angles; across is level, to the right.
  double width_m = 0, height_m = 0;
};

/// Returns the pane of which a triangle, counter-clockwise from outside, is one half. Empty: the triangle is not half
/// of a vertical rectangle with sides of at least 0.2 m.
std::optional<Pane> pane_of(const Vec3 (&triangle)[3]);

/// Returns the normal of window glass at a place: panes are slightly out of plane and bent, so that reflections of
/// straight lines break from pane to pane.
///
/// Panes are taken to be 1.5 m wide and 1.8 m high on a grid, whatever the mesh is: the normal tilts by up to 5 mrad
/// from pane to pane, and by up to 5 mrad more from the middle of a pane to its edges.
/// @param normal  Unit. Returned unchanged if it points up or down by more than 45 degrees, as on a skylight.
/// @param at      The place in the frame of the world, metres.
Vec3 out_of_plane(Vec3 normal, Vec3 at);

/// A path of light from outside through the pane to a surface of the room, and from there, perhaps by one more surface,
/// to the eye.
struct RoomWay {
  Vec3 from{}, direction{};  ///< A point of the pane, and the unit direction, outward, from which light comes.
  /// Radiance towards the eye per radiance from `direction`, divided by the density, without the losses in the glass;
  /// 0: no light.
  Rgb weight{};
  Vec3 seen_at{};  ///< The first surface of the room that the eye sees.
  Rgb albedo{};    ///< The reflectance at seen_at.
  Vec3 normal{};   ///< The unit normal at seen_at, into the room.
};

/// Follows a ray into a room and out again.
///
/// The room is deeper and wider than the pane, by amounts that depend on the pane's place in the plane (`origin` is the
/// world's). Its floor is where floors usually are below panes of this height. Its walls are plain and matt. Unbiased
/// for up to one further reflection in the room.
/// @param at         On the pane.
/// @param direction  Unit, inward.
RoomWay way_through_room(const Pane& pane, Vec3 origin, Vec3 at, Vec3 direction, PathDraw& draw);

}  // namespace citykiln::preview
