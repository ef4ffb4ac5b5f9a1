// The ends of the drives of a tile's yards, before which kerbs are lower.
#pragma once

#include <vector>

#include "compiler/roads/pieces/drive_kerbs.h"
#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// Returns the ends towards the street of the drives of all yards that a chunk knows. Empty if the header has no street
/// furniture (--assume roadsides). O(strips).
std::vector<roads::DriveMouth> drive_mouths_of(const Header& header, const Chunk& chunk);

}  // namespace citykiln::scene
