// The tints of the ground: no two fields alike, and no large field of one colour.
#pragma once

#include <cstdint>

#include "compiler/ground/recipe.h"
#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::bake {

/// What a material's colour is multiplied by, linear, each within 0 … 1.
struct TintFactor {
  double red = 1, green = 1, blue = 1;
};

/// What is paved is one surface, whatever ways it was mapped as.
bool is_paved(map::LandCoverClass surface);

/// Grass, scrub, bare ground: what goes over into its neighbour without an edge. Fields and gardens have edges.
bool has_soft_border(map::LandCoverClass surface);

/// A surface's own: a field's crop, an area's brightness, drawn by its id, in a month (ground_years.inc). Paved ground
/// has none.
TintFactor surface_tint(const ground::LandCoverPolygon& surface, materials::Material material, std::uint64_t seed,
                        plants::Month month = plants::kMidsummer);

/// The place's own, in waves of 35 to 300 m: lighter and darker, and where things grow drier and greener. A function of
/// the place, so that tiles agree.
TintFactor place_tint(Vec2 place_m, materials::Material material, std::uint64_t seed);

/// Both, as COLOR_0.
materials::Tint tint_of(TintFactor surface, TintFactor place);

}  // namespace citykiln::bake
