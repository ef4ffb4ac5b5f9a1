// The type of a function that decides which places belong to a part of a map.
#pragma once

#include <functional>

namespace citykiln::source {

/// A function that is true if a place, in degrees, belongs to the part.
using OwnsPlace = std::function<bool(double lon, double lat)>;

}  // namespace citykiln::source
