#include "preview/picture/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "preview/picture/tone_map.h"
#include "preview/rgb.h"

namespace citykiln::preview {

namespace {

// Returns how many stops the geometric mean luminance is below kMeanLuminance; 0 for a black picture. The brightest
// fiftieth of the pixels, and those without light, do not count.
double stops_below_mean(const Image& image) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
    const double value = luminance({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
    if (std::isfinite(value) && value > 0) values.push_back(value);
  }
  if (values.empty()) return 0;
  std::ranges::sort(values);
  // a night sky says nothing about the brightness of a street
  constexpr double kBlack = 1.0 / 300;
  const double bright = values[values.size() * 9 / 10];
  values.resize(std::max<std::size_t>(values.size() * 49 / 50, 1));
  values.erase(values.begin(), std::ranges::lower_bound(values, std::min(bright * kBlack, values.back())));
  double sum = 0;
  for (const double value : values) sum += std::log2(value);
  const double mean = std::exp2(sum / static_cast<double>(values.size()));
  return std::log2(kMeanLuminance / mean);
}

}  // namespace

double auto_exposure(const Image& image) {
  const double stops = stops_below_mean(image);
  return std::exp2(std::clamp(stops > 0 ? stops * 3 / 4 : stops, -10.0, 20.0));
}

double day_exposure(const Image& image, double adapted) {
  return std::max(adapted, std::exp2(stops_below_mean(image) - kShade_stops));
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

double exposure_under(const sky::Sky& sky, const Image& image) {
  return sky::is_night(sky) && !sky::are_lines_lit(sky) ? auto_exposure(image)
                                                        : day_exposure(image, adapted_exposure(sky));
}

bool is_black(const Image& image) {
  double sums[3] = {};
  for (std::size_t i = 0; i < image.rgb.size(); ++i) sums[i % 3] += image.rgb[i];
  const double pixels = std::max<double>(static_cast<double>(image.rgb.size()) / 3, 1);
  const float mean[] = {static_cast<float>(sums[0] / pixels), static_cast<float>(sums[1] / pixels),
                        static_cast<float>(sums[2] / pixels)};
  return std::ranges::max(tone_map(mean)) < 3;
}

void expose(Image& image, double factor) {
  for (float& c : image.rgb) c *= static_cast<float>(factor);
  for (float& v : image.guides.variance) v *= static_cast<float>(factor * factor);
}

}  // namespace citykiln::preview
