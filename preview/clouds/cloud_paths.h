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

// The free path in one layer, by delta tracking in each stretch; infinite where they end.
template <typename Random>
double free_path(const CloudField& field, const CloudHeaps& heaps, Vec3 from, Vec3 direction,
                 const std::vector<HeapStretch>& stretches, Random& random) {
  const CloudHeaps::Ray ray = heaps.ray_of(from, direction);
  for (const HeapStretch& stretch : stretches) {
    double at_m = stretch.begin;
    while ((at_m += -std::log(1 - random()) / heaps.extinction_per_m()) < stretch.end) {
      const double density = heaps.sample(ray.from + ray.along * at_m, stretch.column, field.finest_m(at_m)).density;
      if (density >= 1 || (density > 0 && random() < density)) return at_m;
    }
  }
  return std::numeric_limits<double>::infinity();
}

template <typename Random>
double free_path(const CloudField& field, Vec3 from, Vec3 direction, double most_m, Random& random) {
  double nearest_m = std::numeric_limits<double>::infinity();
  std::vector<HeapStretch> stretches;
  for (const CloudHeaps& heaps : field.layers()) {
    heaps.stretches_of(from, direction, std::min(most_m, nearest_m), stretches);
    nearest_m = std::min(nearest_m, free_path(field, heaps, from, direction, stretches, random));
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
