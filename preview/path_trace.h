// Light along paths: sun and sky on diffuse surfaces, and what shines itself; water and glass mirror too; air between.
#pragma once

#include "preview/light.h"
#include "preview/world.h"

namespace citykiln::preview {

/// Everything a path needs to know. Refers to its parts, which must outlive it.
struct TraceContext {
  const World& world;
  const Lights& lights;
  int bounces = 3;           ///< Surfaces that pass light on between the first and the sky.
  double pixel_rad = 0.001;  ///< What one pixel covers: finer waves blur, finer paint is mixed.
};

/// Radiance towards `from` along a unit direction, one sample; each channel in [0, 12].
///
/// Method: path tracing (Kajiya 1986). Each surface asks sun and sky for light by shadow rays; a cosine-weighted ray
/// goes on, and what it finds of the sky is weighed against the shadow ray (balance heuristic; Veach, Guibas 1995).
/// A smooth surface that is seen first, or in a mirror, is followed both ways: mirrored and body.
Rgb trace(const TraceContext& stage, Vec3 from, Vec3 direction, PathDraw& draw);

}  // namespace citykiln::preview
