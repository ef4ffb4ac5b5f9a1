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

/// How the luminance of a picture differs from that of a reference, in linear light.
struct LuminanceDifference {
  double ratio = 1;  ///< The mean luminance as a share of the reference's.
  double rms = 0;    ///< Root of the mean squared difference over pixels, as a share of the reference's mean.
};

/// Returns the difference of a picture from a reference of equal size, which is not black.
LuminanceDifference luminance_difference(const preview::Image& picture, const preview::Image& reference);

}  // namespace citykiln::charts
