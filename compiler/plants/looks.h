// What species are coloured.
#pragma once

#include "compiler/materials/material.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

struct Look {
  materials::Material leaf_material{};
  materials::Tint leaf{}, bark{};  ///< Of leaf_material and of bark.
};

/// species_looks.inc, as tints.
Look look_of(Species species);

}  // namespace citykiln::plants
