// Street lamps as light sources.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// A street lamp.
struct StreetLamp {
  Vec3 at;       ///< Its head, plane metres.
  Vec2 towards;  ///< Direction of its arm, length 1.
  float height_m = 0;
  bool has_arm = false;  ///< A head on an arm, which shines down; else a lantern on a post.
};

}  // namespace citykiln::preview
