// Parking places: rectangles in which a car may stand.
//
//     ahead      ┌──────────────┐    at is the middle, length_m lies along `ahead`, width_m across it.
//       ──►      │      at      │    A car that drove in forwards looks ahead.
//                └──────────────┘
#pragma once

#include <array>
#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::cars {

/// The kinds of places. Where two places overlap, that of the earlier kind counts.
enum class PlaceKind : std::uint8_t {
  kSpace,  ///< Mapped: amenity=parking_space.
  kBay,    ///< Painted on a car park, or across an aisle of a car park.
  kDrive,  ///< On the drive of a yard.
  kLane,   ///< In the parking lane of a street, or in a row beside a street.
  kKerb,   ///< At the kerb of a carriageway without a parking lane.
  kCount
};

/// The users of a place, who decide at which hours it has a car.
enum class PlaceUse : std::uint8_t { kHomeStreet, kMainStreet, kCarPark, kDrive, kCount };

/// A place for one car.
struct Place {
  StableId key{};      ///< Decides its draws; equal in all tiles that know the place.
  OsmId feature{};     ///< The road, car park, building or parking space to which it belongs.
  Vec2 at{}, ahead{};  ///< Plane metres; ahead has length 1.
  double length_m = 0, width_m = 0;
  PlaceKind kind{};
  PlaceUse use{};
  map::CountryGroup country{};
  bool may_turn = false;  ///< True if cars may stand in it backwards.
  /// The land cover on which it must lie: that of the carriageway, or that of car parks. kUnknown: any open ground.
  map::LandCoverClass surface{};
  Vec2 across{};  ///< For kLane and kKerb on a carriageway: the way from `at` to the far kerb, else {0, 0}.
};

/// Returns the corners of a place, counter-clockwise from the rear right one.
inline std::array<Vec2, 4> corners_of(const Place& place) {
  const Vec2 along = place.ahead * (place.length_m / 2), left = left_of(place.ahead) * (place.width_m / 2);
  return {place.at - along - left, place.at + along - left, place.at + along + left, place.at - along + left};
}

inline Box2 box_of(const Place& place) {
  Box2 box;
  for (const Vec2 corner : corners_of(place)) box.grow(corner);
  return box;
}

}  // namespace citykiln::cars
