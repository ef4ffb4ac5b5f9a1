// Gradient noise of the plane, with a hash that mixes both coordinates.
#pragma once

#include <cstdint>

#include "compiler/geometry/vec.h"

namespace citykiln::invent {

/// Returns 64 bits that depend on both coordinates and the seed. A change of one bit changes half of the result's bits
/// on average; equal sums of coordinates give different hashes.
std::uint64_t hash_of(std::int64_t x, std::int64_t y, std::uint64_t seed);

/// Returns Perlin's gradient noise, from -1 to 1, zero on whole coordinates, with continuous second derivatives.
/// Source: Perlin, "Improving Noise", SIGGRAPH 2002, with sixteen directions of the plane. Every CPU gives the same
/// bits.
double perlin(Vec2 p, std::uint64_t seed);

/// Returns the sum of `octaves` noises, each with twice the frequency and half the height of the one before, divided by
/// the sum of heights: from -1 to 1.
double fractal_noise(Vec2 p, int octaves, std::uint64_t seed);

/// Returns ridged noise from 0 to 1: ridges where the noise is zero, sharper where the octave before is high. Source:
/// Musgrave, in Ebert et al., "Texturing and Modeling", 1998.
double ridged_noise(Vec2 p, int octaves, std::uint64_t seed);

}  // namespace citykiln::invent
