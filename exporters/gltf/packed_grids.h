// The grids of packed attributes.
#pragma once

#include "compiler/contract/tolerance.h"

namespace citykiln::exporters {

/// Returns the step of packed positions, which are stored as integers: the largest power of two metres that is at most
/// 1/32 of the tolerance, between kQuantum_m and 2^-5 m, so that 16 bits reach 1 km. Positions move by at most √3/2
/// steps: 2.7 % of the tolerance, and 27 mm. Origins of tiles are whole metres, so the grid is the plane's own, and
/// positions that two tiles of a level share stay equal.
constexpr double packed_position_step_m(double tolerance_m) {
  double step_m = kQuantum_m;
  while (step_m < 0x1p-5 && 2 * step_m <= tolerance_m / 32) step_m *= 2;
  return step_m;
}

/// The step of prototypes (plants, lamps), as a share of packed_position_step_m(): their twigs are thinner than the
/// tolerance.
inline constexpr double kPrototypeStepRatio = 0.5;

/// The finest step of packed uvs on images.
inline constexpr double kPackedUv_m = 0x1p-9;
/// The least number of steps of packed uvs per texel of an image.
inline constexpr double kUvStepsPerTexel = 4;
/// Returns the step of packed uvs on textures, which repeat.
constexpr double packed_texture_step_m(double tolerance_m) { return tolerance_m >= 0.1 ? 0x1p-7 : 0x1p-8; }

/// The bits of each of the two coordinates of an octahedral normal, and of each component of a plain one. The error is
/// at most 1°.
inline constexpr int kPackedNormalBits = 8;

}  // namespace citykiln::exporters
