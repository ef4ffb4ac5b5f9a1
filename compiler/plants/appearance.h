// The appearance of a plant in a month: materials of leaves, and tints of leaves and bark. A prototype is one of the
// few distinct plants of a species.
#pragma once

#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

/// Materials, tints, and the state of the leaves.
struct Appearance {
  /// kBark if leaf_share is 0: leaf cards (rectangles with a picture of leaves) then show twigs.
  materials::Material leaf_material{};
  materials::Tint leaf{}, bark{};  ///< The tints of leaf_material and of any bark material.
  double leaf_share = 1,
         height_share = 1;  ///< Share of the leaves that are present, and height as a share of the summer height.
};

/// Returns the appearance of a variant of a species in a month.
Appearance appearance_of(const SpeciesValues& species, std::uint8_t variant, Month month);

/// Returns the appearance of a prototype of a shipped species in a month.
Appearance appearance_of(Prototype prototype, Month month = kMidsummer);

}  // namespace citykiln::plants
