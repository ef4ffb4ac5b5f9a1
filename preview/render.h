// Renders a picture of a world by path tracing: sun, sky, lamps, lit windows, diffuse and specular surfaces.
#pragma once

#include <functional>
#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/sky/recipe.h"
#include "preview/camera/camera.h"
#include "preview/light/light.h"
#include "preview/picture/image.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

struct Options {
  int width = 1280, height = 720;
  int samples = 64;  ///< Paths per pixel.
  int bounces = 3;
  double exposure = 1;
  int threads = 0;
  std::uint64_t seed = 0;
  /// Called with the finished share, 0 to 1, by one thread at a time. Empty: not called.
  std::function<void(double share)> on_progress{};
};

/// Renders a picture. Same world, lights, camera and options: the same picture, bit for bit on one machine, for any
/// number of threads.
Image render(const World& world, const Lights& lights, const Camera& camera, const Options& options);

/// Renders baked tiles: the same picture whether they were baked or read from .glb.
Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera, const Options& options);

/// Factor of exposure for night pictures: 1 while the sun is up; it doubles per degree of sun depression, at most 6
/// times.
double adapted_exposure(const sky::Sky& sky);

}  // namespace citykiln::preview
