// Stretches: a road cut across its length, where what is painted on it changes: before junctions, at crossings.
//
//     junction |  kStart  |        kAlong        | kZebra |   kAlong   |   kEnd  | junction
//              12 m at most                         4 m                  12 m at most
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// Where a junction lies on a road. Distances along the way, from its own beginning.
struct JunctionInterval {
  double at_m = 0;                   ///< Of the junction's place.
  double before_m = 0, after_m = 0;  ///< How far the junction reaches from there.
  Control before{}, after{};         ///< What drivers meet who come along the road; who come against it.
  bool is_change = false;            ///< Nothing but another width: nobody waits there.
};

/// The junctions of streets on each road, sorted along it. O(n log n).
std::vector<std::vector<JunctionInterval>> junction_intervals_of(std::span<const Road> roads,
                                                                 std::span<const Junction> junctions);

/// A part of a road with one pattern.
struct RoadStretch {
  double from_m = 0, to_m = 0;  ///< Along the way.
  StretchKind stretch = StretchKind::kAlong;
  Control control = Control::kNone;
  double zero_m = 0;  ///< Where the pattern's v is 0.
};

/// The runs of a road, from its first point to its last, without gaps.
///
/// An arm's approach (a crossing near the junction, 4 m; what is painted before the stop line, 12 m or what is left of
/// half the way to the next junction) needs 3 m.
/// @param tile_m  Of the plane's grid of tiles. Tiles know junctions within kJunctionHalo_m of them: an approach that
/// touches
///                several tiles is left out unless each of them knows all that it depends on, so that they agree.
std::vector<RoadStretch> stretches_of(const Road& road, std::span<const JunctionInterval> intervals, double tile_m);

/// How far beyond a tile all junctions are known.
inline constexpr double kJunctionHalo_m = 32;

}  // namespace citykiln::roads
