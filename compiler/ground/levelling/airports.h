// Levels airports: runways, taxiways and large aprons of one airport lie on one gently bent
// surface, whatever noise a heightmap has there.
//
//      terrain  .·.     .·'·.            The surface is fitted to the terrain in the airport, so
//    .·'     '·.   bank      '·          that outliers do not move it. The land beside it lies
//               \_________________/      between banks that rise and fall by 1 : 10 from its edge:
//                runway, taxiway         the larger the difference, the wider the bank.
#pragma once

#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The steepest slope of an airport's surface: ICAO Annex 14 allows 1 % along long runways, 1.5 %
/// on taxiways.
inline constexpr double kAirportSlope = 0.01;
/// The width in metres of the strip beside runways, taxiways and aprons that lies on the surface: a
/// graded strip of ICAO is 75 m wide on each side.
inline constexpr double kAirportStrip_m = 75;
/// The slope of banks about an airport, and their greatest width in metres. Banks that would be
/// wider are steeper.
inline constexpr double kAirportBank = 0.1, kMostAirportBank_m = 512;
/// The area in m² above which an apron belongs to an airport. Smaller ones, such as helipads, are
/// level areas (landforms/level_areas.inc).
inline constexpr double kLeastApron_m2 = 10'000;

/// Returns the field with the samples of airports on their surfaces, and those about them between
/// banks.
///
/// An airport is a connected group of samples within kAirportStrip_m and a diagonal of the sample
/// grid of runways, taxiways and large aprons on the ground; groups of less than 10,000 m² stay.
/// Its surface is fitted_surface() with SurfaceForm::kBent of up to 4096 of its samples. The field
/// is returned as it is if there is no airport; else it has as many parts as before. A sample
/// depends on the samples of an airport within kMostAirportBank_m of it, and on those between.
/// O(samples in and beside airports · log).
map::Heightfield with_level_airports(const map::Heightfield& heights, const map::FeatureView& features);

}  // namespace citykiln::ground
