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

/// The settings of a picture.
struct Options {
  int width = 1280, height = 720;
  int samples = 64;  ///< Paths per pixel; with `noise` > 0 the largest number of them.
  /// Most reflections after the first surface; the first six by mirrors do not count. 0: no ray is followed from the
  /// first surface, not even by a mirror.
  int bounces = 3;
  /// Paths that carry less than this share of light may end (Russian roulette); 0: no path does.
  double roulette = 0.1;
  /// True: mirrors are sharp also behind a matt reflection. False: blurred there, less noisy.
  bool has_caustics = false;
  double exposure = 1;  ///< The factor by which radiance is multiplied.
  int threads = 0;      ///< 0: one for each CPU.
  std::uint64_t seed = 0;
  double noise = 0;  ///< > 0: each block of pixels gets as many samples as this relative error needs (SamplePlan).
  bool has_guides = false;  ///< Whether the picture gets guides and sample counts.
  /// The function that gets the finished share, 0 to 1, from one thread at a time. Empty: not called.
  std::function<void(double share)> on_progress{};
  /// The function that gets the unfinished picture, whose guides are unfinished too, after 1, 2, 4 … and all samples a
  /// pixel; with `noise` the count starts again after the pilot samples. Empty: not called.
  std::function<void(const Image& image)> on_pass{};
  /// If the flag becomes true, render() returns soon, with the samples taken by then. Null: render() takes all samples.
  const std::atomic<bool>* is_stopped = nullptr;
};

/// Renders a picture. Equal inputs give an equal picture, bit for bit on one machine, for any number of threads, unless
/// rendering is stopped.
///
/// Method: passes over the picture, each of which doubles the samples. Blocks of 32 by 32 pixels, and the pixels in
/// them, are in Morton order, so that consecutive rays are near each other.
Image render(const World& world, const Lights& lights, const LocalLights& local, const Camera& camera,
             const Options& options);

/// Renders one picture with the local lights of the world. For several pictures, make LocalLights once and call the
/// function above.
Image render(const World& world, const Lights& lights, const Camera& camera, const Options& options);

/// Renders baked tiles. Tiles that were baked and tiles that were read from .glb files give the same picture.
Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera, const Options& options);

}  // namespace citykiln::preview
