// Spots: small places where somebody may be.
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/countries/country_group.h"

namespace citykiln::people {

/// The uses of the ground about a spot, which decide how many people are there at an hour.
enum class SpotUse : std::uint8_t {
  kShops,     ///< On a pavement or path near shop fronts.
  kHouses,    ///< On a pavement or path near other buildings.
  kOpen,      ///< On a pavement or path near no building.
  kPark,      ///< A path in a park.
  kSquare,    ///< On a square or a pedestrian street.
  kStop,      ///< At a stop of buses or trams.
  kCrossing,  ///< At the kerb, before a crossing.
  kSeat,      ///< On a bench.
  kCount
};

/// A disc of radius kSpotRadius_m that holds one person or two.
struct Spot {
  StableId key{};     ///< Decides its draws; equal in all tiles that know the spot.
  OsmId feature{};    ///< The way, area or thing to which it belongs.
  Vec2 at{};          ///< Plane metres.
  Vec2 along{};       ///< The direction in which people walk, forwards or backwards. Length 1.
  Vec2 towards{};     ///< The direction in which standing people look: to houses, street or crossing. Length 1.
  double extent = 0;  ///< The ground per spot: metres of way, square metres of a square, 1 for all others.
  SpotUse use{};
  map::CountryGroup country{};
};

/// The radius of a spot, in metres.
inline constexpr double kSpotRadius_m = 0.75;

}  // namespace citykiln::people
