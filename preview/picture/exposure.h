// Exposure of pictures.
#pragma once

#include "compiler/sky/recipe.h"
#include "preview/picture/image.h"

namespace citykiln::preview {

/// The geometric mean luminance of pictures by day at exposure 1: the town from above.
inline constexpr double kMeanLuminance = 0.9;

/// The factor that makes a picture about as bright as one by day: its geometric mean luminance becomes kMeanLuminance,
/// and a stop less for every 4 stops that it is darker than that, so that night stays night. From 2^-10 to 2^20; 1 for
/// a black picture. The brightest fiftieth of the pixels, and those without light, do not count.
double auto_exposure(const Image& image);

/// Pictures by day are brightened in deep shade, until they are this much darker than kMeanLuminance.
inline constexpr double kShade_stops = 2;

/// The factor for a picture by day: that of adapted eyes, or in deep shade more.
double day_exposure(const Image& image, double adapted);

/// Factor of exposure for low suns and twilight, as eyes adapt: 1 while the sun is higher than 15 degrees, 3.6 stops
/// when it sets, 9.4 stops from 6 degrees below the horizon.
double adapted_exposure(const sky::Sky& sky);

/// The factor for a picture when none is asked for: by day day_exposure(); by night auto_exposure(), since streets have
/// a thousand times the light of the sky, or none.
double exposure_under(const sky::Sky& sky, const Image& image);

/// Whether a screen shows nothing: all channels of the picture's tone-mapped mean are below 3 of 255.
bool is_black(const Image& image);

/// Multiplies the light of a picture.
void expose(Image& image, double factor);

}  // namespace citykiln::preview
