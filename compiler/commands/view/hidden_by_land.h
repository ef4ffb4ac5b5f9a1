// Tests whether the land around a scene hides it from a camera.
#pragma once

#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// True if the eye is outside the tiles and either below the land there, or cannot see `look`, because land outside the
/// tiles is in the way. False if the header has no land around (Header::around).
/// @param tiles      The box of the tiles.
/// @param eye, look  Plane metres; `look` is a place in the tiles.
bool is_hidden_by_land(const scene::Header& header, const Box2& tiles, Vec3 eye, Vec3 look);

}  // namespace citykiln::commands
