// What a plant may ask about the place where it grows.
#pragma once

#include <functional>

#include "compiler/geometry/vec.h"

namespace citykiln::lsystems {

/// Points are in the plant's own frame: metres from its foot, z up. Without a function, the ground is flat and all is
/// in the sun. Answers must depend on nothing but the point; those that are no number count as 0.
struct Environment {
  std::function<double(Vec3)> height_above_ground;  ///< ?H(h)
  std::function<double(Vec3)> shade;                ///< ?S(s): 0 in the sun … 1 in the dark.
};

}  // namespace citykiln::lsystems
