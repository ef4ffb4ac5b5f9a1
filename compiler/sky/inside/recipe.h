// Light and air inside of a hollow cylinder, which replace sun, moon, stars and clouds there.
#pragma once

#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/map/plane/cylinder.h"

namespace citykiln::sky {

/// A straight light along the axis: a tube that shines evenly from its surface. Plane metres (map/plane/cylinder.h).
struct LineLight {
  Vec3 from, to;             ///< The ends of the tube's middle. They differ in x only.
  double lumen_per_m = 0;    ///< Luminous flux of a metre.
  double temperature_k = 0;  ///< Colour of a black body.
  double radius_m = 0;       ///< Radius of the tube.
  bool operator==(const LineLight&) const = default;
};

/// The inside of a cylinder. The lines shine by day; by night (sky::are_lamps_lit()) they are dark.
struct Inside {
  map::Cylinder cylinder;
  double west_m = 0, east_m = 0;  ///< The ends of the cylinder along x, where it is closed by disks.
  std::vector<LineLight> lines{};
  /// Air of a spinning cylinder is densest at the ground: its density at a distance r from the axis is that of the
  /// ground times exp(-fall (1 - r² / R²)), with R the radius.
  double fall = 0;
  bool operator==(const Inside&) const = default;
};

}  // namespace citykiln::sky
