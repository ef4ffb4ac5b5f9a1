// Leaf atlas: the pictures that leaf cards show, of all shipped species in one image.
//
// One image for all tiles and levels, so that a tile needs one, and tiles can share it and the meshes that show it:
// where a picture lies depends on the table of species and the month alone, never on what a tile or a run holds.
#pragma once

#include <map>
#include <string_view>

#include "compiler/impostor/cutout.h"
#include "compiler/materials/material.h"
#include "compiler/plants/appearance.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

/// What a card shows (sprays.h): a spray or a clump of one, a fruit, or without a name a blade.
struct LeafPicture {
  std::string_view spray;  ///< "" for blades; kAnyFruit for fruit.
  bool is_clump = false;   ///< Never for fruit and blades.
  materials::Material material{};
  double leaf_share = 1;  ///< 1 for fruit and blades.
  auto operator<=>(const LeafPicture&) const = default;
};

inline constexpr std::string_view kAnyFruit = "fruit";

/// The part of the image that shows a picture, from its top left corner.
struct LeafPlace {
  Vec2 at_m, size_m;
};

struct LeafAtlas {
  impostor::Cutout cutout;
  std::map<LeafPicture, LeafPlace> places;
};

/// Draws the pictures of all shipped species in a month. About 60 ms.
LeafAtlas leaf_atlas(Month month);

/// Returns the place of a card's picture. @param spray  As in the .lsys file.
/// Total: a spray that the species does not have of itself is shown with the leaves of one that has it.
LeafPlace place_of(const LeafAtlas& atlas, std::string_view spray, bool is_clump, const Appearance& appearance);

}  // namespace citykiln::plants
