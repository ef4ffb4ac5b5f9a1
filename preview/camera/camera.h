// Cameras, and the views of a scene by name.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"
#include "compiler/map/plane/cylinder.h"

namespace citykiln::preview {

/// The position of a camera and the point in the middle of its picture. Plane metres, z up.
struct Pose {
  Vec3 eye, look_at;
};

/// A camera in plane metres, z up (or inside of a cylinder, bent()): a pinhole or a thin lens, at rest or moving while
/// its shutter is open.
struct Camera {
  Vec3 eye, look_at;
  double vertical_fov_deg = 45;
  double lens_radius_m = 0;  ///< 0: a pinhole, everything is in focus.
  /// Distance from the eye to the plane in focus; 0: the distance of look_at.
  double focus_m = 0;
  /// The pose when the shutter closes. The camera moves there at constant speed. Empty: the camera is at rest.
  std::optional<Pose> shutter_end{};
  Vec3 up{0, 0, 1};  ///< The vertical at the eye: unit.
};

/// Returns a camera of the plane inside of a cylinder: its poses are bent point by point, and its vertical turned.
Camera bent(Camera camera, const map::Cylinder& cylinder);

/// Returns a camera that shows a scene from a view by name: "street" (street_view.h); "low", over the roofs into the
/// densest part; "overview" (from the south-east, what is built); "top", "north", "south", "east", "west" (all of the
/// scene); and "square", "water" or "river", "park", "hilltop", "roofs", "skyline", which a scene may lack
/// (place_views.h). No eye is below the ground or under a roof. The camera depends only on the tiles' content and the
/// sun. Errors: an unknown name, with the known ones in the message; a scene without such a place.
/// @param to_sun  Unit; views are lit from the side where there is a choice. Empty: the sun is down.
Result<Camera> named_view(std::span<const bake::BakedTile> tiles, const std::string& name,
                          std::optional<Vec3> to_sun = {});

}  // namespace citykiln::preview
