// Heights that other data than the heightmap give to the land: straight lines in space.
#pragma once

#include <cstdint>

#include "compiler/geometry/vec.h"

namespace citykiln::ground {

/// How far the land follows a line.
enum class KnownKind : std::uint8_t {
  kRoad,   ///< The land takes the line's height, within the error of the heightmap.
  kLevel,  ///< The land takes the line's height, whatever the heightmap says.
  kWater,  ///< Other lines neither lower the land below this one nor raise it more than a bank above it.
};

/// A straight line on the land. `from_m` and `to_m` are the heights of its ends, before landforms change the land.
struct KnownLine {
  Vec2 from, to;  ///< Plane metres.
  double from_m = 0, to_m = 0;
  KnownKind kind{};
  bool operator==(const KnownLine&) const = default;
};

}  // namespace citykiln::ground
