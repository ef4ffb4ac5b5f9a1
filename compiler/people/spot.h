// Spots: small places where somebody may be.
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/countries/country_group.h"

namespace citykiln::people {

/// The uses of the ground about a spot, which decide how many people are there at an hour.
enum class SpotUse : std::uint8_t {
  kShops,     ///< A way before shop fronts.
  kHouses,    ///< A way beside other buildings.
  kOpen,      ///< A way beside no building.
  kPark,      ///< A path in a park.
  kSquare,    ///< A square or a street for walkers.
  kStop,      ///< At a stop of buses or trams.
  kCrossing,  ///< At the kerb, before a crossing.
  kSeat,      ///< On a bench.
  kCount
};

/// A spot, round, of kSpotRadius_m. It holds a person or a small group.
struct Spot {
  StableId key{};     ///< Decides its draws; equal in all tiles that know the spot.
  OsmId feature{};    ///< The way, area or thing to which it belongs.
  Vec2 at{};          ///< Plane metres.
  Vec2 along{};       ///< The way that people walk here, length 1.
  Vec2 towards{};     ///< The way that standing people look: to the houses, the street, the crossing. Length 1.
  double extent = 0;  ///< How much ground is its own: metres of way, square metres of a square, 1 for others.
  SpotUse use{};
  map::CountryGroup country{};
};

inline constexpr double kSpotRadius_m = 0.75;

}  // namespace citykiln::people
