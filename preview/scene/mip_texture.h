// An image as rays see it, filtered over the ray's footprint.
#pragma once

#include <array>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::preview {

/// The part of an image that a ray covers: an ellipse about `centre`, `across_m` wide and elongated along `along`.
struct TextureFootprint {
  Vec2 centre;            ///< Metres on the image.
  Vec2 along;             ///< From the centre to the far end; zero: a disk.
  double across_m = 0;    ///< Diameter. 0: single texels.
  bool is_rough = false;  ///< Whether the nearest texel of the nearest level will do.
};

/// The meaning of texels.
enum class TexelMeaning {
  kColours,  ///< sRGB.
  kNumbers,  ///< 0 … 1.
  kNormals   ///< -1 … 1 in each direction (materials::Texture).
};

/// What continues an image at its left and right sides; it always repeats along v.
enum class WrapMode { kClamp, kRepeat };

/// Method: mip levels (Williams, "Pyramidal Parametrics", SIGGRAPH 1983), each with exactly the mean of the image;
/// trilinear interpolation in linear light. An elongated footprint is filtered as several disks in a row (McCormack et
/// al., "Feline", SIGGRAPH 1999), at most 16.
///
/// Refers to the image, which must outlive it. Memory: 4 bytes per texel. Cost: O(texels), then O(1) per footprint.
class MipTexture {
 public:
  static constexpr std::size_t kAllLevels = 64;
  /// @param image  With texels.
  /// @param levels  Largest number of levels, the image itself included.
  explicit MipTexture(const materials::TextureImage& image, TexelMeaning texels = TexelMeaning::kColours,
                      WrapMode sides = WrapMode::kClamp, std::size_t levels = kAllLevels);

  const materials::TextureImage& image() const { return *image_; }
  std::size_t bytes() const;  ///< With the image.
  /// The mean over a footprint: linear reflectance, numbers, or the normal. Footprints that are not finite give the
  /// mean of the image.
  std::array<double, 3> mean(const TextureFootprint& footprint) const;

 private:
  using Texel = std::array<float, 3>;
  struct Level {
    std::size_t columns, rows;
    std::vector<Texel> texels;  // empty at level 0, which is the image
  };

  Texel texel(const Level& level, std::size_t column, std::size_t row) const;
  Level halved(const Level& level) const;
  double on_level(double at_m, std::uint32_t side, std::size_t count, bool repeats) const;
  std::array<double, 3> smooth(const Level& level, Vec2 at) const;
  std::array<double, 3> nearest(Vec2 at, double across_m) const;
  std::array<double, 3> disk(Vec2 at, double across_m) const;

  const materials::TextureImage* image_;
  TexelMeaning texels_;
  WrapMode sides_;
  std::vector<Level> levels_;
};

}  // namespace citykiln::preview
