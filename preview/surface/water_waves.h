// Waves of water, which are visible only in reflections.
#pragma once

#include "compiler/geometry/vec.h"
#include "compiler/materials/material.h"

namespace citykiln::preview {

/// The waves in the footprint of a pixel: the part of the surface that it covers.
struct Waves {
  Vec3 normal{0, 0, 1};     ///< Unit normal of the waves that are longer than the footprint.
  double slope_spread = 0;  ///< Variance, in one direction, of the slope of all shorter waves.
};

/// The part of the surface that a pixel covers, in plan.
struct Footprint {
  Vec2 along{1, 0};                  ///< Unit; the direction of view.
  double along_m = 1, across_m = 1;  ///< Lengths along it and across. > 0.
};

/// Returns the waves at a place of the plane, in metres. They depend on the place alone, and are smooth. The total
/// variance is the same for any footprint. A wave is seen if a pixel is shorter than a part of it in the wave's
/// direction: at grazing angles, waves along the view vanish before those across it.
/// @param strength  A factor of all slopes, above 0 and up to 1.
Waves waves_at(Vec2 place, const Footprint& footprint, double strength = 1);

/// The strength of the waves of a water: that of the open sea is 1. Waves grow with the fetch, the length of water over
/// which the wind blows.
double wave_strength(materials::Material water);

}  // namespace citykiln::preview
