// Stretches: parts of a road's length with one kind of markings. They change before junctions and at crossings.
//
//     junction |  kStart  |        kAlong        | kZebra |   kAlong   |   kEnd  | kZebra | junction
//              12 m at most                         4 m                  12 m at most  4 m
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// The part of a road that lies in one junction. Distances are metres along the road's axis from its first point.
struct JunctionInterval {
  double at_m = 0;                   ///< Distance of the junction's node.
  double before_m = 0, after_m = 0;  ///< Lengths of the road in the junction before and after the node.
  Control before{}, after{};         ///< Control for traffic along the road, and against it.
  bool is_change = false;            ///< True if only the width changes there, so that traffic does not stop.
};

/// Returns for each road its parts in street junctions, sorted along it. Roads that run through a junction
/// (has_through_road()) have no part in it; junctions of which arms are missing have none at all. O(n log n).
std::vector<std::vector<JunctionInterval>> junction_intervals_of(std::span<const Road> roads,
                                                                 std::span<const Junction> junctions);

/// A part of a road's length with constant markings: each lane strip of the road has one marking layout there.
struct RoadStretch {
  double from_m = 0, to_m = 0;  ///< Distances along the way.
  StretchKind stretch = StretchKind::kAlong;
  Control control = Control::kNone;  ///< In kStart and kEnd: of the junction beside it, for traffic towards it.
  double zero_m = 0;                 ///< The distance along the way from which dashes of the markings are counted.
  std::uint8_t traits = 0;           ///< Where people cross: map::CrossingTrait bits.
};

/// Returns the stretches of a road from its first point to its last, without gaps.
///
/// A crossing near a junction is moved to its mouth: from the junction outwards lie the crossing (kZebra or kCrossing,
/// 4 m), then kStart or kEnd, the markings before the stop line (12 m, or less if half the way to the next junction is
/// shorter, but at least 3 m).
///
/// @param intervals  The road's entry of junction_intervals_of().
/// @param tile_m     Side of the tiles. A tile knows the junctions up to kJunctionHalo_m around it. Markings before a
///                   junction may touch several tiles. If one of these does not know all junctions that the markings
///                   depend on, they are left out in all, so that tiles agree.
std::vector<RoadStretch> stretches_of(const Road& road, std::span<const JunctionInterval> intervals, double tile_m);

/// Splits stretches at distances along the way. Each part copies all other members of its stretch, zero_m too, so that
/// dashes run on.
/// @param at_m     In any order. A distance outside of all stretches, or at an end of one, changes nothing.
/// @param may_cut  True for a stretch that may be split; asked once for each distance, of what is left of the stretch.
std::vector<RoadStretch> cut_stretches(std::span<const RoadStretch> stretches, std::vector<double> at_m,
                                       bool (*may_cut)(const RoadStretch&));

/// The distance beyond a tile within which all junctions are known.
inline constexpr double kJunctionHalo_m = 32;

}  // namespace citykiln::roads
