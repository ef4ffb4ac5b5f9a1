// Heights of the land that are known from other data than the heightmap: straight lines in space.
#pragma once

#include <cstdint>

#include "compiler/geometry/vec.h"

namespace citykiln::ground {

/// The way in which the land follows a line (corrected_land()).
enum class KnownKind : std::uint8_t {
  kRoad,   ///< The land moves to the line, by at most the heightmap's error.
  kLevel,  ///< The land moves to the line, however far it is.
  /// Other lines neither lower the land to below this one, nor raise it to more than 3 m above it.
  kWater,
};

/// A straight line on the land, with the heights of its ends in metres, from_m and to_m, before
/// landforms change the land.
struct KnownLine {
  Vec2 from, to;  ///< Plane metres.
  double from_m = 0, to_m = 0;
  KnownKind kind{};
  bool operator==(const KnownLine&) const = default;
};

}  // namespace citykiln::ground
