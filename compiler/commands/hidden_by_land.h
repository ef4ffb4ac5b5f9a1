// Whether the land around a scene hides it from a camera.
#pragma once

#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// Whether an eye outside of the tiles is below the land around, or land outside of the tiles is between it and a place
/// in them. False where nothing is known of the land around.
/// @param tiles  The box of the tiles. @param eye, look  Plane metres.
bool is_hidden_by_land(const scene::Header& header, const Box2& tiles, Vec3 eye, Vec3 look);

}  // namespace citykiln::commands
