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
  int samples = 64;  ///< Paths per pixel; with `noise` at most.
  int bounces = 3;
  double roulette = 0.1;      ///< As TraceContext.
  bool has_caustics = false;  ///< As TraceContext.
  double exposure = 1;
  int threads = 0;
  std::uint64_t seed = 0;
  double noise = 0;         ///< > 0: blocks of pixels get the samples that this relative error needs (SamplePlan).
  bool has_guides = false;  ///< Whether the picture gets guides and sample counts.
  /// Called with the finished share, 0 to 1, by one thread at a time. Empty: not called.
  std::function<void(double share)> on_progress{};
  /// Called with the picture so far, without guides, after 1, 2, 4 … samples a pixel and at the end, before render()
  /// returns. Empty: not called.
  std::function<void(const Image& image)> on_pass{};
  /// Once true, render() returns soon, with the samples taken by then. Null: it goes on to the end.
  const std::atomic<bool>* is_stopped = nullptr;
};

/// Renders a picture. Same world, lights, camera and options: the same picture, bit for bit on one machine, for any
/// number of threads, unless it is stopped.
///
/// Method: passes over the picture, each of which doubles the samples. Blocks of 32 by 32 pixels, and pixels in them,
/// follow in Morton order, so that neighbouring rays follow each other.
Image render(const World& world, const Lights& lights, const LocalLights& local, const Camera& camera,
             const Options& options);

/// Renders one picture, with the lights in the world: several pictures share them better by the function above.
Image render(const World& world, const Lights& lights, const Camera& camera, const Options& options);

/// Renders baked tiles: the same picture whether they were baked or read from .glb.
Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera, const Options& options);

}  // namespace citykiln::preview
