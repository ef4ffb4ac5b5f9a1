// Tolerance: metres of largest deviation from the full-detail shape (Hausdorff, both ways).
#pragma once

#include <array>

namespace citykiln {

/// The default ladder of levels, finest first, metres.
inline constexpr std::array kDefaultLadder_m = {0.02, 0.1, 0.5, 2.5, 12.5};

/// Coordinates and heights of baked vertices are multiples of this. A power of two, so that float32 offsets from a
/// tile's origin are exact up to 16 km.
inline constexpr double kQuantum_m = 0x1p-10;

}  // namespace citykiln
