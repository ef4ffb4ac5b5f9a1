// The appearance of a species in a month: materials of leaves, and tints of leaves and bark.
#pragma once

#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

struct Appearance {
  materials::Material leaf_material{};      ///< kBark if leaf_share is 0: leaf cards then show twigs.
  materials::Tint leaf{}, bark{};           ///< The tints of leaf_material and of any bark material.
  double leaf_share = 1, height_share = 1;  ///< The members of SeasonState with these names.
};

Appearance appearance_of(Prototype prototype, Month month = kMidsummer);

}  // namespace citykiln::plants
