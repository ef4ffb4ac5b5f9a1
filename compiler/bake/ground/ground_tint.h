// Tints of the ground, which vary between fields and within large areas.
#pragma once

#include <cstdint>

#include "compiler/ground/recipe.h"
#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::bake {

/// A factor of a material's linear colour, each component within 0 … 1.
struct TintFactor {
  double red = 1, green = 1, blue = 1;
};

/// Returns the product of two factors.
TintFactor times(TintFactor a, TintFactor b);

/// True for paved surfaces. These have no tints of their own, so that all ways look alike.
bool is_paved(map::LandCoverClass surface);

/// True for classes that change into their neighbour without a sharp edge: grass, scrub, bare ground. Fields and
/// gardens have sharp edges.
bool has_soft_border(map::LandCoverClass surface);

/// The tint of a surface in a month: the tint of a field's crop (seasonal_tints.inc), or the brightness of an area.
/// Both are drawn at random from the surface's id and the seed, in the material's range. Paved ground has no tint.
TintFactor surface_tint(const ground::LandCoverPolygon& surface, materials::Material material, std::uint64_t seed,
                        plants::Month month = plants::kMidsummer);

/// The tint of a material in a month (seasonal_tints.inc); 1 for materials that do not change with the season.
TintFactor seasonal_tint(plants::Month month, materials::Material material);

/// The tint of a place: noise of brightness and, on vegetation, of dryness, with wavelengths of 35 to 300 m. It depends
/// on the place, the material and the seed only, so neighbouring tiles agree.
TintFactor place_tint(Vec2 place_m, materials::Material material, std::uint64_t seed);

/// The product of both tints, in the form of vertex colours (COLOR_0).
materials::Tint tint_of(TintFactor surface, TintFactor place);

}  // namespace citykiln::bake
