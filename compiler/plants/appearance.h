// What species are coloured, and how the season changes it.
#pragma once

#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

struct Appearance {
  materials::Material leaf_material{};      ///< Of bare twigs, bark.
  materials::Tint leaf{}, bark{};           ///< Of leaf_material and of bark, whatever kind that is.
  double leaf_share = 1, height_share = 1;  ///< As in season.h.
};

/// species_looks.inc, as tints, and what years.inc makes of it.
Appearance appearance_of(Prototype prototype, Month month = kMidsummer);

}  // namespace citykiln::plants
