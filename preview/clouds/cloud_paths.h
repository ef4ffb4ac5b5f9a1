// Paths of light through clouds: a slow and noisy reference for CloudField.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "preview/clouds/cloud_field.h"
#include "preview/samples.h"

namespace citykiln::preview {

/// Scatterings after which a path ends. Droplets absorb nothing, so a path may stay in a cloud for long.
inline constexpr int kMostScatterings = 1000;

/// Returns one sample of the light that clouds send along a ray of a given length, with up to `most` scatterings.
/// `passed` is 0 or 1.
///
/// Method: distances to droplets by delta tracking (Woodcock et al. 1965), directions by Henyey and Greenstein's phase
/// function. Each droplet adds sunlight, and the path's end adds the mean light of sky or ground. No light is absorbed.
/// Unbiased, except for light that is scattered more often than `most`.
/// @param random  A function that returns independent uniform random numbers in [0, 1).
template <typename Random>
CloudPath cloud_path(const CloudField& field, Vec3 from, Vec3 direction, double distance_m, int most, Random random);

/// Returns a random distance to the next droplet on the ray; infinite if the ray leaves the clouds, or is longer than
/// `most_m`, before it.
template <typename Random>
double free_path(const CloudField& field, Vec3 from, Vec3 direction, double most_m, Random& random);

/// Returns a random direction into which light is scattered by Henyey and Greenstein's phase function.
/// @param g       The mean cosine of the angle of deflection.
/// @param chance  Two uniform random numbers in [0, 1).
Vec3 scattered(Vec3 direction, double g, UnitPair chance);

/// A generator of uniform random numbers in [0, 1) whose seed is a ray, so that each ray has other numbers.
class RayChance {
 public:
  RayChance(Vec3 from, Vec3 direction);
  double operator()() { return draw_.unit(next_++); }

 private:
  RandomSequence draw_;
  std::uint32_t next_ = 0;
};

// ---- implementation of the templates ----

// The free path inside the given parts of a ray; infinite where they end.
template <typename Random>
double free_path(const CloudSpheres& spheres, const std::vector<SpherePart>& parts, Random& random) {
  double at_m = parts.front().begin, end_m = 0;
  for (const SpherePart& part : parts) end_m = std::max(end_m, part.end);
  while (true) {
    at_m += -std::log(1 - random()) / spheres.extinction_per_m();
    if (at_m >= end_m) return std::numeric_limits<double>::infinity();
    const double density = spheres.density(parts, at_m);
    if (density >= 1 || (density > 0 && random() < density)) return at_m;
  }
}

template <typename Random>
double free_path(const CloudField& field, Vec3 from, Vec3 direction, double most_m, Random& random) {
  double nearest_m = std::numeric_limits<double>::infinity();
  std::vector<SpherePart> parts;
  for (std::size_t layer = 0; layer < field.layers(); ++layer) {
    const CloudSpheres& spheres = field.spheres(layer);
    // most paths are short: stretches of a ray, each longer than the one before
    double begin_m = 0, length_m = 4 / spheres.extinction_per_m();
    const double last_m = std::min({most_m, nearest_m, 4 * kFarthestCloud_m});
    for (; begin_m < last_m; begin_m += length_m, length_m *= 4) {
      const Vec3 at = from + direction * begin_m;
      if (begin_m > 0 && (direction.z > 0 ? at.z > spheres.top_m() : at.z < spheres.base_m())) break;
      spheres.parts_of(at, direction, std::min(length_m, last_m - begin_m), parts);
      const double free_m = parts.empty() ? nearest_m : begin_m + free_path(spheres, parts, random);
      if (!std::isfinite(free_m) || free_m >= nearest_m) continue;
      nearest_m = free_m;
      break;
    }
  }
  return nearest_m;
}

template <typename Random>
CloudPath cloud_path(const CloudField& field, Vec3 from, Vec3 direction, double distance_m, int most, Random random) {
  CloudPath path;
  const CloudLight& light = field.light();
  for (int order = 0; order < most; ++order) {
    const double free_m = free_path(field, from, direction, distance_m, random);
    if (!std::isfinite(free_m)) {
      if (order > 0) path.added = path.added + (direction.z >= 0 ? light.sky : light.ground);
      return path;
    }
    path.passed = 0, distance_m = std::numeric_limits<double>::infinity();
    if (order == 0) path.distance_m = free_m;
    from = from + direction * free_m;
    const bool is_lit = !std::isfinite(free_path(field, from, light.to_sun, distance_m, random));
    if (is_lit)
      path.added = path.added + light.sun * henyey_greenstein(dot(direction, light.to_sun), kDropletAsymmetry);
    const double u = random();
    direction = scattered(direction, kDropletAsymmetry, {u, random()});
  }
  return path;
}

}  // namespace citykiln::preview
