// Exposure of pictures.
#pragma once

#include "compiler/sky/recipe.h"
#include "preview/picture/image.h"

namespace citykiln::preview {

/// The geometric mean luminance of pictures by day at exposure 1, measured on a view of the town from above.
inline constexpr double kMeanLuminance = 0.9;

/// Returns the factor of exposure by the brightness of a picture. A picture with a geometric mean luminance above
/// kMeanLuminance is darkened to kMeanLuminance. A darker one is brightened by three quarters of the stops that it
/// lacks, so that pictures by night remain dark. The factor is from 2^-10 to 2^20, and 1 for a black picture. Three
/// kinds of pixels do not count for the mean: the brightest fiftieth, those without light, and those darker than 1/300
/// of the 90th percentile.
double auto_exposure(const Image& image);

/// By day, pictures in deep shade are brightened until their mean luminance is this many stops below kMeanLuminance.
inline constexpr double kShade_stops = 2;

/// Returns the factor for a picture by day: `adapted`, or a larger factor in deep shade (kShade_stops).
///
/// @param adapted  The result of adapted_exposure().
double day_exposure(const Image& image, double adapted);

/// Returns the factor of exposure for low suns and twilight, as eyes adapt: 2 to the power of a number of stops. This
/// is 0 while the sun is higher than 15 degrees, 3.6 when it sets, and 9.4 from 6 degrees below the horizon. The factor
/// is 1 while the lines inside of a cylinder shine (sky::are_lines_lit()).
double adapted_exposure(const sky::Sky& sky);

/// Returns the factor for a picture if the user gives none: day_exposure() by day, auto_exposure() by night, when the
/// light of streets differs too much from the light of the sky to follow from the sun.
double exposure_under(const sky::Sky& sky, const Image& image);

/// True if a screen shows nothing: all channels of the picture's tone-mapped mean are below 3 of 255.
bool is_black(const Image& image);

/// Multiplies the light of a picture.
void expose(Image& image, double factor);

}  // namespace citykiln::preview
