#include "preview/render.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "compiler/contract/for_each_slot.h"
#include "preview/path_trace.h"

namespace citykiln::preview {
namespace {

constexpr int kBlock_px = 32;

int blocks(int pixels) { return (pixels + kBlock_px - 1) / kBlock_px; }

// The camera's axes, and the half size of its picture at distance 1.
struct Lens {
  Vec3 forward, right, up;
  double half_width, half_height;
};

Lens lens_of(const Camera& camera, const Options& options) {
  // a camera without direction looks north
  const Vec3 sight = unit(camera.look_at - camera.eye), forward = dot(sight, sight) > 0 ? sight : Vec3{0, 1, 0};
  // straight up or down, north is up
  const Vec3 pole = std::abs(forward.z) > 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 right = unit(cross(forward, pole));
  const double half_height = std::tan(std::clamp(camera.vertical_fov_deg, 0.01, 179.0) * std::numbers::pi / 360);
  return {forward, right, cross(right, forward), half_height * options.width / options.height, half_height};
}

// Tent filter, one pixel to each side: smooth edges without blur.
double tent(double u) { return u < 0.5 ? std::sqrt(2.0 * u) - 1 : 1 - std::sqrt(2.0 - 2.0 * u); }

// The inputs of a pixel.
struct Shot {
  TraceContext context;
  Lens lens;
  Vec3 eye;  // in the world's frame
  SampleGrid grid;
};

Rgb pixel(const Shot& shot, const Options& options, int x, int y) {
  const int samples = std::max(options.samples, 1);
  const PixelSamples chances(options.seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), shot.grid);
  Rgb sum{};
  for (int sample = 0; sample < samples; ++sample) {
    PathDraw draw(chances, static_cast<std::uint32_t>(sample));
    const UnitPair at = draw.next();
    const double px = (2 * (x + 0.5 + tent(at.u)) / options.width - 1) * shot.lens.half_width;
    const double py = (1 - 2 * (y + 0.5 + tent(at.v)) / options.height) * shot.lens.half_height;
    sum = sum +
          trace(shot.context, shot.eye, unit(shot.lens.forward + shot.lens.right * px + shot.lens.up * py), draw).light;
  }
  return sum * (options.exposure / samples);
}

void render_block(const Shot& shot, const Options& options, int block, Image& image) {
  const int across = blocks(options.width), x0 = block % across * kBlock_px, y0 = block / across * kBlock_px;
  for (int y = y0; y < std::min(y0 + kBlock_px, options.height); ++y)
    for (int x = x0; x < std::min(x0 + kBlock_px, options.width); ++x) {
      const Rgb rgb = pixel(shot, options, x, y);
      float* out = &image.rgb[(static_cast<std::size_t>(y) * options.width + x) * 3];
      for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(rgb[c]);
    }
}

}  // namespace

double adapted_exposure(const sky::Sky& sky) {
  constexpr double kLowest_deg = 6;
  const double below_deg = std::asin(std::clamp(-sky.to_sun.z, 0.0, 1.0)) * 180 / std::numbers::pi;
  return std::exp2(std::min(below_deg, kLowest_deg));
}

Image render(const World& world, const Lights& lights, const Camera& camera, const Options& options) {
  if (options.width <= 0 || options.height <= 0) return {};
  const Lens lens = lens_of(camera, options);
  const LocalLights local(world.emitters(), lights.lamps(), world.origin());
  const TraceContext context{.world = world,
                             .lights = lights,
                             .local = local,
                             .bounces = std::max(options.bounces, 0),
                             .pixel_rad = 2 * lens.half_height / options.height};
  const Shot shot{context, lens, camera.eye - world.origin(), grid_of(options.width, options.height, options.samples)};
  Image image{options.width, options.height,
              std::vector<float>(static_cast<std::size_t>(options.width) * options.height * 3)};
  const std::size_t count = static_cast<std::size_t>(blocks(options.width)) * blocks(options.height);
  std::mutex progress;
  std::size_t finished = 0;
  for_each_index(count, options.threads, [&](std::size_t block) {
    render_block(shot, options, static_cast<int>(block), image);
    if (!options.on_progress) return;
    const std::lock_guard one_at_a_time(progress);
    options.on_progress(static_cast<double>(++finished) / static_cast<double>(count));
  });
  return image;
}

Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera,
             const Options& options) {
  const World world(tiles, camera.eye);
  const auto lamps = sky::is_night(sky) ? lamps_of(tiles) : std::vector<StreetLamp>();
  return render(world, Lights(sky::generate(sky), lamps), camera, options);
}

}  // namespace citykiln::preview
