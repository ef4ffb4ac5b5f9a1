// The curve is Stephen Hill's fit of the ACES reference and output transforms ("BakingLab", 2016).
#include "preview/picture/tone_map.h"

#include <algorithm>
#include <cmath>

namespace citykiln::preview {
namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

constexpr Matrix kIntoFilm = {{{0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}}};
constexpr Matrix kOutOfFilm = {
    {{1.60475, -0.53108, -0.07367}, {-0.10208, 1.10813, -0.00605}, {-0.00327, -0.07276, 1.07602}}};

// In the sky's unit, a clear zenith of 1, a matt surface of reflectance 0.18 in the midday sun has about 1.1. This
// exposure maps it slightly above 0.18 of the screen's white, for streets that are half in the shade, and white walls
// just below white.
constexpr double kExposure = 0.85;

double times(const Row& row, const Row& v) { return row[0] * v[0] + row[1] * v[1] + row[2] * v[2]; }
Row times(const Matrix& m, const Row& v) { return {times(m[0], v), times(m[1], v), times(m[2], v)}; }

double curve(double v) { return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081); }

std::uint8_t srgb_byte(double v, double rounding) {
  const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::min(std::clamp(encoded, 0.0, 1.0) * 255 + rounding, 255.0));
}

}  // namespace

double dither_at(int x, int y) {
  const auto fraction = [](double v) { return v - std::floor(v); };
  return fraction(52.9829189 * fraction(0.06711056 * x + 0.00583715 * y));
}

std::array<std::uint8_t, 3> tone_map(std::span<const float, 3> rgb, double rounding) {
  Row light;
  for (int c = 0; c < 3; ++c) {
    const double v = std::isfinite(rgb[c]) ? std::max(0.0f, rgb[c]) : 0;
    light[c] = v * kExposure;
  }
  Row film = times(kIntoFilm, light);
  for (double& c : film) c = curve(c);
  const Row shown = times(kOutOfFilm, film);
  return {srgb_byte(shown[0], rounding), srgb_byte(shown[1], rounding), srgb_byte(shown[2], rounding)};
}

}  // namespace citykiln::preview
