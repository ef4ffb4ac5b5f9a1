// The leaf atlas: one image with the pictures that the leaf cards of all shipped species show.
//
// All tiles and levels use this image and can share it, and also the meshes that show it. The position of a picture
// depends only on the table of species and the month, never on the content of a tile or a run.
#pragma once

#include <map>
#include <string_view>

#include "compiler/impostor/cutout.h"
#include "compiler/materials/material.h"
#include "compiler/plants/appearance.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {

/// The key of a picture. A spray is a twig with its leaves, a clump is several sprays (sprays.h).
struct LeafPicture {
  std::string_view spray;  ///< "" for blades; kAnyFruit for fruit.
  bool is_clump = false;   ///< Always false for fruit and blades.
  materials::Material material{};
  double leaf_share = 1;  ///< 1 for fruit and blades.
  auto operator<=>(const LeafPicture&) const = default;
};

/// The value of LeafPicture::spray for all round fruit.
inline constexpr std::string_view kAnyFruit = "fruit";

/// The part of the image that shows a picture: its top left corner and its size.
struct LeafPlace {
  Vec2 at_m, size_m;
};

/// The image, and the place of each picture in it.
struct LeafAtlas {
  impostor::Cutout cutout;
  std::map<LeafPicture, LeafPlace> places;
};

/// Draws the pictures of all shipped species in a month. Takes about 60 ms.
LeafAtlas leaf_atlas(Month month);

/// Returns the place of a card's picture. A spray that the species does not have is shown with the leaves of a species
/// that has it.
/// @param spray  The name in the .lsys file.
LeafPlace place_of(const LeafAtlas& atlas, std::string_view spray, bool is_clump, const Appearance& appearance);

}  // namespace citykiln::plants
