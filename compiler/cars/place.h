// Parking places: rectangles in which a car may stand.
//
//     ahead      ┌──────────────┐    at is the middle, length_m lies along `ahead`, width_m across it.
//       ──►      │      at      │    A car that drove in forwards looks ahead.
//                └──────────────┘
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/oriented_rect.h"
#include "compiler/map/countries/country_group.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::cars {

/// The kinds of places. Where two places overlap, that of the earlier kind counts (places_in()).
enum class PlaceKind : std::uint8_t {
  kSpace,  ///< Mapped: amenity=parking_space.
  kBay,    ///< Between the painted lines of a car park, or square to the edge of a road that a car park adjoins.
  kDrive,  ///< On the drive of a yard.
  kPlot,   ///< On a paved plot that no lot has.
  kLane,   ///< In the parking lane of a street, or along the edge of a road that a car park adjoins.
  kKerb,   ///< At the kerb of a carriageway without a parking lane.
  kCount
};

/// The use of a place, which decides the share of such places that have a car at an hour (occupancy.inc).
enum class PlaceUse : std::uint8_t {
  kHomeStreet,  ///< Residential, service and pedestrian streets.
  kMainStreet,  ///< Streets of higher classes.
  kCarPark,     ///< Car parks, and mapped parking spaces.
  kDrive,       ///< Drives of yards.
  kCount
};

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
  /// The land cover on which it must lie: the road's class, or kParking beside a road. kUnknown: the rule of its kind
  /// (has_ground()).
  map::LandCoverClass surface{};
  /// Places on a carriageway: the vector from `at` to the opposite kerb, square to the road. {0, 0} for all other
  /// places, also on car parks beside a road.
  Vec2 across{};
};

/// Returns the rectangle of a place.
inline OrientedRect rect_of(const Place& place) { return {place.at, place.ahead, place.length_m, place.width_m}; }

}  // namespace citykiln::cars
