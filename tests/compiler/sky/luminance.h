// Luminance of colours, for tests of the sky.
#pragma once

#include "compiler/sky/spectrum.h"

namespace citykiln::sky {

/// The luminance of a linear sRGB colour.
inline double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

}  // namespace citykiln::sky
