#include "compiler/sky/atmosphere/bands.h"

#include <algorithm>
#include <cmath>

namespace citykiln::sky {
namespace {

// The colour of each band's sunlight, if light is linear between bands, and constant beyond the outer ones.
std::array<Rgb, kBands> make_weights() {
  std::array<Rgb, kBands> weights{};
  for (int nm = kFirst_nm; nm <= kLast_nm; nm += kStep_nm) {
    const Rgb cie = matching(nm);
    const Rgb rgb = rgb_of_xyz(cie);
    const double place = std::clamp((nm - nm_of(0)) / (nm_of(1) - nm_of(0)), 0.0, kBands - 1.0);
    const int low = std::min(static_cast<int>(place), kBands - 2);
    for (int c = 0; c < 3; ++c) {
      const double light = rgb[c] * solar(nm) * kStep_nm;
      weights[low][c] += light * (1 - (place - low)), weights[low + 1][c] += light * (place - low);
    }
  }
  return weights;
}

}  // namespace

BandCoefficients band_coefficients(const Air& air) {
  BandCoefficients bands{};
  for (int b = 0; b < kBands; ++b) {
    const Coefficients c = coefficients_at(air, nm_of(b));
    bands.molecules[b] = static_cast<float>(c.molecules), bands.ozone[b] = static_cast<float>(c.ozone);
    bands.aerosols[b] = static_cast<float>(c.aerosols);
    bands.aerosols_scattered[b] = static_cast<float>(c.aerosols - c.absorbed);
  }
  return bands;
}

Rgb rgb_of(const Bands& light) {
  static const std::array<Rgb, kBands> kWeights = make_weights();
  Rgb sum{};
  for (int b = 0; b < kBands; ++b)
    for (int c = 0; c < 3; ++c) sum[c] += kWeights[b][c] * light[b];
  return sum;
}

}  // namespace citykiln::sky
