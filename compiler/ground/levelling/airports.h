// Levels airports: runways, taxiways and large aprons of one airport lie on one gently bent surface, whatever noise a
// heightmap has there.
//
//      terrain  .·.     .·'·.            The surface is fitted to the terrain in the airport, so that outliers do not
//    .·'     '·.   bank      '·          move it. Beside it the land lies between banks of 1 : 10, so the land follows
//               \_________________/      over a width that grows with the difference.
//                runway, taxiway
#pragma once

#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The steepest slope of an airport: ICAO Annex 14 allows 1 % along long runways, 1.5 % on taxiways.
inline constexpr double kAirportSlope = 0.01;
/// The width of level grass beside runways, taxiways and aprons: a graded strip is 75 m wide to either side.
inline constexpr double kAirportStrip_m = 75;
/// The slope of banks about an airport, and their greatest width. Banks that would be wider are steeper.
inline constexpr double kAirportBank = 0.1, kMostAirportBank_m = 512;
/// Larger aprons belong to airports; smaller ones, such as helipads, are level areas (landforms/level_areas.inc).
inline constexpr double kLeastApron_m2 = 10'000;

/// Returns the field with the samples in airports on their surfaces, and those beside them between banks.
///
/// An airport is made of runways, taxiways and aprons whose strips join. Its surface is fitted_surface() of at most
/// some thousand samples in it, of form kBent. Without airports the field is returned as it is. Depends on the samples
/// in an airport, and within kMostAirportBank_m of it. O(samples in and beside airports · log).
map::Heightfield with_level_airports(const map::Heightfield& heights, const map::FeatureView& features);

}  // namespace citykiln::ground
