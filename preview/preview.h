// A picture of a scene, of either form, by path tracing: sun, sky, lit windows, diffuse surfaces.
#pragma once

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
  int samples = 64;  ///< Paths a pixel.
  int bounces = 3;
  double exposure = 1;
  int threads = 0;
  std::uint64_t seed = 0;
};

/// Linear RGB, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<float> rgb;
};

/// The view `name` of a scene: "overview" (from the south-east, all of it), "street", "top", "north", "south", "east",
/// "west", "low". Depends on the tiles' content only. An unknown name is an error that lists the known ones.
Result<Camera> named_view(std::span<const bake::BakedTile> tiles, const std::string& name);

/// Same tiles, same camera, same options: the same picture, bit for bit on one machine, for any number of threads,
/// whichever form the tiles were read from.
Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera, const Options& options);

/// How much longer than by day a picture is exposed, as eyes get used to the dark: 1 while the sun is up, twice as long
/// for each degree below the horizon, down to 6.
double adapted_exposure(const sky::Sky& sky);

/// PNG (8 bit sRGB, filmic tone curve) or EXR (linear), by the name's ending, through OpenImageIO, which is loaded only
/// now.
Result<Done> write_image(const Image& image, const std::string& path);

}  // namespace citykiln::preview
