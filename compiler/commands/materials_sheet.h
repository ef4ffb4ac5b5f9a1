// A picture of all materials that have textures.
#pragma once

#include <string>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Draws all materials with textures, each with its name: a sphere with a diameter of 1 m, a wall and the ground, in
/// the light of sheet_sky(). Takes about two minutes of CPU time. Errors: those of writing the picture.
Result<Done> draw_materials_sheet(const std::string& path, const Console& console);

}  // namespace citykiln::commands
