// Sky recipe: the direction of the sun and the turbidity of the air.
#pragma once

#include <string>

#include "compiler/geometry/vec.h"

namespace citykiln::sky {

struct Sky {
  std::string time;        ///< ISO 8601, UTC, as given.
  Vec3 to_sun{0, 0, 1};    ///< Unit vector (x east, y north, z up); components are multiples of 2^-20.
  double turbidity = 2.6;  ///< Of the air: 2 clear, 10 hazy.
  bool operator==(const Sky&) const = default;
};

/// Whether the sun has set: its upper limb, with refraction, is below the horizon (-0.83 degrees).
inline bool is_night(const Sky& sky) { return sky.to_sun.z < -0.0145; }

}  // namespace citykiln::sky
