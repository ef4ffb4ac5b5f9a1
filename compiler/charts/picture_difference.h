// The error of a picture against another one.
#pragma once

#include "preview/render.h"

namespace citykiln::charts {

/// Focal length of a picture with 1,080 lines and 45 degrees.
inline constexpr double kChartFocal_px = 1304;

/// Mean absolute difference over pixels and channels; 1 is the difference between black and white. Values over 1 count
/// as 1.
/// @param a, b  Of equal size.
double difference(const preview::Image& a, const preview::Image& b);

}  // namespace citykiln::charts
