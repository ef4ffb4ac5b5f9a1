// Assumes layers of bridges and tunnels that have no layer tag.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the tracks, in the same order, with assumed layers. A bridge without a layer gets the layer of the bridges
/// that have a node at one of its ends, if all of these that have a layer agree; a tunnel the layer of such tunnels.
/// All other tracks keep layer 0, and so do paths in tunnels without a layer, which are corridors in buildings. The
/// result depends on ways that share end nodes. O(n log n) in bridges and tunnels.
std::vector<Track> with_assumed_layers(std::vector<Track> tracks);

}  // namespace citykiln::map
