// Renders a picture of a world by path tracing: sun, sky, lamps, lit windows, diffuse and specular surfaces.
#pragma once

#include <atomic>
#include <functional>
#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/sky/recipe.h"
#include "preview/camera/camera.h"
#include "preview/light/light.h"
#include "preview/light/local_lights.h"
#include "preview/picture/image.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

struct Options {
  int width = 1280, height = 720;
  int samples = 64;  ///< Paths per pixel; with `noise` > 0 the largest number of them.
  int bounces = 3;
  double roulette = 0.1;      ///< See TraceContext.
  bool has_caustics = false;  ///< See TraceContext.
  double exposure = 1;
  int threads = 0;
  std::uint64_t seed = 0;
  double noise = 0;         ///< > 0: blocks of pixels get the samples that this relative error needs (SamplePlan).
  bool has_guides = false;  ///< Whether the picture gets guides and sample counts.
  /// The function that gets the finished share, 0 to 1, from one thread at a time. Empty: not called.
  std::function<void(double share)> on_progress{};
  /// The function that gets the unfinished picture, without guides, after 1, 2, 4 … samples a pixel and once more at
  /// the end, before render() returns. Empty: not called.
  std::function<void(const Image& image)> on_pass{};
  /// If it becomes true, render() returns soon, with the samples taken by then. Null: render() goes on to the end.
  const std::atomic<bool>* is_stopped = nullptr;
};

/// Renders a picture. Equal inputs give an equal picture, bit for bit on one machine, for any number of threads, unless
/// it is stopped.
///
/// Method: passes over the picture, each of which doubles the samples. Blocks of 32 by 32 pixels, and the pixels in
/// them, are in Morton order, so that one ray is near the next.
Image render(const World& world, const Lights& lights, const LocalLights& local, const Camera& camera,
             const Options& options);

/// Renders one picture with the local lights of the world. For several pictures, make LocalLights once and call the
/// function above.
Image render(const World& world, const Lights& lights, const Camera& camera, const Options& options);

/// Renders baked tiles. Tiles that were baked and tiles that were read from .glb files give the same picture.
Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera, const Options& options);

}  // namespace citykiln::preview
