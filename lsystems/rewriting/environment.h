// Functions that answer the queries of a plant about its surroundings.
#pragma once

#include <functional>

#include "compiler/geometry/vec.h"

namespace citykiln::lsystems {

/// The functions for queries. Points are relative to the plant's foot, z up, in the file's units. If a function is
/// missing, the ground is flat or nothing is shaded. Functions must be pure; NaN and infinity count as 0.
struct Environment {
  std::function<double(Vec3)> height_above_ground;  ///< ?H(h)
  std::function<double(Vec3)> shade;                ///< ?S(s): from 0, full sun, to 1, dark.
};

}  // namespace citykiln::lsystems
