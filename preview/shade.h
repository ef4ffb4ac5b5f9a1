// Light along paths: sun and sky, diffuse surfaces, smooth water and glass, haze.
#pragma once

#include "compiler/sky/expand.h"
#include "preview/random.h"
#include "preview/world.h"

namespace citykiln::preview {

/// Everything a path needs to know. Refers to its parts, which must outlive it.
struct Stage {
  const World& world;
  const sky::Dome& dome;
  int bounces = 3;
};

/// Radiance along a ray, one sample. Source: Kajiya 1986, with next event estimation for the sun and cosine sampling for the sky.
std::array<double, 3> trace(const Stage& stage, Vec3 from, Vec3 direction, PathDraw& draw);

}  // namespace citykiln::preview
