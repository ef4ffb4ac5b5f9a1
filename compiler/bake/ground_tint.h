// Tints of the ground: they vary between fields and within large areas.
#pragma once

#include <cstdint>

#include "compiler/ground/recipe.h"
#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::bake {

/// Multiplies a material's colour, linear, each within 0 … 1.
struct TintFactor {
  double red = 1, green = 1, blue = 1;
};

/// Whether a class is a paved surface; paved surfaces look the same whatever ways they were mapped as.
bool is_paved(map::LandCoverClass surface);

/// Whether a class changes into its neighbour without a sharp edge: grass, scrub, bare ground. Fields and gardens have
/// edges.
bool has_soft_border(map::LandCoverClass surface);

/// The tint of a surface in a month: of a field's crop (seasonal_tints.inc), of an area's brightness, drawn by its id.
/// Paved ground has none.
TintFactor surface_tint(const ground::LandCoverPolygon& surface, materials::Material material, std::uint64_t seed,
                        plants::Month month = plants::kMidsummer);

/// The tint of a material in a month (seasonal_tints.inc); none for what does not change.
TintFactor seasonal_tint(plants::Month month, materials::Material material);

/// The tint of a place: noise with wavelengths of 35 to 300 m, of brightness and, on vegetation, of dryness. A function
/// of the place, so that tiles agree.
TintFactor place_tint(Vec2 place_m, materials::Material material, std::uint64_t seed);

/// The product of both, as COLOR_0.
materials::Tint tint_of(TintFactor surface, TintFactor place);

}  // namespace citykiln::bake
