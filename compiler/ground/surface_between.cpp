#include "compiler/ground/surface_between.h"

#include "compiler/ground/surface_map.h"

namespace citykiln::ground {

std::uint32_t surface_between(std::span<const Border> borders, Vec2 p) {
  const Border* above = nullptr;
  double least_m = 0;
  for (const Border& border : borders) {
    const Vec2 a = plane_point(border.a), b = plane_point(border.b);
    // a is the western end; upright borders are passed by
    if (p.x < a.x || p.x >= b.x) continue;
    const double rise_m = a.y + (b.y - a.y) * ((p.x - a.x) / (b.x - a.x)) - p.y;
    if (rise_m < 0 || (above != nullptr && rise_m >= least_m)) continue;
    above = &border;
    least_m = rise_m;
  }
  return above == nullptr ? kNoSurface : above->right;
}

}  // namespace citykiln::ground
