// The sky of a scene: where the sun stands, how hazy it is.
#pragma once

#include <string>

#include "compiler/geometry/vec.h"

namespace citykiln::sky {

struct Sky {
  std::string time;        ///< ISO 8601, UTC, as given.
  Vec3 to_sun{0, 0, 1};    ///< Unit vector in the plane (x east, y north, z up), components in steps of 2^-20.
  double turbidity = 2.6;  ///< Of the air: 2 clear, 10 hazy.
  bool operator==(const Sky&) const = default;
};

/// The sun has set, all of its disk: lamps are lit.
inline bool is_night(const Sky& sky) { return sky.to_sun.z < -0.0145; }

}  // namespace citykiln::sky
