// TextureImage layout: patterns side by side on one sheet.
//
//     gg|  .  |gggg|  :  :  |gg      g: gutters, the pattern's outermost texels repeated
#pragma once

#include <span>
#include <vector>

#include "compiler/materials/texture_image.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// No line of the rules is thinner than four of these.
inline constexpr double kFinestTexel_m = 0.03;
/// Of no use for lines any more: where even these do not fit, patterns go without a column.
inline constexpr double kCoarsestTexel_m = 0.5;
/// On both sides of a column: four mip levels stay apart (a texel of the fourth is as wide as both gutters).
inline constexpr std::uint32_t kGutter_texels = 4;
/// The budget: what every GPU takes across. With the finest texels that is 3.3 million of them, 13 MB of RGBA.
inline constexpr std::uint32_t kMostColumns = 8192;
/// Of a pattern that has no column.
inline constexpr double kNoColumn_m = -1;

struct MarkingAtlas {
  materials::TextureImage sheet;  ///< kLayoutLength_m along. Empty where there are no patterns.
  std::vector<double> left_m;     ///< Of each pattern's u = 0 on the sheet; kNoColumn_m where it has none.
};

/// Draws the patterns into a sheet.
///
/// @param patterns     Sorted, each once.
/// @param tolerance_m  Of the tile.
///
/// Texels are as large as the tolerance, but never finer than kFinestTexel_m, and a whole number of them is
/// kLayoutLength_m. Where the sheet would break kMostColumns they grow until it fits: at 3 cm some 245
/// m of strips fit side by side (24 carriageways of 10 m), at 6 cm 490 m, at 12 cm 980 m, less 8 texels a pattern.
/// Where kCoarsestTexel_m do not do (more than 290 carriageways of 10 m), the last patterns get no column.
///
/// Guarantees: columns and their gutters never overlap; the budget holds; same bytes on every machine and whatever was
/// drawn before. O(texels).
MarkingAtlas make_marking_atlas(std::span<const MarkingLayout> layouts, double tolerance_m);

}  // namespace citykiln::roads
