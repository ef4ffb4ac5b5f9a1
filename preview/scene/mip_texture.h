// An image for rays, filtered over the footprint of a ray: the part of the image that the ray covers.
#pragma once

#include <array>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::preview {

/// The part of an image that a ray covers: an ellipse about `centre`, `across_m` wide and elongated along `along`.
struct TextureFootprint {
  Vec2 centre;            ///< Metres on the image.
  Vec2 along;             ///< From the centre to the far end of the ellipse; zero: a disk.
  double across_m = 0;    ///< Diameter; 0: single texels.
  bool is_rough = false;  ///< True: the value of one texel suffices, without interpolation.
};

/// The meaning of texels.
enum class TexelMeaning {
  kColours,  ///< sRGB.
  kNumbers,  ///< 0 … 1.
  kNormals   ///< -1 … 1 in each direction (materials::Texture).
};

/// A rectangular part of an image, by its outermost texels, inclusive.
struct TexelRectangle {
  std::uint16_t left = 0, top = 0, right = 0, bottom = 0;
  bool operator==(const TexelRectangle&) const = default;
};

/// The continuation of an image beyond its left and right sides. It always repeats along v.
enum class WrapMode { kClamp, kRepeat };

/// A filtered image.
///
/// Method: mip levels (Williams, "Pyramidal Parametrics", SIGGRAPH 1983), each with exactly the mean of the image, and
/// trilinear interpolation in linear light. An elongated footprint is filtered as several disks in a row (McCormack et
/// al., "Feline", SIGGRAPH 1999), at most 16.
///
/// Refers to the image, which must outlive it. Memory: 4 bytes per texel. Cost: O(texels), then O(1) per footprint.
class MipTexture {
 public:
  static constexpr std::size_t kAllLevels = 64;
  /// @param image   Has texels.
  /// @param levels  Largest number of levels, the image itself included.
  explicit MipTexture(const materials::TextureImage& image, TexelMeaning texels = TexelMeaning::kColours,
                      WrapMode sides = WrapMode::kClamp, std::size_t levels = kAllLevels);

  const materials::TextureImage& image() const { return *image_; }
  std::size_t bytes() const;  ///< The bytes of the levels and the image.
  /// Returns the mean over a footprint: linear reflectance, numbers, or the normal. Footprints that are not finite give
  /// the mean of the image.
  std::array<double, 3> mean(const TextureFootprint& footprint) const;
  /// Returns the mean over a footprint on a part of the image. The part is continued on all sides by its outermost
  /// texels, so texels outside of it have no effect, except those that share a texel of a coarser level with the part.
  /// Requires that each level has exactly half the columns and rows of the finer one; the image does not repeat.
  std::array<double, 3> mean(const TextureFootprint& footprint, const TexelRectangle& part) const;

 private:
  using Texel = std::array<float, 3>;
  struct Level {
    std::size_t columns, rows;
    Vec2 texels_per_m;
    std::vector<Texel> texels;  // empty at level 0, which is the image
  };

  // One axis of the image, or of a part of it, on a level.
  struct Side {
    std::size_t first, count;  // its texels
    double texels_per_m;
    bool repeats;
    double at(double at_m) const;
    std::size_t texel(double at) const;
  };
  struct Window {
    const Level& level;
    Side across, down;
  };

  Texel texel(const Level& level, std::size_t column, std::size_t row) const;
  Level blank_level(std::size_t columns, std::size_t rows) const;
  Level halved(const Level& level) const;
  Window window(std::size_t level, const TexelRectangle* part) const;
  std::array<double, 3> smooth(const Window& window, Vec2 at) const;
  std::array<double, 3> nearest(Vec2 at, double across_m, const TexelRectangle* part) const;
  std::array<double, 3> disk(Vec2 at, double across_m, const TexelRectangle* part) const;
  std::array<double, 3> mean(const TextureFootprint& footprint, const TexelRectangle* part) const;

  const materials::TextureImage* image_;
  TexelMeaning texels_;
  WrapMode sides_;
  std::vector<Level> levels_;
};

}  // namespace citykiln::preview
