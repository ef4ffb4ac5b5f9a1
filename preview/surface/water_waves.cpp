#include "preview/surface/water_waves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "compiler/materials/noise.h"

namespace citykiln::preview {
namespace {

// A sine wave: its wave vector is the direction times 2π over the wavelength.
struct Wave {
  double kx, ky, phase, slope;
};

// A light breeze, 2 m/s: the whole slope's variance is 0.003 + 0.00512 · 2 (Cox, Munk, "Slopes of the Sea Surface
// Deduced from Photographs of Sun Glitter", 1956), shared by lengths that grow by the golden ratio, so that no two come
// into step, and directions within 70 degrees of the wind from the south-west. kFinest is the variance of shorter
// waves.
constexpr Wave kWaves[] = {{10.30, 5.93, 0.0, 0.045}, {2.10, 7.05, 1.7, 0.045},  {4.39, 1.22, 4.1, 0.042},
                           {0.27, 2.80, 2.2, 0.040},  {1.51, 0.88, 5.3, 0.036},  {0.36, 1.02, 0.9, 0.030},
                           {0.66, -0.09, 3.4, 0.026}, {0.205, 0.358, 1.1, 0.020}};
constexpr double kFinest = 0.0039;

// Crests wander, so that sines do not show as a comb: phases change by up to this angle over some wavelengths.
constexpr double kWander_rad = 4.5, kWanderWaves = 4;
// Waves of this many pixels are not seen, and waves of kSeenInFull are seen in full. Two samples a wave are too few.
constexpr double kUnseen_px = 2, kSeenInFull_px = 8;

// The length of a pixel in the direction of a wave.
double length_along(const Footprint& footprint, Vec2 direction) {
  const double along = dot(direction, footprint.along) * footprint.along_m,
               across = cross(direction, footprint.along) * footprint.across_m;
  return std::sqrt(along * along + across * across);
}

}  // namespace

Waves waves_at(Vec2 place, const Footprint& footprint, double strength) {
  assert(footprint.along_m > 0 && footprint.across_m > 0 && strength > 0 && strength <= 1);
  double slope_x = 0, slope_y = 0, spread = kFinest;
  std::uint64_t key = 0;
  for (const Wave& wave : kWaves) {
    ++key;
    const double k = std::sqrt(wave.kx * wave.kx + wave.ky * wave.ky), length_m = 2 * std::numbers::pi / k;
    const double pixels = length_m / length_along(footprint, Vec2{wave.kx, wave.ky} * (1 / k));
    const double seen = std::clamp((pixels - kUnseen_px) / (kSeenInFull_px - kUnseen_px), 0.0, 1.0);
    spread += (1 - seen * seen) * wave.slope * wave.slope / 4;
    if (seen == 0) continue;
    const double wander = kWander_rad * materials::noise_at(place, kWanderWaves * length_m, key);
    const double slope = seen * wave.slope * std::cos(wave.kx * place.x + wave.ky * place.y + wave.phase + wander) / k;
    slope_x += slope * wave.kx;
    slope_y += slope * wave.ky;
  }
  return {unit(Vec3{-slope_x * strength, -slope_y * strength, 1}), spread * strength * strength};
}

// Slopes of waves grow about as the fourth root of the fetch: 10 km at sea, 1 km on lakes, 200 m across rivers, 20 m on
// ponds. Ponds lie low, where there is less wind.
double wave_strength(materials::Material water) {
  using enum materials::Material;
  if (water == kWater) return 0.7;
  if (water == kRiverWater) return 0.5;
  return water == kShallowWater || water == kPoolWater ? 0.25 : 1;
}

}  // namespace citykiln::preview
