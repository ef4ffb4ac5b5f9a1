// The material and colour of ground in dry climates: grass, then straw, then bare soil and gravel.
#pragma once

#include "compiler/bake/ground/ground_tint.h"
#include "compiler/ground/cover/dry_cover.h"

namespace citykiln::bake {

/// Returns kDryGround where most ground is bare, kDryGrass where straw or bare ground shows, else the class's own
/// material.
materials::Material dry_material_of(map::LandCoverClass cover, const ground::DryShares& dry);

/// Returns the tint of kDryGround or kDryGrass for a class: its own colour, mixed with straw and soil by their shares.
/// Colours change with the shares without a step, as both materials have one colour, the lightest of the mixture.
TintFactor dry_tint(map::LandCoverClass cover, const ground::DryShares& dry);

}  // namespace citykiln::bake
