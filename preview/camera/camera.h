// Cameras, and views that are found by name.
#pragma once

#include <span>
#include <string>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"

namespace citykiln::preview {

/// A pinhole camera in the plane, metres, z up.
struct Camera {
  Vec3 eye, look_at;
  double vertical_fov_deg = 45;
};

/// A named view of a scene: "overview" (from the south-east, all of it), "street", "top", "north", "south", "east",
/// "west", "low". A function of the tiles' content. Error: an unknown name; the message lists the known ones.
Result<Camera> named_view(std::span<const bake::BakedTile> tiles, const std::string& name);

}  // namespace citykiln::preview
