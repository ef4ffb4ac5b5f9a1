// Renders a picture of baked tiles by path tracing: sun, sky, lit windows, diffuse and specular surfaces.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"
#include "compiler/sky/recipe.h"

namespace citykiln::preview {

/// A pinhole camera in the plane, metres, z up.
struct Camera {
  Vec3 eye, look_at;
  double vertical_fov_deg = 45;
};

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

/// Linear RGB, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<float> rgb;
};

/// A named view of a scene: "overview" (from the south-east, all of it), "street", "top", "north", "south", "east",
/// "west", "low". A function of the tiles' content. Error: an unknown name; the message lists the known ones.
Result<Camera> named_view(std::span<const bake::BakedTile> tiles, const std::string& name);

/// Renders a picture. Same tiles, camera and options: the same picture, bit for bit on one machine, for any number of
/// threads, whether tiles were baked or read from .glb.
Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera, const Options& options);

/// Factor of exposure for night pictures: 1 while the sun is up; it doubles per degree of sun depression, at most 6
/// times.
double adapted_exposure(const sky::Sky& sky);

/// Writes PNG (8 bit sRGB, filmic tone curve) or EXR (linear), by the name's extension, through OpenImageIO, which is
/// loaded only then.
Result<Done> write_image(const Image& image, const std::string& path);

}  // namespace citykiln::preview
