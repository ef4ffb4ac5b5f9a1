// Snapping to the grid of the plane: coordinates are doubles that are multiples of 2^-10 m.
#pragma once

#include <cassert>
#include <cmath>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/vec.h"

namespace citykiln {

/// Returns the nearest multiple of a step that is a power of two; halves round up. Exact for |v| < 2^52 steps.
inline double snapped_to(double step_m, double v) {
  assert(step_m > 0);
  return std::floor(v / step_m + 0.5) * step_m;
}
inline Vec2 snapped_to(double step_m, Vec2 p) { return {snapped_to(step_m, p.x), snapped_to(step_m, p.y)}; }

/// Returns the nearest multiple of kQuantum_m (2^-10 m).
inline double snapped(double v) { return std::floor(v * (1 / kQuantum_m) + 0.5) * kQuantum_m; }
inline Vec2 snapped(Vec2 p) { return {snapped(p.x), snapped(p.y)}; }
inline Vec3 snapped(Vec3 p) { return {snapped(p.x), snapped(p.y), snapped(p.z)}; }

}  // namespace citykiln
