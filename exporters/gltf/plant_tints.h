// Tints of plants, as a material's factor and what varies about it.
//
// glTF multiplies the base colour by the material's factor and by COLOR_0. Godot 3 reads no COLOR_0, so plants would
// have the pale colours that are common to all species. The factor of a plant's material is therefore the largest of
// its tints in each channel, and COLOR_0 holds the shares of it, which are at most 1.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// The largest of a plant's tints in each channel; kNoTint on an atlas, and for other layers, whose
/// materials all tiles share.
materials::Tint largest_tint(const bake::Primitive& p);

/// A tint as a share of the largest one, in 255ths, rounded to the nearest. Opacity is kept.
materials::Tint share_of(materials::Tint tint, materials::Tint largest);

/// Inverse of share_of(): tint_of(share_of(tint, largest), largest) == tint where no channel is above the largest.
materials::Tint tint_of(materials::Tint share, materials::Tint largest);

}  // namespace citykiln::exporters
