#include "compiler/sky/stars.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/sky/horizon.h"

namespace citykiln::sky {
namespace {

struct Row {
  double right_ascension_deg, declination_deg, magnitude, colour_index;
};
constexpr Row kStars[] = {
#define STAR(right_ascension_deg, declination_deg, magnitude, colour_index) \
  {right_ascension_deg, declination_deg, magnitude, colour_index},
#include "compiler/sky/bright_stars.inc"
#undef STAR
};

constexpr double kMagnitudeZero_lx = 2.54e-6;

// The colour of a star with a luminance of 1.
Rgb colour_of(double colour_index) {
  const double kelvin = 4600 * (1 / (0.92 * colour_index + 1.7) + 1 / (0.92 * colour_index + 0.62));
  Rgb xyz{};
  for (int nm = kFirst_nm; nm <= kLast_nm; nm += kStep_nm) {
    const Rgb cie = matching(nm);
    for (int c = 0; c < 3; ++c) xyz[c] += cie[c] * black_body(nm, kelvin);
  }
  Rgb rgb = rgb_of_xyz({xyz[0] / xyz[1], 1, xyz[2] / xyz[1]});
  for (double& c : rgb) c = std::max(0.0, c);
  return rgb;
}

}  // namespace

Vec3 star_direction(const Sky& sky, double right_ascension_deg, double declination_deg) {
  const Vec3 third = cross(sky.to_pole, sky.to_equinox);
  const double level = cosine(declination_deg);
  return refracted(unit(sky.to_equinox * (level * cosine(right_ascension_deg)) +
                        third * (level * sine(right_ascension_deg)) + sky.to_pole * sine(declination_deg)));
}

std::vector<Star> stars_of(const Sky& sky) {
  std::vector<Star> stars;
  for (const Row& row : kStars) {
    const Vec3 direction = star_direction(sky, row.right_ascension_deg, row.declination_deg);
    if (direction.z < 0) continue;
    Rgb light = colour_of(row.colour_index);
    for (double& c : light) c *= kMagnitudeZero_lx * std::pow(10, -0.4 * row.magnitude);
    stars.push_back({direction, light});
  }
  return stars;
}

}  // namespace citykiln::sky
