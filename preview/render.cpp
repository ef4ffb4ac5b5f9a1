#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/contract/for_each_slot.h"
#include "preview/preview.h"
#include "preview/shade.h"

namespace citykiln::preview {
namespace {

constexpr int kBlock_px = 32;

// The camera's axes, and how far its picture reaches at distance 1.
struct Lens {
  Vec3 forward, right, up;
  double half_width, half_height;
};

Lens lens_of(const Camera& camera, const Options& options) {
  const Vec3 forward = unit(camera.look_at - camera.eye);
  // straight up or down, north is up
  const Vec3 pole = std::abs(forward.z) > 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 right = unit(cross(forward, pole));
  const double half_height = std::tan(camera.vertical_fov_deg * std::numbers::pi / 360);
  return {forward, right, cross(right, forward), half_height * options.width / options.height, half_height};
}

// A tent of one pixel's half width either way: smooth edges without blur.
double tent(float u) { return u < 0.5f ? std::sqrt(2.0 * u) - 1 : 1 - std::sqrt(2.0 - 2.0 * u); }

std::array<double, 3> pixel(const Stage& stage, const Lens& lens, const Options& options, int x, int y) {
  std::array<double, 3> sum{};
  for (int sample = 0; sample < options.samples; ++sample) {
    PathDraw draw(options.seed, static_cast<std::uint32_t>(y * options.width + x), static_cast<std::uint32_t>(sample));
    const double px = (2 * (x + 0.5 + tent(draw.next())) / options.width - 1) * lens.half_width;
    const double py = (1 - 2 * (y + 0.5 + tent(draw.next())) / options.height) * lens.half_height;
    const auto light = trace(stage, {}, unit(lens.forward + lens.right * px + lens.up * py), draw);
    for (int c = 0; c < 3; ++c) sum[c] += light[c];
  }
  for (double& c : sum) c *= options.exposure / options.samples;
  return sum;
}

}  // namespace

Image render(std::span<const bake::BakedTile> tiles, const sky::Sky& sky, const Camera& camera, const Options& options) {
  // the eye is the world's origin: rounding is finest where pixels are
  const World world(tiles, camera.eye);
  const sky::Dome dome = sky::expand(sky);
  const Stage stage{world, dome, options.bounces};
  const Lens lens = lens_of(camera, options);
  Image image{options.width, options.height, std::vector<float>(static_cast<std::size_t>(options.width) * options.height * 3)};
  const int across = (options.width + kBlock_px - 1) / kBlock_px, down = (options.height + kBlock_px - 1) / kBlock_px;
  for_each_index(static_cast<std::size_t>(across) * down, options.threads, [&](std::size_t block) {
    const int x0 = static_cast<int>(block) % across * kBlock_px, y0 = static_cast<int>(block) / across * kBlock_px;
    for (int y = y0; y < std::min(y0 + kBlock_px, options.height); ++y)
      for (int x = x0; x < std::min(x0 + kBlock_px, options.width); ++x) {
        const auto rgb = pixel(stage, lens, options, x, y);
        float* out = &image.rgb[(static_cast<std::size_t>(y) * options.width + x) * 3];
        for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(rgb[c]);
      }
  });
  return image;
}

}  // namespace citykiln::preview
