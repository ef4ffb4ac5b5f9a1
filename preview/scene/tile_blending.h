// Draws a small texture that repeats as one that does not: patches of it with random offsets, blended.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "compiler/materials/texture_image.h"
#include "preview/scene/mip_texture.h"

namespace citykiln::preview {

/// Up to three patches that cover a place: where each reads the texture, and its share. Shares add up to 1.
struct BlendedPatches {
  std::array<Vec2, 3> offsets_m{};
  std::array<double, 3> shares{};
};

/// Returns the patches at a place on a triangular grid whose offsets are random, and repeat after `period_m` both ways.
/// @param side_m  The side of the texture. The grid's edges are about 0.29 of it.
BlendedPatches patches_at(Vec2 at_m, double side_m, double period_m);

/// The patch with the largest share, alone.
BlendedPatches largest_only(const BlendedPatches& patches);

/// Blends colours of a texture so that contrast and colours stay: each channel is mapped to a normal distribution,
/// blended with its variance kept, and mapped back by a table for each mip level.
///
/// Source: Heitz and Neyret, "High-Performance By-Example Noise using a Histogram-Preserving Blending Operator", HPG
/// 2018.
class BlendedColours {
 public:
  /// @param image  A square whose side is a power of two.
  explicit BlendedColours(const materials::TextureImage& image);
  BlendedColours(const BlendedColours&) = delete;
  BlendedColours& operator=(const BlendedColours&) = delete;

  /// Returns the mean linear colour over a footprint. Over the plane its mean is that of the image.
  std::array<double, 3> mean(const TextureFootprint& footprint, const BlendedPatches& patches) const;
  std::size_t bytes() const;

 private:
  using Table = std::array<std::array<float, 256>, 3>;  // by channel: linear colour of a normal deviate
  std::array<double, 3> colour_of(const std::array<double, 3>& deviate, double level) const;

  materials::TextureImage deviates_;  // bytes stand for -3 to 3 standard deviations
  MipTexture levels_;
  std::vector<Table> inverse_;  // one for each mip level
};

}  // namespace citykiln::preview
