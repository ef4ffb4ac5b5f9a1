// Rounds the bends of lines that are mapped with few points: roads, paths, railways, watercourses, walls and hedges.
#pragma once

#include <span>
#include <vector>

#include "compiler/assume/curves/free_room.h"
#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The largest distance of a road's curve from the chord of the map, metres: roads are drawn on aerial pictures, which
/// are off by about so much.
inline constexpr double kMostOfRoads_m = 1;
/// Where no building is near, it is this share of the chord's length if that is more, since long chords are drawn with
/// less care, up to the largest distance there.
inline constexpr double kMostInTheOpen = 0.02, kMostInTheOpen_m = 3;
/// The largest distances of paths, which have narrow bends, of watercourses, and of walls, fences and hedges.
inline constexpr double kMostOfPaths_m = 0.5, kMostOfWater_m = 1.5, kMostOfBarriers_m = 0.25;
/// The largest distance from a chord, as a share of the chord's length.
inline constexpr double kMostOfChord = 0.12;
/// Chords that are longer stay straight.
inline constexpr double kLongestChord_m = 256;
/// The distance within which mapped data can change a curve: a chord, those before and after it, and houses about them.
inline constexpr double kCurveRadius_m = 2 * kLongestChord_m + kInTown_m;

/// Returns the tracks with axes that are curves through their mapped nodes, which stay where they are (bends.h says at
/// which nodes). Points of curves have node ids of their own; indices of TrackPoints refer to the new axes.
///
/// Mapped axes stay: stairs, ways through buildings, indoors, with a drifting axis, runways. Curves keep from
/// buildings. The order of the features does not matter. O(n log n).
std::vector<map::Track> curved_tracks(const map::FeatureView& features, Report& report);

/// Returns the waterways with curved axes. They depend on other waterways only. O(n log n).
std::vector<map::Waterway> curved_waterways(std::span<const map::Waterway> waterways);

/// Returns the barriers with curved axes: of walls, fences and hedges which turn at three nodes in a row to one side.
/// Retaining walls and city walls stay as mapped, since the land follows them. O(n log n).
std::vector<map::Barrier> curved_barriers(std::span<const map::Barrier> barriers);

}  // namespace citykiln::assume
