// Tests whether the land around a scene hides it from a camera.
#pragma once

#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// True if the eye is outside the tiles and either below the land there, or cannot see `look`, a place in the tiles,
/// because of land outside them. False if the header has no land around (Header::around).
/// @param tiles  The box of the tiles. @param eye, look  Plane metres.
bool is_hidden_by_land(const scene::Header& header, const Box2& tiles, Vec3 eye, Vec3 look);

}  // namespace citykiln::commands
