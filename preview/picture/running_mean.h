// Pixels of a picture that is being rendered: weighted means that take further samples at any time.
#pragma once

#include <cstddef>
#include <vector>

#include "preview/path_trace.h"
#include "preview/picture/image.h"

namespace citykiln::preview {

/// Sums over some samples of one pixel.
struct PixelSums {
  int count = 0, hits = 0;
  Rgb light{}, albedo{};
  Vec3 normal{};
  double depth_m = 0;                      ///< Sum over the samples that meet a surface.
  double luminance_mean = 0, squares = 0;  ///< Mean of luminance, and sum of the squared deviations from it.
  OsmId feature{};                         ///< Candidate of a majority vote (Boyer, Moore 1981).
  int votes = 0;                           ///< Votes for the candidate less votes against it.
};

/// Adds a path, with its light multiplied by `exposure`.
void add(PixelSums& sums, const TracedPath& path, double exposure);

/// A picture whose pixels are weighted means of the samples added so far. Several threads may add to different pixels
/// at once. In single precision each call of add() rounds once, so few calls with many samples are exact enough.
class RunningMean {
 public:
  /// @param has_guides  Whether guides are kept, which take 64 bytes more a pixel.
  RunningMean(int width, int height, bool has_guides);

  /// Returns the picture with the samples added until now. Its guides, if they are kept, are unfinished until finish().
  const Image& image() const { return image_; }

  /// Adds samples to a pixel.
  /// @param before  The number of samples that the pixel has already.
  /// @param share   The weight of the new samples divided by the weight of all samples, in (0, 1]; 1 for the first
  /// ones.
  void add(std::size_t pixel, const PixelSums& sums, int before, double share);

  /// Returns the estimated variance of one sample's luminance; 0 if the pixel has fewer than two samples.
  double sample_variance(std::size_t pixel, int samples) const;

  /// Sets the number of samples of a pixel, and the sum of their squared weights, where the weights add up to 1.
  void set_samples(std::size_t pixel, int samples, double squared_weights);
  /// Returns the picture with its guides. Must be called after set_samples() of all pixels.
  Image finish() &&;

 private:
  void add_guides(std::size_t pixel, const PixelSums& sums, double share);

  Image image_;
  std::vector<float> squares_;  // sum of squared deviations of luminance from its mean
  std::vector<float> hits_;     // share of the samples that meet a surface
  std::vector<int> votes_;
};

}  // namespace citykiln::preview
