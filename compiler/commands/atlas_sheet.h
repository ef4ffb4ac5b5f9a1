// A picture of all facade pictures of a run: windows, doors, shop fronts, facades.
#pragma once

#include <string>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Draws the colours of all pictures on the facade atlases of a run, each once, with its width and height in metres
/// below it, and prints their number.
/// @param input  A .glb, or the folder of a run, whose tiles of level 0 are read.
/// @param path   The picture to write.
/// Errors: files that cannot be read; no atlas; those of writing the picture.
Result<Done> draw_atlas_sheet(const std::string& input, const std::string& path, const Console& console);

}  // namespace citykiln::commands
