// The grids of packed attributes.
#pragma once

#include "compiler/contract/tolerance.h"

namespace citykiln::exporters {

/// Returns the step of packed positions: 2^-5 m for all tiles and levels from 0.1 m on, so that 16 bits reach 1 km from
/// a tile's origin; kQuantum_m at finer tolerances. Origins of tiles are whole metres, so the grid is the plane's own,
/// and positions that two tiles or levels share stay equal. Positions move by at most √3/2 steps, 27 mm.
constexpr double packed_position_step_m(double tolerance_m) { return tolerance_m >= 0.1 ? 0x1p-5 : kQuantum_m; }

/// The step of prototypes (plants, lamps), as a share of packed_position_step_m(): their twigs are thinner than the
/// tolerance.
inline constexpr double kPrototypeStepRatio = 0.25;

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
