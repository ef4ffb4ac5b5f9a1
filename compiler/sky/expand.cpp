// Preetham, Shirley, Smits, "A practical analytic model for daylight", SIGGRAPH 1999: luminance and chromaticities of a clear sky by Perez' formula. Where we
// differ: the model is not asked below the horizon or near a set sun, where it fails (Zotti et al. 2007); both are held at the nearest good value.
#include "compiler/sky/expand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace citykiln::sky {
namespace {

using Perez = std::array<double, 5>;

constexpr double kPi = std::numbers::pi;
// The sky's formulas hold for suns this high and more.
constexpr double kLowestSunCos = 0.035;
// The sun's disk as the eye sees it: half of 0.533°.
constexpr double kSunCosRadius = 0.99998919;
// kcd/m² to the renderer's unit: a clear midsummer zenith is about 1.
constexpr double kUnit = 0.16;

Perez luminance_shape(double t) { return {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771, -0.0670 * t + 0.3703}; }
Perez x_shape(double t) { return {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989, -0.0033 * t + 0.0452}; }
Perez y_shape(double t) { return {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537, -0.0109 * t + 0.0529}; }

double perez(const Perez& p, double cos_theta, double gamma, double cos_gamma) {
  return (1 + p[0] * std::exp(p[1] / cos_theta)) * (1 + p[2] * std::exp(p[3] * gamma) + p[4] * cos_gamma * cos_gamma);
}

double zenith_chromaticity(const double (&m)[3][4], double t, double s) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::pow(t, 2 - i) * (m[i][0] * s * s * s + m[i][1] * s * s + m[i][2] * s + m[i][3]);
  return sum;
}

// Luminance in kcd/m², then x and y.
Rgb zenith_of(double t, double s) {
  constexpr double kX[3][4] = {{0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886}};
  constexpr double kY[3][4] = {{0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688}};
  const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * s);
  return {(4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192, zenith_chromaticity(kX, t, s), zenith_chromaticity(kY, t, s)};
}

Rgb rgb_of(double luminance, double x, double y) {
  const double X = x / y * luminance, Z = (1 - x - y) / y * luminance;
  return {std::max(0.0, 3.2406 * X - 1.5372 * luminance - 0.4986 * Z), std::max(0.0, -0.9689 * X + 1.8758 * luminance + 0.0415 * Z),
          std::max(0.0, 0.0557 * X - 0.2040 * luminance + 1.0570 * Z)};
}

// What the air leaves of sunlight at three wavelengths (610, 550, 465 nm): Rayleigh and aerosols (Preetham, appendix A.2).
Rgb transmitted(double cos_sun, double turbidity) {
  constexpr double kMicrons[3] = {0.610, 0.550, 0.465};
  const double zenith_deg = std::acos(cos_sun) * 180 / kPi, mass = 1 / (cos_sun + 0.15 * std::pow(93.885 - zenith_deg, -1.253));
  const double beta = 0.04608 * turbidity - 0.04586;
  Rgb rgb{};
  for (int c = 0; c < 3; ++c) rgb[c] = std::exp(-0.008735 * std::pow(kMicrons[c], -4.08) * mass) * std::exp(-beta * std::pow(kMicrons[c], -1.3) * mass);
  return rgb;
}

}  // namespace

Dome expand(const Sky& sky) {
  const double t = sky.turbidity, cos_sun = std::clamp(sky.to_sun.z, kLowestSunCos, 1.0), sun = std::acos(cos_sun);
  Dome dome{unit(sky.to_sun), {}, kSunCosRadius, {}, zenith_of(t, sun)};
  const Perez shapes[3] = {luminance_shape(t), x_shape(t), y_shape(t)};
  for (int c = 0; c < 3; ++c) {
    std::copy(shapes[c].begin(), shapes[c].end(), dome.coefficients[c].begin());
    // the value that makes the formula the zenith's at the zenith
    dome.coefficients[c][5] = perez(shapes[c], 1, sun, cos_sun);
  }
  // sunlight on a surface facing it, about 128 klx above the air, over the disk's solid angle
  const Rgb air = transmitted(cos_sun, t);
  const double solid_angle = 2 * kPi * (1 - kSunCosRadius), set = sky.to_sun.z <= 0 ? 0 : 1;
  for (int c = 0; c < 3; ++c) dome.sun_radiance[c] = set * 128 * kUnit * air[c] / solid_angle;
  return dome;
}

Rgb radiance(const Dome& dome, Vec3 direction) {
  // at and below the horizon, what is seen just above it
  constexpr double kHorizon = 0.02;
  const double cos_theta = std::max(direction.z, kHorizon);
  const double cos_gamma = std::clamp(dot(direction, dome.to_sun), -1.0, 1.0), gamma = std::acos(cos_gamma);
  double value[3];
  for (int c = 0; c < 3; ++c) {
    const auto& p = dome.coefficients[c];
    value[c] = dome.zenith[c] * perez({p[0], p[1], p[2], p[3], p[4]}, cos_theta, gamma, cos_gamma) / p[5];
  }
  return rgb_of(std::max(0.0, value[0]) * kUnit, value[1], value[2]);
}

}  // namespace citykiln::sky
