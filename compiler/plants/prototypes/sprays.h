// Sprays: pictures of a twig with its leaves, the alpha-tested textures of leaf cards.
#pragma once

#include <span>
#include <string_view>

#include "compiler/impostor/picture.h"
#include "compiler/materials/material.h"

namespace citykiln::plants {

/// Texels along a spray, whose length is 1; with a texel on each side a cell of a cutout.
inline constexpr std::uint32_t kSprayTexels = 62;
inline constexpr double kSprayTexel = 1.0 / kSprayTexels;

/// Width of a spray of length 1; 1 for an unknown name.
double width_of_spray(std::string_view name);

/// Whether a name is that of round fruit: any name that is not a spray's.
bool is_fruit(std::string_view name);

/// The picture of a spray: leaves on both sides of a twig, its tip at the top, in three shades of grey that a card's
/// tint colours; a disc for fruit; opaque without a name. A function of its arguments alone.
///
/// @param leaf_share  Share of the leaves that are present; a twig shows in place of each missing one.
/// @param is_clump    Shows kClumpSprays smaller sprays about the middle instead of one; blades and fruit are the same.
impostor::Picture picture_of_spray(std::string_view name, materials::Material material, double leaf_share = 1,
                                   bool is_clump = false);

/// The number of a clump's sprays, and the part of a card that it covers, in that of a single spray (mean of species).
inline constexpr int kClumpSprays = 24;
inline constexpr double kClumpLeaves = 1.75;

}  // namespace citykiln::plants
