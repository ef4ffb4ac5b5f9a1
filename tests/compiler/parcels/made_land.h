// Made land for tests of parcels, and the properties that all parcels have.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compiler/parcels/divide.h"

namespace citykiln::parcels {

/// A line of 4 m to each side; its id is the number.
inline Line street(std::uint64_t id, Polyline axis, LineKind kind = LineKind::kStreet, double half_m = 4) {
  return {.id = StableId{id}, .axis = std::move(axis), .left_m = half_m, .right_m = half_m, .kind = kind};
}

inline Ring rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

inline Footprint house(std::uint64_t id, double x, double y, double width = 10, double height = 10) {
  return {StableId{id}, rectangle(x, y, width, height)};
}

/// Streets, barriers, taken land and footprints at random places of a square, many of them in each other's way.
Land random_land(std::uint64_t seed, double side_m);

/// Expects of all rings that they are simple; of lots that they have area, lie in their block, share no area with each
/// other, and have a frontage on a street; of areas that lots and rest are as large as blocks; of each footprint that
/// it is in one lot or failure; of ids that they are unique.
void expect_properties(const Land& land, const Parcels& parcels, const std::string& what);

}  // namespace citykiln::parcels
