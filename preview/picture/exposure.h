// Exposure of pictures.
#pragma once

#include "compiler/sky/recipe.h"
#include "preview/picture/image.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// The geometric mean luminance of pictures by day at exposure 1, measured on a view of the town from above.
inline constexpr double kMeanLuminance = 0.9;

/// Bright surfaces are not exposed above this luminance, which the tone curve shows just below white: white walls in
/// the midday sun have 3.7.
inline constexpr double kHighlights = 12;

/// Returns the factor of exposure that a camera's meter finds: it brings the geometric mean luminance of the picture,
/// weighted towards its middle, near kMeanLuminance. Darker pictures stay darker, by up to 3 of 10 stops that
/// they lack by night, and brighter ones, such as of snow, keep half of their stops. If more than 1.5 % of the pixels
/// would then be brighter than kHighlights, the factor is less, by at most 0.75 stops: lamps do not burn out. The
/// factor is from 2^-12 to 2^20, and 1 for a black picture. Three kinds of pixels do not count for the mean: the
/// brightest fiftieth, those without light, and those darker than 1/300 of the 90th percentile.
double metered_exposure(const Image& image);

/// Returns the exposure value (EV at ISO 100) of a camera that exposes as a factor does; 15.5 for 1.
double exposure_value(double factor);

/// Returns the gains of red, green and blue that half correct the colour of the light, as the eye does: 1, 1, 1 for
/// white light; from 0.6 to 1.7.
/// @param white  The radiance of a level white surface. Linear RGB.
Rgb white_balance(const Rgb& white);

/// Returns the factor of exposure for low suns and twilight, as eyes adapt: 2 to the power of a number of stops. This
/// is 0 while the sun is higher than 15 degrees, 3.6 when it sets, and 9.4 from 6 degrees below the horizon. The factor
/// is 1 while the lines inside of a cylinder shine (sky::are_lines_lit()).
double adapted_exposure(const sky::Sky& sky);

/// True if a screen shows nothing: all channels of the picture's tone-mapped mean are below 3 of 255.
bool is_black(const Image& image);

/// Multiplies the colours of a picture, but not its guides.
void balance(Image& image, const Rgb& gains);

/// Multiplies the light of a picture.
void expose(Image& image, double factor);

}  // namespace citykiln::preview
