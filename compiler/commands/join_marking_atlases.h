// The sheets of several tiles as one, side by side.
//
//     +-----+ +---+      +-----+-+---+
//     |  a  | | b |  ->  |  a  |g| b |   g: a gutter of a's and b's last texels, so that smoothing mixes in nothing
//     else
//     +-----+ |   |      |  a  |g|   |   shorter sheets repeat, as they do along v anyway
//             +---+      +-----+-+---+
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::commands {

struct JoinedMarkingAtlases {
  materials::TextureImage sheet;
  std::vector<double> offsets_m;  ///< One a sheet: what to add to its u.
};

/// Guarantees: every texel of every sheet is in the joined one, at its v and its u plus the offset; equal sheets are in
/// it once; sheets without texels take no room. Where texels differ, or there would be more than a sheet may have, all
/// are drawn coarser, as coarse as it takes: each texel the mean, in linear light, of what it covers.
///
/// @param sheets  Where the joined one will be drawn, in this order.
/// Errors: sheets of different lengths along v that are too many. O(texels).
Result<JoinedMarkingAtlases> join_marking_atlases(std::span<const materials::TextureImage* const> sheets);

}  // namespace citykiln::commands
