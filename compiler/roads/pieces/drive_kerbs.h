// Where drives of yards cross the pavement, the kerb is lower, as at crossings (dropped_kerbs.h).
//
//      lot        ║drive║
//     ────────────╨──▲──╨─────────   the mouth of the drive, at the border of the lot
//     pavement       │ outward
//     ───────╲_______▼_____╱──────   kerb: kDriveKerb_m are low
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/pieces/dropped_kerbs.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {

/// The length of a kerb that is lowered before a drive, in metres: a drive of 2.75 m, in kerbstones of 1 m.
inline constexpr double kDriveKerb_m = 3;

/// The end of a drive towards the street, plane metres.
struct DriveMouth {
  Vec2 at;
  Vec2 outward;  ///< The direction to the street, a unit vector.
};

/// The part of a kerb before a drive, in metres along the way.
struct DriveKerb {
  double from_m = 0, to_m = 0;
  bool is_left = false;
  bool operator==(const DriveKerb&) const = default;
};

/// Returns the lowered kerbs of a street, sorted by from_m. A mouth gets one if it is within 2 m of the outer edge of
/// the pavement, its `outward` is within some 45° of the line square to the axis, and the kerb with its ramps lies on
/// the road, clear of junctions and crossings. from_m is a multiple of 0.25 m. The result is empty for roads that are
/// no streets; sides without a pavement get none. O(points · mouths near the road).
/// @param stretches  Result of with_dropped_kerbs().
/// @param intervals  The road's entry of junction_intervals_of().
std::vector<DriveKerb> drive_kerbs_of(const Road& road, std::span<const RoadStretch> stretches,
                                      std::span<const JunctionInterval> intervals, std::span<const DriveMouth> mouths);

/// Returns stretches cut where kerbs begin to fall and are low, so that the ground has an edge there.
std::vector<RoadStretch> cut_at_drives(std::span<const RoadStretch> stretches, std::span<const DriveKerb> drives);

/// Adds the ramps of kerbs before drives, each on the side of its drive.
void add_drive_ramps(const Road& road, std::span<const DriveKerb> drives, std::vector<KerbRamp>& ramps);

/// Returns the ramps before drives of all roads of a tile.
/// @param assumes  True if kerbs at crossings are assumed, as for with_dropped_kerbs().
std::vector<KerbRamp> drive_ramps_of(std::span<const Road> roads, std::span<const Junction> junctions, double tile_m,
                                     bool assumes, std::span<const DriveMouth> mouths);

}  // namespace citykiln::roads
