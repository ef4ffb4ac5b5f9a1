// Assumes layers of bridges and tunnels whose layer is 0.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the tracks, in the same order, with assumed layers. A bridge whose layer is 0, tagged or not, gets the layer
/// of the bridges that have a node at one of its ends, if all of these with another layer than 0 agree; a tunnel the
/// layer of such tunnels. All other tracks keep their layers, and so do paths in tunnels, which are corridors in
/// buildings if their layer is 0. The result depends on ways that share end nodes. O(n log n) in bridges and tunnels.
std::vector<Track> with_assumed_layers(std::vector<Track> tracks);

/// Returns the tracks, in the same order, with higher layers for bridges that cross another of the same layer and share
/// no node with it. Above is a path, since it may climb most steeply; of others the bridge of the class with the higher
/// priority (land_cover_classes.inc: main roads over streets over railways), else the longer way, else the one with the
/// higher id. Its layer is one more than the other's; a bridge whose layer is 0 counts as layer 1. Diagnoses
/// kBridgeOrderAssumed for each bridge that is raised. O(n log n) in segments of bridges, and O(bridges that cross).
std::vector<Track> with_ordered_bridges(std::vector<Track> tracks, Report& report);

}  // namespace citykiln::map
