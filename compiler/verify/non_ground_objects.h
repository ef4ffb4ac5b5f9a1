// Ids of the objects of a scene that ground checks skip.
#pragma once

#include "compiler/scene/scene.h"
#include "compiler/verify/measure_ground.h"

namespace citykiln::verify {

/// O(n log n).
NonGroundObjects find_non_ground_objects(const scene::Scene& scene);

}  // namespace citykiln::verify
