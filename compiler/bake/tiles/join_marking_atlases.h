// Joins the marking atlases of several tiles to one, side by side. A marking atlas is the image of a tile's road
// markings: u runs across it, v along it, both in metres, and it repeats along v.
//
//     +-----+ +---+      +-----+-+---+
//     |  a  | | b |  ->  |  a  |g| b |   g: a gutter that repeats the last texels of a and b, so that texture
//     +-----+ |   |      |  a  |g|   |      filtering does not mix them. Here a has fewer rows, so it is repeated
//             +---+      +-----+-+---+
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::bake {

/// The joined atlas, and where each input is in it.
struct JoinedMarkingAtlases {
  materials::TextureImage image;  ///< The joined atlas.
  std::vector<double> offsets_m;  ///< One per input: the distance by which its u moves in the joined atlas.
};

/// Joins atlases in the given order.
/// @param atlases  The atlases. None is null.
///
/// Guarantees: every texel is in the joined atlas, at its v and at its u plus the offset. Equal atlases are stored
/// once. Atlases without texels take no space. The number of rows is the least common multiple of the atlases' rows, so
/// each atlas is repeated a whole number of times.
///
/// If texel sizes differ, or the result would exceed the size limits of an image, all atlases are resampled to the
/// coarsest texel size, or to a coarser one: each texel is then the mean, in linear light, of the area that it covers.
///
/// Errors: atlases that would have to be resampled but differ in length along v. O(texels).
Result<JoinedMarkingAtlases> join_marking_atlases(std::span<const materials::TextureImage* const> atlases);

}  // namespace citykiln::bake
