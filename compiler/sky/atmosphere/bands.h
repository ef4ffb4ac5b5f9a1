// Light at twelve wavelengths (bands). Between these, light is interpolated linearly.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "compiler/sky/atmosphere/air.h"
#include "compiler/sky/spectrum.h"

namespace citykiln::sky {

inline constexpr int kBands = 12;

/// A quantity in each band. Light is relative to sunlight outside of the atmosphere. Loops over bands are vectorised.
using Bands = std::array<float, kBands>;

inline constexpr Bands filled(float value) {
  Bands bands{};
  for (float& b : bands) b = value;
  return bands;
}

/// Returns the wavelength of a band: evenly spaced from 395 to 725 nm.
inline double nm_of(int band) { return 395 + 30.0 * band; }

/// Extinction and scattering of air by band, per metre at density 1.
struct BandCoefficients {
  Bands molecules, aerosols, aerosols_scattered, ozone;
};
BandCoefficients band_coefficients(const Air& air);

/// Columns of air along a ray: the integral of the density of each component over the length, in metres.
struct Columns {
  float molecules = 0, aerosols = 0, ozone = 0;
};

/// Returns e^x for x <= 0, with an absolute error below 2e-6; e^-87 below -87. It has no branches, so that loops are
/// vectorised.
inline float exponential_below(float x) {
  const float clamped = x < -87.0f ? -87.0f : x;
  const float power = clamped * 1.44269504f;
  const std::int32_t whole = static_cast<std::int32_t>(power - 0.5f);
  const float t = (power - static_cast<float>(whole)) * 0.69314718f;
  const float e = 1 + t * (1 + t * (0.5f + t * (1.0f / 6 + t * (1.0f / 24 + t * (1.0f / 120 + t * (1.0f / 720))))));
  const std::int32_t bits = (whole + 127) << 23;
  float scale;
  std::memcpy(&scale, &bits, sizeof scale);
  return e * scale;
}

/// Returns the share of light that passes columns of air.
inline Bands transmitted(const BandCoefficients& c, const Columns& columns) {
  Bands share;
  for (int b = 0; b < kBands; ++b)
    share[b] = exponential_below(
        -(c.molecules[b] * columns.molecules + c.aerosols[b] * columns.aerosols + c.ozone[b] * columns.ozone));
  return share;
}

/// Returns the colour of light: linear sRGB in klx, where the sun outside of the atmosphere has 128; negative outside
/// of the gamut.
Rgb rgb_of(const Bands& light);

}  // namespace citykiln::sky
