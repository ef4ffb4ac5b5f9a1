// The error of a picture against another one.
#pragma once

#include "preview/render.h"

namespace citykiln::charts {

/// Mean absolute difference over pixels and channels; 1 is the difference between black and white. Values over 1 count
/// as 1.
/// @param a, b  Of equal size.
double difference(const preview::Image& a, const preview::Image& b);

}  // namespace citykiln::charts
