// A sheet as rays see it: smoothed as far as what a ray covers.
#pragma once

#include <array>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::preview {

/// A patch of a sheet, as a ray covers it: an ellipse about `centre`, `across_m` wide and drawn out along `along`.
struct TextureFootprint {
  Vec2 centre;          ///< Metres on the sheet.
  Vec2 along;           ///< From the middle to the far end; zero: a disk.
  double across_m = 0;  ///< Diameter. 0: the texels themselves.
};

/// What texels mean.
enum class TexelMeaning {
  kColours,  ///< sRGB.
  kNumbers,  ///< 0 … 1.
  kNormals   ///< -1 … 1 in each direction (materials::Texture).
};

/// What follows on a sheet's sides.
enum class WrapMode { kClamp, kRepeat };

/// Method: levels of half as many texels (Williams, "Pyramidal Parametrics", SIGGRAPH 1983), each of them the exact
/// mean of the whole; between texels and between levels linear, in linear light. A long patch is several round ones in
/// a row (McCormack et al., "Feline", SIGGRAPH 1999), at most 16. Along the sheet it repeats, across it as asked for.
///
/// Refers to the sheet, which must outlive it. Memory: 4 bytes a texel. Cost: O(texels), then O(1) a patch.
class MipTexture {
 public:
  static constexpr std::size_t kAllLevels = 64;
  /// @param sheet  With texels.
  /// @param levels  At most so many, the sheet's own texels among them.
  explicit MipTexture(const materials::TextureImage& sheet, TexelMeaning texels = TexelMeaning::kColours,
                      WrapMode sides = WrapMode::kClamp, std::size_t levels = kAllLevels);

  const materials::TextureImage& sheet() const { return *sheet_; }
  /// Linear reflectance, or the normal, mean over a patch. What is not finite gives the sheet's mean.
  std::array<double, 3> mean(const TextureFootprint& patch) const;

 private:
  using Texel = std::array<float, 3>;
  struct Level {
    std::size_t columns, rows;
    std::vector<Texel> texels;  // none at the finest: there they are the sheet's
  };

  Texel texel(const Level& level, std::size_t column, std::size_t row) const;
  Level halved(const Level& level) const;
  std::array<double, 3> smooth(const Level& level, Vec2 at) const;
  std::array<double, 3> disk(Vec2 at, double across_m) const;

  const materials::TextureImage* sheet_;
  TexelMeaning texels_;
  WrapMode sides_;
  std::vector<Level> levels_;
};

}  // namespace citykiln::preview
