// Computes opacities of a cutout that keep its coverage on all mip levels.
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

/// The cutoff of the alpha test: texels of lower opacity are discarded.
inline constexpr std::uint8_t kAlphaCutoff = 128;

/// The covered share of each texel, 0 … 1, row by row.
struct CoverageGrid {
  std::uint32_t columns = 0, rows = 0;
  std::vector<float> share;
};

/// Returns the number of times that both sides of an image can be halved without a remainder: 5 for 64 × 96 texels.
int halvings_of(std::uint32_t columns, std::uint32_t rows);

/// Returns the opacity of each texel, row by row.
///
/// Method: on every level the texels of the greatest coverage become opaque, as many as the covered area requires, and
/// the others transparent. A texel's opacity on a level is a mean, so each requirement is a half space of opacities;
/// projection onto the half spaces in turn finds a common point (Kaczmarz's method, see Agmon, "The Relaxation Method
/// for Linear Inequalities", 1954). Readers interpolate between texels, which widens opaque areas where transparent
/// texels are near the cutoff: the number of opaque texels is reduced until the interpolated area is the covered one.
/// Guarantees: all means have a margin over readers' rounding; the mean of all opacities is at least kAlphaCutoff if
/// anything is covered, so the picture never vanishes. Tested for all shipped leaves: if they cover a fifth or more in
/// patches, the share of texels of at least kAlphaCutoff is equal on all levels of halvings_of() with 64 texels or
/// more, to 5 % of the picture. Thin lines that fill the picture, such as needles and bare twigs, are too dense on
/// small levels, since opacities have 8 bits. Deterministic on every CPU. O(texels), about 0.5 µs each.
std::vector<std::uint8_t> mip_opacity(const CoverageGrid& coverage);

}  // namespace citykiln::impostor
