// Parked cars: in parking lanes of streets, in rows on car parks, and in mapped parking spaces.
//
//     =====|[car]  [car]      [car]|=====    a parking lane is divided into places; a share of them, drawn for each
//     - - - - - - - - - - - - - - - - - -    place, has a car. Places that are not wholly on a parking lane (before
//     ==================================     crossings and junctions, where it narrows) have none.
#pragma once

#include <span>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"
#include "compiler/things/free_places.h"

namespace citykiln::things {

/// The share of places with a car. Source: 60 to 90 % of places at kerbs are occupied (D. Shoup, The High Cost of Free
/// Parking, 2005).
inline constexpr double kOccupied = 0.7;

/// Returns parked cars as things: of mapped parking spaces those that are occupied; places along parking lanes, 5.8 m
/// long, or 2.6 m where the lane is wide enough for cars across it; places on car parks, in pairs of rows along the
/// longer side of the area with lanes of 6 m between them. The ids are those of the space, the road or the car park,
/// with the numbers of places as parts. Draws depend on the seed and on the id alone. O(places · land cover near them).
/// @param spaces  Things of the role map::ThingRole::kCar.
/// @param places  The land cover of the map.
std::vector<map::ThingFeature> parked_cars(std::span<const map::ThingFeature> spaces, const map::FeatureView& features,
                                           std::span<const roads::Road> roads, FreePlaces& places, std::uint64_t seed);

}  // namespace citykiln::things
