// Air in a spinning cylinder: how much of it a ray passes.
//
// The square of the distance from the axis is a quadratic function of the way along a ray, so the density is a Gaussian
// turned upside down, exp(+c² t²), and the column of air its integral: Dawson's sum without its factor, by its series.
//
// Bruneton, "Modeling and rendering Rama", 2005, has exp(-16 nu (1 - r² / R²)) with nu = 1, by which the pressure at
// the axis would be 9 million times less than at the ground; about 0.10 gives the 5 that is meant. Ours is fall = 16
// nu.
#pragma once

#include "compiler/geometry/vec.h"
#include "compiler/sky/inside/recipe.h"

namespace citykiln::sky {

/// The fall of Inside with which air at the ground is five times as dense as at the axis: the logarithm of 5.
inline constexpr double kUsualFall = 1.6094379124341003;

/// Returns the density of air at a place, relative to that at the distance R (the cylinder's radius) from the axis.
/// @param p  A point of the bent world, as map::at() returns it; not plane metres.
double density_at(const Inside& inside, Vec3 p);

/// Returns the column of air along a ray, as metres of air of density 1.
/// @param from, direction  In the frame of density_at(); `direction` is a unit vector. The ray should stay within the
/// cylinder; outside of it air is denser yet. Error: below 1e-10 of the value. 0.1 µs.
double column_m(const Inside& inside, Vec3 from, Vec3 direction, double distance_m);

}  // namespace citykiln::sky
