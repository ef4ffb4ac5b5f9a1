// A small picture of a surface: what each of its texels sends back of the light and sends out itself, how smooth it is,
// and which way it leans.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace citykiln::impostor {

/// Samples a texel has each way, and in all.
inline constexpr std::uint32_t kSamplesPerSide = 4, kSamplesPerTexel = kSamplesPerSide * kSamplesPerSide;

/// Of slopes: a 4096th of a metre a metre, so that they reach from -8 to 8.
inline constexpr double kSlopeUnit = 0x1p-12;

/// The mean of what its samples show; those that show nothing do not count.
struct Texel {
  std::array<std::uint16_t, 3> light{};  ///< Linear reflectance, 65535 = 1.
  std::uint8_t roughness = 0, metalness = 0;
  std::uint8_t shown = 0;  ///< How many samples show something: 0 … kSamplesPerTexel. 0: the rest is 0.
  std::array<std::uint16_t, 3> emission{};  ///< Linear, 65535 = materials::kEmission_cd_m2.
  std::array<std::int16_t, 2> slope{};      ///< How far it comes forward along rows and down columns, in kSlopeUnit.
  auto operator<=>(const Texel&) const = default;
};

struct Picture {
  std::uint32_t columns = 0, rows = 0;
  std::vector<Texel> texels;  ///< Row by row.
  auto operator<=>(const Picture&) const = default;
};

/// Sums texels up, each as often as samples of it show something.
class TexelSum {
 public:
  void add(const Texel& texel);
  /// Rounded once; nothing is shown where nothing is. `shown` is the mean over so many texels, rounded up.
  Texel mean(std::uint64_t texels) const;

 private:
  std::array<std::uint64_t, 3> light_{}, emission_{};
  std::array<std::int64_t, 2> slope_{};
  std::uint64_t roughness_ = 0, metalness_ = 0, shown_ = 0;
};

/// The mean of all that is shown; nothing is shown where nothing is. O(texels).
Texel mean(const Picture& picture);

/// Half as many texels each way, rounded up: each the mean of the four it covers. O(texels).
Picture halved(const Picture& picture);

/// Texels that show nothing take the mean of the picture: what lies there is not seen but for smoothing. O(texels).
void fill_gaps(Picture& picture);

}  // namespace citykiln::impostor
