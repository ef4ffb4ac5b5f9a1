// Layers of bridges and tunnels that have no layer tag.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the tracks, in the same order, in which a bridge without a layer has that of the bridges which it continues
/// at its ends, where all of these with a layer have the same; a tunnel has that of the tunnels which it continues.
/// Others keep layer 0, and so do paths in tunnels: without a layer they are corridors in buildings. Depends on ways
/// that share a node with the end of another. O(n log n) in bridges and tunnels.
std::vector<Track> with_assumed_layers(std::vector<Track> tracks);

}  // namespace citykiln::map
