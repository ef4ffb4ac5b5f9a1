// Joins the marking atlases of several tiles to one, side by side.
//
//     +-----+ +---+      +-----+-+---+
//     |  a  | | b |  ->  |  a  |g| b |   g: a gutter that repeats the last texels of a and b, so that texture
//     +-----+ |   |      |  a  |g|   |      filtering does not mix them; shorter atlases are repeated along v
//             +---+      +-----+-+---+
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::bake {

/// The joined atlas, and where each input is in it.
struct JoinedMarkingAtlases {
  materials::TextureImage sheet;  ///< The joined image.
  std::vector<double> offsets_m;  ///< One per input: the offset of its u.
};

/// Joins atlases in the given order. u runs across an atlas, v along it, in metres.
///
/// Guarantees: every texel is in the joined atlas, at its v and at its u plus the offset. Equal atlases are stored
/// once. Atlases without texels take no space. If texel sizes differ, or the result would exceed the size limits of an
/// image, all are resampled to the coarsest texel size, or to a coarser one: each texel is then the mean, in linear
/// light, of the area that it covers.
///
/// Errors: atlases of different lengths along v that do not fit without resampling. O(texels).
Result<JoinedMarkingAtlases> join_marking_atlases(std::span<const materials::TextureImage* const> sheets);

}  // namespace citykiln::bake
