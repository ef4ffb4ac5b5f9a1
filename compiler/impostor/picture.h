// Pictures: the reflectance, emission, roughness, metalness and slope of a surface in each texel.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "compiler/materials/texture_image.h"

namespace citykiln::impostor {

/// The number of samples per texel: along each side, and in all.
inline constexpr std::uint32_t kSamplesPerSide = 4, kSamplesPerTexel = kSamplesPerSide * kSamplesPerSide;

/// The unit of slopes: 16 bits reach from -8 to 8.
inline constexpr double kSlopeUnit = 0x1p-12;

/// The mean of a texel's covered samples.
struct Texel {
  std::array<std::uint16_t, 3> light{};  ///< Linear reflectance, 65535 = 1.
  std::uint8_t roughness = 0, metalness = 0;
  std::uint16_t shown = 0;  ///< The number of covered samples, 0 … kSamplesPerTexel. If 0, all values are 0.
  std::array<std::uint16_t, 3> emission{};  ///< Linear, 65535 = materials::kEmission_cd_m2.
  std::array<std::int16_t, 2> slope{};      ///< The rise towards the viewer along rows and down columns, in kSlopeUnit.
  auto operator<=>(const Texel&) const = default;
};

/// Returns a linear colour of a texel as sRGB.
materials::TextureImage::Texel srgb_of(const std::array<std::uint16_t, 3>& linear);

/// True if the texel emits light.
inline bool emits(const Texel& texel) { return (texel.emission[0] | texel.emission[1] | texel.emission[2]) != 0; }

/// A picture without a size in metres.
struct Picture {
  std::uint32_t columns = 0, rows = 0;
  std::vector<Texel> texels;  ///< Row by row.
  auto operator<=>(const Picture&) const = default;
};

/// A picture compressed by LZ4, without loss, to be kept in memory: pictures of windows take a twentieth. Two are equal
/// if and only if their pictures are.
struct PackedPicture {
  std::uint32_t columns = 0, rows = 0;
  bool has_emission = false, has_slope = false;  ///< True if a texel has.
  std::vector<char> bytes;
  auto operator<=>(const PackedPicture&) const = default;
};

/// A packed picture that many faces show.
using SharedPicture = std::shared_ptr<const PackedPicture>;

/// Returns a picture packed. O(texels).
PackedPicture packed(const Picture& picture);
/// Returns a picture packed, to be shared. O(texels).
SharedPicture shared(const Picture& picture);
/// Returns the picture that packed() was given, bit for bit. O(texels): a gigabyte of texels per second.
Picture unpacked(const PackedPicture& picture);

/// A sum of texels, weighted by their covered samples.
class TexelSum {
 public:
  /// Adds a texel.
  void add(const Texel& texel);
  /// Returns the mean, rounded once; Texel{} if nothing is covered.
  /// @param texels  The number of texels that the mean stands for, > 0: the sum of their Texel::shown is divided by it
  ///                and rounded up. It is 4 at half the resolution, also at an edge where fewer were added.
  Texel mean(std::uint64_t texels) const;

 private:
  std::array<std::uint64_t, 3> light_{}, emission_{};
  std::array<std::int64_t, 2> slope_{};
  std::uint64_t roughness_ = 0, metalness_ = 0, shown_ = 0;
};

/// Returns the mean of all covered samples; Texel{} if there are none. O(texels).
Texel mean(const Picture& picture);

/// Returns the picture at half the resolution, with sizes rounded up: each texel is the mean of the four texels that it
/// covers. O(texels).
Picture halved(const Picture& picture);

/// Fills texels without covered samples with the mean of the picture, for texture filtering. O(texels).
void fill_gaps(Picture& picture);

}  // namespace citykiln::impostor
