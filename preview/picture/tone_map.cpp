// The curve is AgX (Troy Sobotka, 2022), in Benjamin Wrensch's fit ("Minimal AgX Implementation", 2023): a matrix that
// pulls colours towards grey, a logarithm from 10 stops below middle grey to 6.5 stops above it, a sigmoid, and the
// matrix back. Contrast and saturation are those of its look "punchy", by two thirds.
#include "preview/picture/tone_map.h"

#include <algorithm>
#include <cmath>

namespace citykiln::preview {
namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

constexpr Matrix kInset = {{{0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                            {0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                            {0.0423756549057051, 0.0784336, 0.879142973793104}}};
constexpr Matrix kOutset = {{{1.19687900512017, -0.0980208811401368, -0.0990297440797205},
                             {-0.0528968517574562, 1.15190312990417, -0.0989611768448433},
                             {-0.0529716355144438, -0.0980434501171241, 1.15107367264116}}};
constexpr double kDarkest_ev = -12.47393, kBrightest_ev = 4.026069;

constexpr double kPunch = 1.22, kVividness = 1.3;

// In the sky's unit, a clear zenith of 1, a matt surface of reflectance 0.18 in the midday sun has about 1.1. This
// exposure maps it about a stop above middle grey, for streets that are half in the shade; white walls in the sun are
// two stops above it, where the curve still tells them apart.
constexpr double kExposure = 0.34;

double times(const Row& row, const Row& v) { return row[0] * v[0] + row[1] * v[1] + row[2] * v[2]; }
Row times(const Matrix& m, const Row& v) { return {times(m[0], v), times(m[1], v), times(m[2], v)}; }

// Wrensch's polynomial of the sigmoid; x in [0, 1].
double sigmoid(double x) {
  return ((((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x) - 0.00232;
}

// Encoded for a screen with a power of 2.2; 0 for no light.
double curve(double v) {
  const double ev = std::log2(std::max(v, 1e-10));
  const double share = (std::clamp(ev, kDarkest_ev, kBrightest_ev) - kDarkest_ev) / (kBrightest_ev - kDarkest_ev);
  return std::pow(std::max(sigmoid(share), 0.0), kPunch);
}

std::uint8_t screen_byte(double encoded, double rounding) {
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
  Row film = times(kInset, light);
  for (double& c : film) c = curve(c);
  const double grey = 0.2126 * film[0] + 0.7152 * film[1] + 0.0722 * film[2];
  for (double& c : film) c = grey + (c - grey) * kVividness;
  const Row shown = times(kOutset, film);
  return {screen_byte(shown[0], rounding), screen_byte(shown[1], rounding), screen_byte(shown[2], rounding)};
}

}  // namespace citykiln::preview
