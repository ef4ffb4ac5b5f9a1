// Divides land into blocks and lots.
//
// | step | file | what |
// |---|---|---|
// | 1 | rights_of_way | lines become rights-of-way, and their edges become chains |
// | 2 | edge_owners | rays from the edges say which building each part of an edge belongs to |
// | 3 | field | a place belongs to the nearest part of an edge that it sees |
// | 4 | lot_borders | lines along which that changes |
// | 5 | faces | all lines are snap-rounded into faces, each with a label |
// | 6 | lots_of_faces | connected faces of a label become lots; blocks are connected land |
// | 7 | sections, empty_lots | if asked for: land without buildings is split, then steps 5 and 6 run again |
#pragma once

#include "compiler/parcels/parcels.h"

namespace citykiln::parcels {

/// A lot depends only on lines, taken land and footprints that come within this distance of it, in metres. A line or
/// footprint counts as a whole: its id and all its points may matter if a part of it is that near.
///
/// A lot's points lie within kDepth_m of their street edge, and the sight line to it ends there (64). The owner of a
/// part of a street edge follows from the nearest rays on both sides, at most two usual frontages away (128), each
/// kDepth_m long (64). Whether a building that a ray meets faces another street follows from streets within kDepth_m of
/// it, and from obstacles on the way to these (64). Whether a building is hidden follows from streets within kDepth_m
/// of all its sides; this adds its length, up to 128. The sum is 448. Sections without buildings lie in cells of 128 m
/// and go on for up to two usual frontages (181 + 128 + 64 + 64 = 437); cells of faces have a diagonal of 181 m (64 +
/// 181 + 64). The largest sum is rounded up to a multiple of 128. A building longer than 128 m adds what it is longer.
inline constexpr double kInfluenceRadius_m = 512;

/// Divides the land within an extent.
///
/// Guarantees:
/// - rings are simple, snapped, and touch each other at vertices only. Lots and rest share no area and cover the
///   blocks; blocks share no area with rights-of-way or taken land
/// - a lot is connected, lies in one block and has a frontage on a street
/// - each footprint is in exactly one lot or failure; its lot is the one with the largest part of its area
/// - the result does not depend on the order of lines, taken rings and footprints, except for indices
/// - a lot depends only on what comes within kInfluenceRadius_m of it
/// Total: lines and rings may cross, overlap and repeat points.
/// @param threads  0: all processors.
/// Cost: about linear.
Parcels divide(const Land& land, int threads);

}  // namespace citykiln::parcels
