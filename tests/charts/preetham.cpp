// Sky radiance after Preetham, Shirley, Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999, appendix 2: at
// zenith angle θ and angle γ from the sun, luminance and chromaticities are zenith · F(θ, γ) / F(0, θ_sun), with the
// function F of Perez et al. 1993. Differences: when the sun is below the horizon, the sky of a sun at the horizon is
// dimmed as twilight is; negative values are clamped to 0; luminances are scaled to measured daylight.
#include "tests/charts/preetham.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace citykiln::charts {
namespace {

// The model's clear sky illuminates the ground with 28 klx for a sun at 60 degrees; measured are 14 to 17 klx.
constexpr double kMeasuredShare = 0.55;

// Decades of luminance per degree of sun depression (Rozenberg 1966: 400 lx at sunset, 3.4 lx at -6 degrees), and the
// share that remains at night.
constexpr double kTwilightPerDegree = 0.345, kNight = 1e-6;

// F has a pole at the horizon: smaller cosines of the zenith angle are clamped.
constexpr double kMinCosZenith = 0.01;

// Coefficients A to E of F for Y, x and y: linear in the turbidity.
struct Linear {
  double per_turbidity, constant;
};
constexpr Linear kPerez[3][5] = {
    {{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}},
    {{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}},
    {{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}}};

// Chromaticities at the zenith: cubic polynomials of the sun's zenith angle (falling powers), times T², T and 1.
constexpr double kZenithX[3][4] = {
    {0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886}};
constexpr double kZenithY[3][4] = {
    {0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688}};

double chromaticity(const double (&rows)[3][4], double angle, double turbidity) {
  double sum = 0;
  for (const auto& row : rows) sum = sum * turbidity + ((row[0] * angle + row[1]) * angle + row[2]) * angle + row[3];
  return sum;
}

// kcd/m². Not below 0.05: the formula becomes negative for low suns.
double zenith_luminance(double angle, double turbidity) {
  const double chi = (4.0 / 9 - turbidity / 120) * (std::numbers::pi - 2 * angle);
  return std::max(0.05, (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192);
}

// F(θ, γ) = (1 + A e^(B / cos θ)) (1 + C e^(D γ) + E cos² γ).
double perez(const std::array<double, 5>& c, double cos_zenith, double cos_sun) {
  const double angle = std::acos(std::clamp(cos_sun, -1.0, 1.0));
  return (1 + c[0] * std::exp(c[1] / cos_zenith)) * (1 + c[2] * std::exp(c[3] * angle) + c[4] * cos_sun * cos_sun);
}

double twilight(double cos_zenith) {
  const double below_deg = std::asin(std::clamp(-cos_zenith, 0.0, 1.0)) * 180 / std::numbers::pi;
  return std::max(kNight, std::pow(10.0, -kTwilightPerDegree * below_deg));
}

// Converts chromaticity and luminance (kcd/m²) to linear RGB, kcd/m².
sky::Rgb rgb_of_chromaticity(double x, double y, double luminance) {
  sky::Rgb rgb = sky::rgb_of_xyz({x / y * luminance, luminance, (1 - x - y) / y * luminance});
  for (double& c : rgb) c = std::max(0.0, c * kMeasuredShare);
  return rgb;
}

}  // namespace

PreethamSky preetham_sky(Vec3 to_sun, double turbidity) {
  PreethamSky sky;
  sky.to_sun = unit(to_sun);
  const double cos_zenith = std::clamp(sky.to_sun.z, 0.0, 1.0), angle = std::acos(cos_zenith);
  sky.zenith = {zenith_luminance(angle, turbidity) * twilight(sky.to_sun.z), chromaticity(kZenithX, angle, turbidity),
                chromaticity(kZenithY, angle, turbidity)};
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 5; ++i)
      sky.coefficients[row][i] = kPerez[row][i].per_turbidity * turbidity + kPerez[row][i].constant;
    sky.zenith[row] /= perez(sky.coefficients[row], 1, cos_zenith);
  }
  return sky;
}

sky::Rgb radiance(const PreethamSky& sky, Vec3 direction) {
  const double cos_zenith = std::max(direction.z, kMinCosZenith), cos_sun = dot(direction, sky.to_sun);
  std::array<double, 3> yxy{};
  for (int row = 0; row < 3; ++row) yxy[row] = sky.zenith[row] * perez(sky.coefficients[row], cos_zenith, cos_sun);
  return rgb_of_chromaticity(yxy[1], yxy[2], std::max(0.0, yxy[0]));
}

}  // namespace citykiln::charts
