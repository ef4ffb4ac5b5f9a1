// Exposure of pictures.
#pragma once

#include "preview/picture/image.h"

namespace citykiln::preview {

/// The factor that makes a picture as bright as a usual picture by day: its geometric mean luminance becomes
/// kMeanLuminance. From 2^-10 to 2^20; 1 for a black picture. A fiftieth of the pixels, the brightest, and those
/// without light do not count.
double auto_exposure(const Image& image);

/// The geometric mean luminance of pictures by day at exposure 1: the mean of the town and Monaco from above.
inline constexpr double kMeanLuminance = 0.9;

/// Whether a screen shows nothing: all channels of the picture's tone-mapped mean are below 3 of 255.
bool is_black(const Image& image);

/// Multiplies the light of a picture.
void expose(Image& image, double factor);

}  // namespace citykiln::preview
