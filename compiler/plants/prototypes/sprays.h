// Sprays: pictures of a twig with its leaves, which are the alpha-tested textures of leaf cards.
#pragma once

#include <span>
#include <string_view>

#include "compiler/impostor/picture.h"
#include "compiler/materials/material.h"

namespace citykiln::plants {

/// The number of texels along a spray. Together with one texel on each side it fills a cell of a cutout (an image with
/// transparency).
inline constexpr std::uint32_t kSprayTexels = 62;
/// The size of a texel, as a share of the spray's length.
inline constexpr double kSprayTexel = 1.0 / kSprayTexels;

/// Returns the width of a spray of length 1; 1 for an unknown name.
double width_of_spray(std::string_view name);

/// True if a name is not empty (blades) and not the name of a spray: all other names stand for round fruit.
bool is_fruit(std::string_view name);

/// Returns the picture of a spray: leaves on both sides of a twig with its tip at the top, in three shades of grey that
/// a card's tint colours. Fruit is a disc; without a name (blades) the picture is opaque. Depends only on its
/// arguments.
///
/// @param leaf_share  The share of the leaves that are present. A twig shows in place of each missing leaf.
/// @param is_clump  Shows kClumpSprays smaller sprays around the middle instead of one. No effect for blades and fruit.
impostor::Picture picture_of_spray(std::string_view name, materials::Material material, double leaf_share = 1,
                                   bool is_clump = false);

/// The number of sprays in a clump, and the leaf area of a clump divided by that of a single spray (mean of the
/// species).
inline constexpr int kClumpSprays = 24;
inline constexpr double kClumpLeaves = 1.4;

}  // namespace citykiln::plants
