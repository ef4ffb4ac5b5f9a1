// Exposure of pictures.
#pragma once

#include "compiler/sky/recipe.h"
#include "preview/picture/image.h"

namespace citykiln::preview {

/// The geometric mean luminance of pictures by day at exposure 1, measured on a view of the town from above.
inline constexpr double kMeanLuminance = 0.9;

/// Returns the factor of exposure by the brightness of a picture. A picture with a geometric mean luminance above
/// kMeanLuminance is darkened to kMeanLuminance; a darker one is brightened by three quarters of the stops to
/// kMeanLuminance, so that pictures by night remain dark. From 2^-10 to 2^20; 1 for a black picture. The brightest
/// fiftieth of the pixels, pixels without light, and pixels darker than 1/300 of the 90th percentile do not count.
double auto_exposure(const Image& image);

/// The exposure, in stops below kMeanLuminance, to which pictures by day in deep shade are brightened.
inline constexpr double kShade_stops = 2;

/// Returns the factor for a picture by day: `adapted`, or a larger factor in deep shade.
/// @param adapted  The result of adapted_exposure().
double day_exposure(const Image& image, double adapted);

/// Returns the factor of exposure for low suns and twilight, as eyes adapt: 1 while the sun is higher than 15 degrees,
/// 3.6 stops when it sets, 9.4 stops from 6 degrees below the horizon.
double adapted_exposure(const sky::Sky& sky);

/// Returns the factor for a picture if the user gives none: day_exposure() by day, auto_exposure() by night, when the
/// light of streets differs too much from the light of the sky to follow from the sun.
double exposure_under(const sky::Sky& sky, const Image& image);

/// True if a screen shows nothing: all channels of the picture's tone-mapped mean are below 3 of 255.
bool is_black(const Image& image);

/// Multiplies the light of a picture.
void expose(Image& image, double factor);

}  // namespace citykiln::preview
