// Says which places belong to a part of a map.
#pragma once

#include <functional>

namespace citykiln::source {

/// Whether a place, in degrees, belongs to a part of a map.
using OwnsPlace = std::function<bool(double lon, double lat)>;

}  // namespace citykiln::source
