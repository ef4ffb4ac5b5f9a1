// The difference between two pictures.
#pragma once

#include "preview/render.h"

namespace citykiln::charts {

/// The focal length, in pixels, of a picture with 1,080 lines and a field of view of 45 degrees.
inline constexpr double kChartFocal_px = 1304;

/// Returns the mean absolute difference over pixels and channels; 1 is the difference between black and white. Values
/// over 1 count as 1.
/// @param a, b  Pictures of equal size.
double difference(const preview::Image& a, const preview::Image& b);

}  // namespace citykiln::charts
