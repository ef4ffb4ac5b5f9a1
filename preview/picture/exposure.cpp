#include "preview/picture/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "compiler/sky/generate.h"
#include "preview/picture/tone_map.h"

namespace citykiln::preview {

namespace {

// A pixel of a picture for the meter.
struct MeteredPixel {
  double luminance, weight;
};

// Returns the pixels that the meter counts, the darkest first: pixels in the middle have the most weight, those at the
// corners about a seventh of it. The brightest fiftieth, and those without light, do not count.
std::vector<MeteredPixel> metered_pixels(const Image& image) {
  std::vector<MeteredPixel> pixels;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto i =
          (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 3;
      const double value = luminance({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
      const double aside = (2 * x + 1.0) / image.width - 1, up = (2 * y + 1.0) / image.height - 1;
      if (std::isfinite(value) && value > 0) pixels.push_back({value, std::exp(-aside * aside - up * up)});
    }
  std::ranges::sort(pixels, {}, &MeteredPixel::luminance);
  if (pixels.empty()) return pixels;
  // a night sky says nothing about the brightness of a street
  constexpr double kBlack = 1.0 / 300;
  const double bright = pixels[pixels.size() * 9 / 10].luminance;
  pixels.resize(std::max<std::size_t>(pixels.size() * 49 / 50, 1));
  const double least = std::min(bright * kBlack, pixels.back().luminance);
  pixels.erase(pixels.begin(), std::ranges::lower_bound(pixels, least, {}, &MeteredPixel::luminance));
  return pixels;
}

double geometric_mean(std::span<const MeteredPixel> pixels) {
  double sum = 0, weight = 0;
  for (const MeteredPixel& pixel : pixels) sum += std::log2(pixel.luminance) * pixel.weight, weight += pixel.weight;
  return std::exp2(sum / weight);
}

// Returns the luminance that all but the brightest 1.5 % of the pixels do not exceed.
double highlights(const Image& image) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
    if (const double v = luminance({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}); std::isfinite(v))
      values.push_back(v);
  if (values.empty()) return 0;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(values.size() - 1) * 0.985);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

// Returns the stops by which a photographer corrects a picture that the meter finds this many stops below the mean: a
// dark one stays darker, by up to 3 of 10 stops, and snow stays bright.
double corrected_stops(double stops_below) {
  constexpr double kNight_stops = 10, kDarker = 0.3, kBright = 0.5;
  if (stops_below < 0) return stops_below * kBright;
  return stops_below * (1 - kDarker * std::min(stops_below / kNight_stops, 1.0));
}

}  // namespace

double metered_exposure(const Image& image) {
  const std::vector<MeteredPixel> pixels = metered_pixels(image);
  if (pixels.empty()) return 1;
  const double stops = corrected_stops(std::log2(kMeanLuminance / geometric_mean(pixels)));
  const double factor = std::exp2(std::clamp(stops, -10.0, 20.0));
  // at most this many stops less, so that lamps and lit windows keep their colours
  constexpr double kMostProtected = 0.6;
  const double brightest = highlights(image) * factor;
  return factor * std::clamp(kHighlights / std::max(brightest, 1e-12), kMostProtected, 1.0);
}

double exposure_value(double factor) {
  constexpr double kMeter = 100 / 12.5;  // of reflected light, ISO 2720
  return std::log2(kMeter * kMeanLuminance * sky::kUnitLuminance_cd_m2 / factor);
}

Rgb white_balance(const Rgb& white) {
  constexpr double kShare = 0.5, kLeast = 0.6, kMost = 1.7;
  const double grey = luminance(white);
  if (!(grey > 0) || white[0] <= 0 || white[1] <= 0 || white[2] <= 0) return {1, 1, 1};
  Rgb gains;
  for (std::size_t c = 0; c < 3; ++c) gains[c] = std::clamp(std::pow(grey / white[c], kShare), kLeast, kMost);
  return gains;
}

double adapted_exposure(const sky::Sky& sky) {
  // the lines inside of a cylinder are as bright at all times
  if (sky::are_lines_lit(sky)) return 1;
  // degrees above the horizon, and stops: three quarters of those that clear skies' illuminance of level ground has
  // fallen by since 15 degrees, where it is 20 klx
  constexpr std::array<std::pair<double, double>, 8> kStops = {
      {{-6, 9.4}, {-3, 6.5}, {-0.8, 4.2}, {0, 3.6}, {2, 2.6}, {5, 1.5}, {10, 0.55}, {15, 0}}};
  const double height_deg = std::asin(std::clamp(sky.to_sun.z, -1.0, 1.0)) * 180 / std::numbers::pi;
  const auto above = std::ranges::lower_bound(kStops, height_deg, {}, &std::pair<double, double>::first);
  if (above == kStops.begin()) return std::exp2(kStops.front().second);
  if (above == kStops.end()) return 1;
  const auto below = above - 1;
  return std::exp2(
      std::lerp(below->second, above->second, (height_deg - below->first) / (above->first - below->first)));
}

bool is_black(const Image& image) {
  double sums[3] = {};
  for (std::size_t i = 0; i < image.rgb.size(); ++i) sums[i % 3] += image.rgb[i];
  const double pixels = std::max<double>(static_cast<double>(image.rgb.size()) / 3, 1);
  const float mean[] = {static_cast<float>(sums[0] / pixels), static_cast<float>(sums[1] / pixels),
                        static_cast<float>(sums[2] / pixels)};
  return std::ranges::max(tone_map(mean)) < 3;
}

void balance(Image& image, const Rgb& gains) {
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] *= static_cast<float>(gains[i % 3]);
}

void expose(Image& image, double factor) {
  for (float& c : image.rgb) c *= static_cast<float>(factor);
  for (float& v : image.guides.variance) v *= static_cast<float>(factor * factor);
}

}  // namespace citykiln::preview
