// Divides land into blocks and lots.
//
// | step | file | what |
// |---|---|---|
// | 1 | strips | lines become strips, and their edges become chains |
// | 2 | fronts | rays from the edges say which building each part of an edge belongs to |
// | 3 | field | a place belongs to the nearest part of an edge that it sees |
// | 4 | lot_borders | lines along which that changes |
// | 5 | faces | all lines are snap-rounded into faces, each with a label |
// | 6 | lots_of_faces | connected faces of a label become lots; blocks are connected land |
#pragma once

#include "compiler/parcels/parcels.h"

namespace citykiln::parcels {

/// A lot depends only on lines, taken rings and footprints that come within this distance of it, in metres.
///
/// A lot's points lie within kDepth_m of its frontage (64), and the sight line to it ends there. The owner of a part of
/// a frontage follows from the rays of the parts beside it, up to two fronts away on each side (2 · 64, with
/// LotSize::front_m up to 64), each kDepth_m long (64); whether a building that a ray meets faces another street
/// follows from streets within kDepth_m of it (64), seen past obstacles within that; and whether it is a shed from
/// buildings within 25 m. Snap rounding is done in cells with a diagonal of 182 m, and triangulations of cells choose
/// the points by which faces are labelled. The sum is 64 + 128 + 64 + 64 + 25 < 345; or 64 + 182 + 64 = 310.
inline constexpr double kInfluenceRadius_m = 512;

/// Divides the land within an extent.
///
/// Guarantees:
/// - rings are simple, snapped, and touch each other at vertices only. Lots and rest share no area and cover the
///   blocks; blocks share no area with strips or taken land
/// - a lot is connected, lies in one block and has a front on a street
/// - each footprint is in exactly one lot or failure; its lot is the one with the largest part of its area
/// - the result does not depend on the order of lines, taken rings and footprints, except for indices
/// - a lot depends only on what comes within kInfluenceRadius_m of it
/// Total: lines and rings may cross, overlap and repeat points.
/// @param threads  0: all processors.
/// Cost: about linear.
Parcels divide(const Land& land, int threads);

}  // namespace citykiln::parcels
