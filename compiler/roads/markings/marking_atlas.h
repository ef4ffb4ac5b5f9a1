// The marking atlas: one image with the marking layouts of a tile side by side, a column for each. A marking layout is
// the pattern of painted lines on a strip of road; u runs across the strip, v along it, in metres.
//
//     gg|  .  |gggg|  :  :  |gg      g: gutters, which repeat a layout's outermost texels
#pragma once

#include <span>
#include <vector>

#include "compiler/materials/texture_image.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// The size of the finest texel, a quarter of the narrowest line.
inline constexpr double kFinestTexel_m = 0.03;
/// The size of the coarsest texel that shows lines. Layouts for which even such texels have no room get no column.
inline constexpr double kCoarsestTexel_m = 0.5;
/// The width of the gutter on each side of a column. It keeps columns apart up to the fourth mip level, whose texel is
/// as wide as two gutters.
inline constexpr std::uint32_t kGutter_texels = 4;
/// The largest width of the image in texels, which every GPU supports. With the finest texels the image then has 3.3
/// million texels, 13 MB of RGBA.
inline constexpr std::uint32_t kWidest_texels = 8192;
/// The value of MarkingAtlas::left_m for a layout without a column.
inline constexpr double kNoColumn_m = -1;

/// The atlas of a tile.
struct MarkingAtlas {
  materials::TextureImage image;  ///< The image; kLayoutLength_m long along v. Empty without layouts.
  /// For each layout the image's u at which its own u is 0; kNoColumn_m if it has no column.
  std::vector<double> left_m;
};

/// Draws layouts into an atlas.
///
/// @param layouts  Sorted, without duplicates.
/// @param tolerance_m  The tile's tolerance.
///
/// Texels are as large as the tolerance, at least kFinestTexel_m, and divide kLayoutLength_m. If the image would exceed
/// kWidest_texels they grow until it fits: at 3 cm 245 m of strips fit side by side, at 6 cm 490 m, at 12 cm
/// 980 m, less 8 texels a layout: 23 carriageways of 10 m at 3 cm. If kCoarsestTexel_m is too small (more than 292
/// carriageways of 10 m), the last layouts get no column.
///
/// Guarantees: columns and their gutters never overlap; the maximum width holds; same bytes on every machine.
/// O(texels).
MarkingAtlas make_marking_atlas(std::span<const MarkingLayout> layouts, double tolerance_m);

}  // namespace citykiln::roads
