#include "preview/picture/denoise.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::preview {
namespace {

constexpr int kPasses = 4;

// Differences at which a weight falls to 1/e, chosen by the error on the town at 16 samples: from a street, and from
// above.
constexpr float kLuminanceErrors = 1.8f;  // in standard errors of luminance
constexpr float kNormal = 0.15f;          // length of the difference
constexpr float kAlbedo = 0.1f;           // root of the sum of squares
constexpr float kDepthSteps = 1;          // in depths that the surface's slope explains

// Light is divided by no less than this: darker surfaces keep their noise of texture.
constexpr float kLeastAlbedo = 0.02f;

using Rgbf = std::array<float, 3>;

struct Pixel {
  Rgbf light{};  // divided by albedo
  float variance = 0;
};

// The guides of a pixel, of which weights are made, with finite depth and slope.
struct Surface {
  Rgbf albedo{}, normal{};
  float depth_m = 0, slope_m = 0;  // slope: change of depth per pixel
};

struct Layer {
  int width, height;
  std::vector<Surface> surfaces;

  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + x; }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

float single_luminance(const Rgbf& c) { return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]; }

float squared_difference(const Rgbf& a, const Rgbf& b) {
  float sum = 0;
  for (int c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

// The colour that light is divided by: that of the surface, and white for the sky.
Rgbf divisor_of(const Surface& surface, bool is_sky) {
  Rgbf divisor{1, 1, 1};
  if (!is_sky)
    for (int c = 0; c < 3; ++c) divisor[c] = std::max(surface.albedo[c], kLeastAlbedo);
  return divisor;
}

Rgbf three(const std::vector<float>& values, std::size_t pixel) {
  return {values[pixel * 3], values[pixel * 3 + 1], values[pixel * 3 + 2]};
}

// Depth of the sky: farther than anything, so that differences are large and finite.
constexpr float kSky_m = 1e7f;

// The lesser change of depth to both neighbours along one axis: the other may be across an edge.
float slope_along(const Layer& layer, int x, int y, int dx, int dy) {
  const float here = layer.surfaces[layer.at(x, y)].depth_m;
  float slope = kSky_m;
  for (const int side : {-1, 1})
    if (layer.contains(x + side * dx, y + side * dy))
      slope = std::min(slope, std::abs(layer.surfaces[layer.at(x + side * dx, y + side * dy)].depth_m - here));
  return slope;
}

Layer layer_of(const Image& image, int threads) {
  Layer layer{image.width, image.height, std::vector<Surface>(image.guides.depth_m.size())};
  for (std::size_t i = 0; i < layer.surfaces.size(); ++i)
    layer.surfaces[i] = {three(image.guides.albedo, i), three(image.guides.normal, i),
                         std::min(image.guides.depth_m[i], kSky_m)};
  for_each_index(static_cast<std::size_t>(image.height), threads, [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < image.width; ++x)
      layer.surfaces[layer.at(x, y)].slope_m = std::max(slope_along(layer, x, y, 1, 0), slope_along(layer, x, y, 0, 1));
  });
  return layer;
}

// The variance smoothed over 3 by 3 pixels: that of one pixel is known from few samples.
float smooth_variance(const Layer& layer, const std::vector<Pixel>& pixels, int x, int y) {
  constexpr float kWeights[] = {0.25f, 0.5f, 0.25f};
  float sum = 0, weights = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      if (!layer.contains(x + dx, y + dy)) continue;
      const float weight = kWeights[dx + 1] * kWeights[dy + 1], value = pixels[layer.at(x + dx, y + dy)].variance;
      sum += weight * value, weights += weight;
    }
  return sum / weights;
}

// How much a pixel counts for another one, by their surfaces.
float likeness(const Surface& a, const Surface& b, float pixels_apart) {
  const float depth = std::abs(a.depth_m - b.depth_m) / (kDepthSteps * a.slope_m * pixels_apart + 1e-3f * a.depth_m);
  const float normal = squared_difference(a.normal, b.normal) / (kNormal * kNormal);
  const float albedo = squared_difference(a.albedo, b.albedo) / (kAlbedo * kAlbedo);
  return depth + normal + albedo;
}

Pixel filtered(const Layer& layer, const std::vector<Pixel>& pixels, int x, int y, int step) {
  constexpr float kSpline[] = {1 / 16.f, 4 / 16.f, 6 / 16.f, 4 / 16.f, 1 / 16.f};
  const std::size_t middle = layer.at(x, y);
  const Surface& surface = layer.surfaces[middle];
  const float here = single_luminance(pixels[middle].light);
  if (!std::isfinite(here)) return {};
  const float error = kLuminanceErrors * std::sqrt(smooth_variance(layer, pixels, x, y)) + 1e-6f;
  Pixel sum;
  float weights = 0;
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) {
      if (!layer.contains(x + i * step, y + j * step)) continue;
      const std::size_t at = layer.at(x + i * step, y + j * step);
      const float there = single_luminance(pixels[at].light);
      if (!std::isfinite(there)) continue;
      const float apart = static_cast<float>(step * std::max(std::abs(i), std::abs(j)));
      const float unlike =
          at == middle ? 0 : likeness(surface, layer.surfaces[at], apart) + std::abs(here - there) / error;
      const float weight = kSpline[i + 2] * kSpline[j + 2] * std::exp(-unlike);
      for (int c = 0; c < 3; ++c) sum.light[c] += weight * pixels[at].light[c];
      sum.variance += weight * weight * pixels[at].variance;
      weights += weight;
    }
  for (float& c : sum.light) c /= weights;
  sum.variance /= weights * weights;
  return sum;
}

}  // namespace

Image denoise(const Image& image, int threads) {
  assert(image.guides.variance.size() * 3 == image.rgb.size());
  const Layer layer = layer_of(image, threads);
  const auto is_sky = [&](std::size_t i) { return layer.surfaces[i].depth_m >= kSky_m; };
  const auto divisor = [&](std::size_t i) { return divisor_of(layer.surfaces[i], is_sky(i)); };
  std::vector<Pixel> pixels(layer.surfaces.size()), next(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Rgbf by = divisor(i);
    for (int c = 0; c < 3; ++c) pixels[i].light[c] = image.rgb[i * 3 + c] / by[c];
    pixels[i].variance = image.guides.variance[i] / (single_luminance(by) * single_luminance(by));
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    for_each_index(static_cast<std::size_t>(image.height), threads, [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < image.width; ++x) next[layer.at(x, y)] = filtered(layer, pixels, x, y, 1 << pass);
    });
    std::swap(pixels, next);
  }
  Image result = image;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (is_sky(i) && std::isfinite(single_luminance(three(image.rgb, i)))) continue;
    const Rgbf by = divisor(i);
    for (int c = 0; c < 3; ++c) result.rgb[i * 3 + c] = pixels[i].light[c] * by[c];
  }
  return result;
}

}  // namespace citykiln::preview
