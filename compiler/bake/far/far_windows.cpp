#include "compiler/bake/far/far_windows.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::bake {
namespace {

using materials::TextureImage;

// A bay and a storey have 8 × 8 texels, of which the window has 4 × 4. Below the foot are three storeys of wall.
constexpr std::uint32_t kSide = 8, kFrom = 2, kUpTo = 6;
constexpr double kWindowTexel_m = kBay_m / kSide;
constexpr std::uint32_t kBelow = 3;
constexpr double kCellHeight_m = kSide * kWindowTexel_m;

// sRGB: walls, panes that show a dark room, and those with curtains. One in four has curtains.
constexpr TextureImage::Texel kWall = {255, 255, 255}, kPane = {92, 100, 110}, kCurtain = {178, 176, 168};
constexpr double kCurtains = 0.25;
// Linear: occlusion, roughness, metalness.
constexpr TextureImage::Texel kRough = {255, 230, 0}, kSmooth = {255, 64, 0};

bool is_window(std::uint32_t column, std::uint32_t row) {
  const auto is_within = [](std::uint32_t texel) { return texel % kSide >= kFrom && texel % kSide < kUpTo; };
  return row < kMostStoreys * kSide && is_within(column) && is_within(row);
}

bool has_curtain(std::uint32_t column, std::uint32_t row) {
  const RandomSequence draw(1, StableId{1}, "curtains");
  return draw.unit(row / kSide * kMostBays + column / kSide) < kCurtains;
}

}  // namespace

impostor::Atlas far_windows() {
  impostor::Atlas atlas;
  for (TextureImage* image : {&atlas.colour, &atlas.surface}) {
    image->texel_m = kWindowTexel_m;
    image->columns = kMostBays * kSide, image->rows = (kMostStoreys + kBelow) * kSide;
  }
  for (std::uint32_t row = 0; row < atlas.colour.rows; ++row)
    for (std::uint32_t column = 0; column < atlas.colour.columns; ++column) {
      const bool is_pane = is_window(column, row);
      atlas.colour.texels.push_back(!is_pane ? kWall : has_curtain(column, row) ? kCurtain : kPane);
      atlas.surface.texels.push_back(is_pane ? kSmooth : kRough);
    }
  return atlas;
}

FarWindowPart window_part(double length_m, double width_m, double height_m, double below_m) {
  const auto count = [](double m, double each_m, int most) {
    return std::clamp(std::floor(m / each_m + 0.5), 1.0, static_cast<double>(most));
  };
  const double across = count(width_m, kBay_m, kMostBays / 2),
               along = std::min(count(length_m, kBay_m, kMostBays), kMostBays - across),
               storeys = count(height_m, kStorey_m, kMostStoreys);
  constexpr double kFoot_m = kMostStoreys * kCellHeight_m, kEnd_m = (kMostStoreys + kBelow) * kCellHeight_m;
  return {.corners_m = {across * kBay_m, (along + across) * kBay_m, along * kBay_m, 0},
          .eaves_m = kFoot_m - storeys * kCellHeight_m,
          .foot_m = kFoot_m,
          .below_m = std::min(kEnd_m - kWindowTexel_m, kFoot_m + below_m * storeys * kCellHeight_m / height_m)};
}

}  // namespace citykiln::bake
