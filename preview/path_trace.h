// Light along paths: sun, sky, lamps and lit windows on surfaces that scatter it, air in between.
#pragma once

#include "preview/light/light.h"
#include "preview/light/local_lights.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// The inputs of a path. Refers to world and lights, which must outlive it.
struct TraceContext {
  const World& world;
  const Lights& lights;
  const LocalLights& local;
  int bounces = 3;           ///< Reflections after the first surface, but for those of mirrors. >= 0.
  double pixel_rad = 0.001;  ///< Angle of a pixel: shorter waves blur, finer textures are averaged. > 0.
  double roulette = 0.1;     ///< Paths with a smaller weight may end (Russian roulette). 0: none do.
  bool has_caustics =
      false;  ///< Whether mirrors keep their sharpness after matt reflections, or are as rough as these.
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
  Rgb light{};  ///< Radiance towards the viewer, in the sky's unit. Finite, >= 0.
  FirstSurface first{};
};

/// One sample of the radiance towards `from` along a unit direction. Unbiased for the number of bounces, but for two
/// simplifications: with has_caustics = false, light that mirrors throw on matt surfaces is blurred (their microfacets
/// are at least 0.3 wide there); lamps are points, whose picture in narrow mirrors is their glass.
///
/// Method: path tracing (Kajiya 1986). At each surface sun, sky and one light of the scene are sampled by shadow rays,
/// and one direction by the surface's scattering, which goes on; what both find is combined by the balance heuristic
/// (Veach, Guibas 1995).
TracedPath trace(const TraceContext& context, Vec3 from, Vec3 direction, PathDraw& draw);

}  // namespace citykiln::preview
