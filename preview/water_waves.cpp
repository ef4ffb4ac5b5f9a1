#include "preview/water_waves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

// One train of waves: direction by its components, times 2π over its length.
struct Train {
  double kx, ky, phase, slope;
};

// A light breeze, 2 m/s: the whole slope's variance is 0.003 + 0.00512 · 2 (Cox, Munk, "Slopes of the Sea Surface
// Deduced from Photographs of Sun Glitter", 1956), shared by lengths that grow by the golden ratio, so that no two come
// into step, and directions within 70 degrees of the wind from the south-west. kFinest is what is shorter still.
constexpr Train kTrains[] = {{10.30, 5.93, 0.0, 0.045}, {2.10, 7.05, 1.7, 0.045},  {4.39, 1.22, 4.1, 0.042},
                             {0.27, 2.80, 2.2, 0.040},  {1.51, 0.88, 5.3, 0.036},  {0.36, 1.02, 0.9, 0.030},
                             {0.66, -0.09, 3.4, 0.026}, {0.205, 0.358, 1.1, 0.020}};
constexpr double kFinest = 0.0039;

}  // namespace

Waves waves_at(Vec2 place, double footprint_m) {
  double slope_x = 0, slope_y = 0, spread = kFinest;
  for (const Train& train : kTrains) {
    const double k = std::sqrt(train.kx * train.kx + train.ky * train.ky), length_m = 2 * std::numbers::pi / k;
    // seen in full where a wave is four pixels long, not at all at one
    const double seen = std::clamp((length_m / footprint_m - 1) / 3, 0.0, 1.0);
    spread += (1 - seen * seen) * train.slope * train.slope / 4;
    if (seen == 0) continue;
    const double slope = seen * train.slope * std::cos(train.kx * place.x + train.ky * place.y + train.phase) / k;
    slope_x += slope * train.kx;
    slope_y += slope * train.ky;
  }
  return {unit(Vec3{-slope_x, -slope_y, 1}), spread};
}

}  // namespace citykiln::preview
