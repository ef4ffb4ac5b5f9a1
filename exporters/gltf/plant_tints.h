// Divides the tints of plants and cars into a material's factor and vertex colours.
//
// glTF multiplies the base colour by the material's factor and by COLOR_0. Godot 3 reads no COLOR_0, so plants would
// have the pale base colours that all species share. The factor of a plant's material is therefore the largest of its
// tints in each channel, and COLOR_0 holds each tint as a share of it, which is at most 1. The paint of a car has one
// tint, so that it needs no COLOR_0 at all, a fifth of its bytes.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Returns the largest of the tints of a plant, or of Material::kCarPaint, in each channel; kNoTint for primitives on
/// an atlas and for all others.
materials::Tint largest_tint(const bake::Primitive& p);

/// Returns a tint as a share of the largest one, in 255ths, rounded to the nearest. Keeps opacity.
materials::Tint share_of(materials::Tint tint, materials::Tint largest);

/// The inverse of share_of(): tint_of(share_of(tint, largest), largest) == tint if no channel exceeds the largest.
materials::Tint tint_of(materials::Tint share, materials::Tint largest);

}  // namespace citykiln::exporters
