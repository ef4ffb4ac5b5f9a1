// The colours of a species in a month, as tints of leaf and bark materials.
#pragma once

#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

struct Appearance {
  materials::Material leaf_material{};      ///< kBark where leaf_share is 0: leaf cards then show twigs.
  materials::Tint leaf{}, bark{};           ///< Tints of leaf_material and of any bark material.
  double leaf_share = 1, height_share = 1;  ///< Of SeasonState.
};

Appearance appearance_of(Prototype prototype, Month month = kMidsummer);

}  // namespace citykiln::plants
