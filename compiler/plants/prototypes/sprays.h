// Sprays: a twig's leaves as one flat picture, which cards of leaves are cut out by.
#pragma once

#include <span>
#include <string_view>

#include "compiler/impostor/picture.h"
#include "compiler/materials/material.h"

namespace citykiln::plants {

/// Texels along a spray; it is as long as 1.
inline constexpr std::uint32_t kSprayTexels = 64;
inline constexpr double kSprayTexel = 1.0 / kSprayTexels;

/// Width of a spray that is as long as 1; 1 where nothing of the name is known.
double width_of_spray(std::string_view name);

/// Whether it is a round fruit: what has a name that is not known.
bool is_fruit(std::string_view name);

/// LeafForm left and right of a twig, the tip on top, in three shades of grey: cards' tints colour them. What has no
/// name is opaque all over. A function of its arguments alone.
///
/// @param leafage  Of its leaves so many are there; where one is not, there is its twig.
impostor::Picture picture_of_spray(std::string_view name, materials::Material material, double leaf_share = 1);

}  // namespace citykiln::plants
