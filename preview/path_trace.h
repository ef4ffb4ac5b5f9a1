// Light along paths: sun and sky on diffuse surfaces, emission, specular reflection of water and glass, air in between.
#pragma once

#include "preview/light/light.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// The inputs of a path. Refers to world and lights, which must outlive it.
struct TraceContext {
  const World& world;
  const Lights& lights;
  int bounces = 3;           ///< Diffuse reflections after the first surface. >= 0.
  double pixel_rad = 0.001;  ///< Angle of a pixel: shorter waves blur, finer textures are averaged. > 0.
};

/// The first surface along a path, which guides filters: what a pixel shows without light.
struct FirstSurface {
  Rgb albedo{};            ///< 0 where the path meets only the sky.
  Vec3 normal{};           ///< Unit, towards the viewer; zero where the path meets only the sky.
  double distance_m = -1;  ///< From the viewer; negative where the path meets only the sky.
  OsmId feature{};
};

/// One path.
struct TracedPath {
  Rgb light{};  ///< Radiance towards the viewer, in the sky's unit.
  FirstSurface first{};
};

/// One sample of the radiance towards `from` along a unit direction; each channel in [0, 12].
///
/// Method: path tracing (Kajiya 1986). Each surface samples sun and sky by shadow rays, and a cosine-weighted ray
/// continues the path; sky light that this ray finds is combined with the shadow ray's by the balance heuristic (Veach,
/// Guibas 1995). A smooth surface that is seen first, or in a mirror, is followed twice: specular and diffuse.
TracedPath trace(const TraceContext& context, Vec3 from, Vec3 direction, PathDraw& draw);

}  // namespace citykiln::preview
