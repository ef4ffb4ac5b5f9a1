#include "exporters/usd/usd_builder.h"

#include <algorithm>

namespace citykiln::exporters {

void include(UsdBounds& bounds, Vec3 point) {
  bounds.low = {std::min(bounds.low.x, point.x), std::min(bounds.low.y, point.y), std::min(bounds.low.z, point.z)};
  bounds.high = {std::max(bounds.high.x, point.x), std::max(bounds.high.y, point.y), std::max(bounds.high.z, point.z)};
}

void include(UsdBounds& bounds, const UsdBounds& other) {
  if (is_empty(other)) return;
  include(bounds, other.low), include(bounds, other.high);
}

std::array<bake::Float3, 2> extent_of(const UsdBounds& bounds) {
  const auto narrowed = [](Vec3 v) {
    return bake::Float3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  return {narrowed(bounds.low), narrowed(bounds.high)};
}

}  // namespace citykiln::exporters
