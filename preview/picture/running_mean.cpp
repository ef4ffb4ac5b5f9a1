#include "preview/picture/running_mean.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace citykiln::preview {
namespace {

// Moves a mean towards another one by a share.
void blend(float& mean, double other, double share) { mean = static_cast<float>(mean + (other - mean) * share); }

double luminance_at(const float* rgb) { return luminance({rgb[0], rgb[1], rgb[2]}); }

}  // namespace

void add(PixelSums& sums, const TracedPath& path, double exposure) {
  const Rgb light = path.light * exposure;
  const FirstSurface& first = path.first;
  sums.light = sums.light + light;
  sums.albedo = sums.albedo + first.albedo;
  sums.normal = sums.normal + first.normal;
  if (first.distance_m >= 0) ++sums.hits, sums.depth_m += first.distance_m;
  // Welford 1962
  const double value = luminance(light), before = value - sums.luminance_mean;
  sums.luminance_mean += before / ++sums.count;
  sums.squares += before * (value - sums.luminance_mean);
  if (sums.votes == 0) sums.feature = first.feature;
  sums.votes += sums.feature == first.feature ? 1 : -1;
}

RunningMean::RunningMean(int width, int height, bool has_guides) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image_.width = width, image_.height = height;
  image_.rgb.resize(pixels * 3);
  squares_.resize(pixels);
  if (!has_guides) return;
  image_.guides.albedo.resize(pixels * 3), image_.guides.normal.resize(pixels * 3);
  image_.guides.depth_m.resize(pixels), image_.guides.variance.resize(pixels), image_.guides.feature.resize(pixels);
  image_.samples.resize(pixels), hits_.resize(pixels), votes_.resize(pixels);
}

void RunningMean::add(std::size_t pixel, const PixelSums& sums, int before, double share) {
  assert(sums.count > 0 && share > 0 && share <= 1);
  float* rgb = &image_.rgb[pixel * 3];
  // Chan, Golub, LeVeque 1983
  const double apart = before > 0 ? sums.luminance_mean - luminance_at(rgb) : 0;
  const double joined = apart * apart * before * sums.count / (before + sums.count);
  squares_[pixel] += static_cast<float>(sums.squares + joined);
  for (int c = 0; c < 3; ++c) blend(rgb[c], sums.light[c] / sums.count, share);
  if (!hits_.empty()) add_guides(pixel, sums, share);
}

void RunningMean::add_guides(std::size_t pixel, const PixelSums& sums, double share) {
  Guides& guides = image_.guides;
  const Vec3 normal = sums.normal * (1.0 / sums.count);
  for (int c = 0; c < 3; ++c) blend(guides.albedo[pixel * 3 + c], sums.albedo[c] / sums.count, share);
  blend(guides.normal[pixel * 3], normal.x, share);
  blend(guides.normal[pixel * 3 + 1], normal.y, share);
  blend(guides.normal[pixel * 3 + 2], normal.z, share);
  // the mean of depth with 0 for the sky, which finish() divides by the share of hits
  blend(guides.depth_m[pixel], sums.depth_m / sums.count, share);
  blend(hits_[pixel], static_cast<double>(sums.hits) / sums.count, share);
  OsmId& feature = guides.feature[pixel];
  int& votes = votes_[pixel];
  if (feature == sums.feature) {
    votes += sums.votes;
  } else if (votes >= sums.votes) {
    votes -= sums.votes;
  } else {
    feature = sums.feature, votes = sums.votes - votes;
  }
}

double RunningMean::sample_variance(std::size_t pixel, int samples) const {
  return samples > 1 ? squares_[pixel] / (samples - 1.0) : 0;
}

void RunningMean::set_samples(std::size_t pixel, int samples, double squared_weights) {
  if (hits_.empty()) return;
  image_.samples[pixel] = static_cast<std::uint32_t>(samples);
  image_.guides.variance[pixel] = static_cast<float>(sample_variance(pixel, samples) * squared_weights);
}

Image RunningMean::finish() && {
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    float& depth_m = image_.guides.depth_m[i];
    depth_m = hits_[i] > 0 ? depth_m / hits_[i] : std::numeric_limits<float>::infinity();
  }
  return std::move(image_);
}

}  // namespace citykiln::preview
