// Functions that answer a plant's queries about its surroundings.
#pragma once

#include <functional>

#include "compiler/geometry/vec.h"

namespace citykiln::lsystems {

/// Points are relative to the plant's foot, z up, in the file's units. Without a function, the ground is flat and
/// nothing is shaded. Functions must be pure; NaN and infinity count as 0.
struct Environment {
  std::function<double(Vec3)> height_above_ground;  ///< ?H(h)
  std::function<double(Vec3)> shade;                ///< ?S(s): from 0, full sun, to 1, dark.
};

}  // namespace citykiln::lsystems
