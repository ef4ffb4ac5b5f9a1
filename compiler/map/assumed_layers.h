// Assumes layers of bridges and tunnels whose layer is 0.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the tracks, in the same order, with assumed layers. A bridge whose layer is 0, tagged or not, gets the layer
/// of the bridges that have a node at one of its ends, if all of these with another layer than 0 agree; a tunnel the
/// layer of such tunnels. All other tracks keep their layers, and so do paths in tunnels, which are corridors in
/// buildings if their layer is 0. The result depends on ways that share end nodes. O(n log n) in bridges and tunnels.
std::vector<Track> with_assumed_layers(std::vector<Track> tracks);

}  // namespace citykiln::map
