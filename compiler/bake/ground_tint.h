// The tints of the ground: no two fields alike, and no large field of one colour.
#pragma once

#include <cstdint>

#include "compiler/ground/recipe.h"
#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::bake {

/// What a material's colour is multiplied by, linear, each within 0 … 1.
struct Shade {
  double red = 1, green = 1, blue = 1;
};

/// What is paved is one surface, whatever ways it was mapped as.
bool is_paved(map::SurfaceClass surface);

/// Grass, scrub, bare ground: what goes over into its neighbour without an edge. Fields and gardens have edges.
bool is_soft(map::SurfaceClass surface);

/// A surface's own: a field's crop, an area's brightness, drawn by its id, in a month (ground_years.inc). Paved ground
/// has none.
Shade shade_of(const ground::Surface& surface, materials::Material material, std::uint64_t seed,
               plants::Month month = plants::kMidsummer);

/// The place's own, in waves of 35 to 300 m: lighter and darker, and where things grow drier and greener. A function of
/// the place, so that tiles agree.
Shade shade_at(Vec2 place_m, materials::Material material, std::uint64_t seed);

/// Both, as COLOR_0.
materials::Tint tint_of(Shade surface, Shade place);

}  // namespace citykiln::bake
