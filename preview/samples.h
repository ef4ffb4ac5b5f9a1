// Random samples of the renderer: a pure function of (seed, pixel, sample, dimension). They are evenly distributed
// within a pixel and between neighbouring pixels.
#pragma once

#include <array>
#include <cstdint>

namespace citykiln::preview {

/// A point of the unit square, each coordinate in [0, 1).
struct UnitPair {
  double u = 0, v = 0;
};

/// The size of a picture in powers of two, which decides the order of samples.
struct SampleGrid {
  int log2_side = 0;     ///< Side of the smallest square of pixels that holds the picture.
  int log2_samples = 0;  ///< Samples per pixel, rounded up.
};

/// Returns the smallest grid for a picture. Sizes and samples below 1 count as 1.
/// @param samples  The number of samples per pixel.
SampleGrid grid_of(int width, int height, int samples);

/// The samples of one pixel. A dimension is the number of a decision of a path, such as the direction of its first
/// reflection. Not thread-safe. Cost: log2_side hashes for each dimension that is used.
///
/// Method: Owen-scrambled Sobol points in the order of a shuffled Morton curve. Every aligned square of pixels has
/// evenly distributed points too, and the remaining error looks like fine grain instead of clumps. Source: Ahmed,
/// Wonka, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering of Pixels",
/// SIGGRAPH Asia 2020; scrambling by hash as in Laine, Karras 2011 and Vegdahl 2021.
class PixelSamples {
 public:
  PixelSamples(std::uint64_t seed, std::uint32_t x, std::uint32_t y, SampleGrid grid);

  /// Returns the point of a sample in a dimension. One dimension here is two dimensions of Sobol's sequence.
  /// @param sample     From 0, below the grid's number of samples.
  /// @param dimension  From 0.
  UnitPair pair(std::uint32_t sample, std::uint32_t dimension) const;

 private:
  std::uint64_t place(std::uint32_t dimension) const;

  // higher dimensions are plain hashes: by then a path carries little light
  static constexpr std::uint32_t kOrdered = 20;
  std::uint64_t seed_, morton_;
  SampleGrid grid_;
  // the pixel's index along the curve of each dimension, computed when a path first needs it
  mutable std::array<std::uint64_t, kOrdered> places_;
  mutable std::uint32_t found_ = 0;
};

/// The random numbers of one path.
class PathDraw {
 public:
  PathDraw(const PixelSamples& pixel, std::uint32_t sample) : pixel_(&pixel), sample_(sample) {}
  /// Returns the point of the path's next dimension.
  UnitPair next() { return pixel_->pair(sample_, dimension_++); }

 private:
  const PixelSamples* pixel_;
  std::uint32_t sample_, dimension_ = 0;
};

}  // namespace citykiln::preview
