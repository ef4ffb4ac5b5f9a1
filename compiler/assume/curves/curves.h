// Rounds the bends of lines that are mapped with few points: roads, railways, watercourses,
// walls and hedges.
#pragma once

#include <span>
#include <vector>

#include "compiler/assume/curves/free_room.h"
#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The largest distance in metres of a road's or railway's curve from the mapped chord: roads are
/// drawn on aerial pictures, which are off by about as much.
inline constexpr double kMostOfRoads_m = 1;
/// The largest distance outside of towns, where no building is within kInTown_m: this share of the
/// chord's length, from kMostOfRoads_m up to kMostInTheOpen_m. Long chords are drawn with less
/// care.
inline constexpr double kMostInTheOpen = 0.02, kMostInTheOpen_m = 3;
/// The largest distances in metres of curves of watercourses, and of walls, fences and hedges.
inline constexpr double kMostOfWater_m = 1.5, kMostOfBarriers_m = 0.25;
/// The least width in metres of a watercourse that is curved: streams have as many points as roads.
inline constexpr double kWideWater_m = 4;
/// The largest distance of any curve, as a share of the chord's length.
inline constexpr double kMostOfChord = 0.12;
/// The longest chord in metres that is curved.
inline constexpr double kLongestChord_m = 256;
/// The distance in metres within which mapped data can change a curve: the chords before and after
/// it, and buildings about these. Lines that would cross themselves are an exception: they stay as
/// mapped over their whole length.
inline constexpr double kCurveRadius_m = 2 * kLongestChord_m + kInTown_m;

/// Returns all tracks, in order, with curved axes through their mapped nodes. Mapped nodes stay
/// where they are; slopes_of() (bends.h) selects those that are rounded. Points of curves have the
/// node ids of curve_node_id(); the indices of TrackPoints refer to the new axes.
///
/// These axes stay as mapped: paths, tracks, runways, ways through buildings, covered or indoors,
/// and axes that drift (placement=transition). Turning circles and mini-roundabouts keep their corners.
/// Curves on the ground keep their distance from buildings and from pavements of other ways
/// (free_room.h). Each way with a curve is counted once as Assumption::kCurves. The result does not
/// depend on the order of the features. O(n log n), n: points.
std::vector<map::Track> curved_tracks(const map::FeatureView& features, Report& report);

/// Returns all waterways, in order; those on the ground of at least kWideWater_m have curved axes.
/// The result depends on no other features. O(n log n), n: points.
std::vector<map::Waterway> curved_waterways(std::span<const map::Waterway> waterways);

/// Returns all barriers, in order. An axis is curved where it turns at three nodes in a row to the
/// same side, by 4 to 40 degrees at each, over chords of at most 20 m. Retaining walls and city
/// walls stay as mapped, since the land follows them. O(n log n), n: points.
std::vector<map::Barrier> curved_barriers(std::span<const map::Barrier> barriers);

}  // namespace citykiln::assume
