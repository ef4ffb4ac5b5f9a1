// The settings of parked cars, a property of the whole scene. A car has no recipe: places and cars are functions of the
// recipes of roads, pitches and yards, and are made when a tile is baked (parked_cars.h).
#pragma once

namespace citykiln::cars {

/// The share of parking places that have a car.
struct CarShare {
  bool is_by_table = false;  ///< By country, kind of place and hour (occupancy.h).
  double share = 0;          ///< Otherwise this share of all places: 0 to 1, a multiple of kShareStep.
  bool operator==(const CarShare&) const = default;
};

inline constexpr double kShareStep = 0x1p-10;
inline constexpr CarShare kNoCars{}, kUsualCars{.is_by_table = true};

inline bool has_cars(const CarShare& share) { return share.is_by_table || share.share > 0; }

}  // namespace citykiln::cars
