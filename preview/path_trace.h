// Path tracing: the light of sun, sky, lamps and lit windows along a path from the eye.
#pragma once

#include "preview/light/light.h"
#include "preview/light/local_lights.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// The inputs of trace(), except the ray. Refers to the world and its lights, which must outlive the context.
struct TraceContext {
  const World& world;
  const Lights& lights;
  const LocalLights& local;
  /// Most reflections after the first surface; the first six by mirrors do not count. 0: no ray is followed from the
  /// first surface, not even by a mirror. >= 0.
  int bounces = 3;
  double pixel_rad = 0.001;  ///< Angle of a pixel. Waves and texture details that are smaller are averaged. > 0.
  double roulette = 0.1;     ///< Paths that carry less than this share may end (Russian roulette); 0: none does.
  /// True: mirrors are sharp also behind a matt reflection. False: there, they are blurred, which is less noisy.
  bool has_caustics = false;
};

/// The first surface along a path, as a guide for filters and compositing.
struct FirstSurface {
  Rgb albedo{};            ///< 0 where the path meets only the sky.
  Vec3 normal{};           ///< Unit, towards the viewer; zero where the path meets only the sky.
  double distance_m = -1;  ///< From the viewer; negative where the path meets only the sky.
  OsmId feature{};
};

/// The result of one path.
struct TracedPath {
  Rgb light{};  ///< Radiance towards the viewer, in the sky's unit. Finite, >= 0.
  FirstSurface first{};
};

/// Returns one sample of the radiance that arrives at `from` from `direction`. Unbiased for the given number of
/// bounces, with these simplifications:
///
/// - With has_caustics = false, light that mirrors throw on matt surfaces is blurred: behind a matt surface microfacets
///   are at least 0.3 wide (alpha).
/// - Lamps are points of light, and the lights inside of a cylinder are lines; narrow mirrors show the glass of lamps
///   and the tubes of lines.
/// - Air and fog dim, and add light to, only what the camera and mirrors see.
/// - The camera alone sees stars and, by day, the moon's disk; they throw no light.
/// - The rooms behind panes are seen by the camera alone, through the first surface; other rays meet panes without a
///   room.
/// - Textures and waves are averaged over a pixel and, after a scattering, over the spread of the path.
///
/// Method: path tracing (Kajiya 1986). At each surface, shadow rays sample sun, sky and one light of the scene, and the
/// surface's scattering gives the direction in which the path continues. Light found by shadow rays and by continued
/// paths is combined by the balance heuristic (Veach, Guibas 1995).
/// @param from       In the world's frame: metres from World::origin().
/// @param direction  Unit, away from `from`.
/// @param draw       The random numbers of the path.
TracedPath trace(const TraceContext& context, Vec3 from, Vec3 direction, PathDraw& draw);

}  // namespace citykiln::preview
