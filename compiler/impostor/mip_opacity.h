// Opacities of a cutout that keep its coverage on all mip levels.
//
//     coverage          opacities         mean of 4      A reader makes smaller images by averaging 2 × 2 texels, and
//     1 0 0 0           255 120  90  60   146  75        discards what is below the cutoff, 128. With opacities of 255
//     0 0 0 0     ->    120 120  90  60    66  60   ->   and 0, sparse leaves would vanish: every mean is below 128.
//     0 0 0 1            60  60  60 120
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace citykiln::impostor {

/// Texels of lower opacity are discarded.
inline constexpr std::uint8_t kAlphaCutoff = 128;

/// The share of each texel that is covered, 0 … 1, row by row.
struct CoverageGrid {
  std::uint32_t columns = 0, rows = 0;
  std::vector<float> share;
};

/// Number of levels of an image made by halving, beside the image itself, on which both sides are whole: of 64 × 96
/// texels, 5.
int halvings_of(std::uint32_t columns, std::uint32_t rows);

/// Returns the opacity of each texel, row by row.
///
/// Method: on every level the texels of the greatest coverage are to be opaque, as many as the coverage asks for, and
/// the rest transparent. A texel's opacity on a level is a mean, so each asks for a half space of opacities; projection
/// onto these in turn finds a common point (Kaczmarz's method, as in Agmon, "The Relaxation Method for Linear
/// Inequalities", 1954). Readers interpolate between texels, which widens what is opaque where transparent texels are
/// near the cutoff: the number of opaque texels is reduced until the interpolated area is the covered one.
/// Guarantees: all means have a margin over readers' rounding; the mean of all opacities is at least kAlphaCutoff where
/// anything is covered, so that the picture never vanishes. Tested for all shipped leaves: where they cover a fifth or
/// more in patches, the share of texels of at least kAlphaCutoff is the same on all levels of halvings_of() with 64
/// texels or more, to 5 % of the picture. Thin lines that fill the picture, as needles and bare twigs do, are too dense
/// on small levels, since opacities have 8 bits. The same bytes on every CPU. O(texels), about 0.5 µs each.
std::vector<std::uint8_t> mip_opacity(const CoverageGrid& coverage);

}  // namespace citykiln::impostor
