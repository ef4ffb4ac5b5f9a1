// Preetham, Shirley, Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999. Where we differ: below the
// horizon the sun is taken on it and the sky dimmed as twilight is; luminances are cut at zero, and scaled to the
// daylight that is measured under clear skies.
#include "compiler/sky/generate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/sky/sunlight.h"

namespace citykiln::sky {
namespace {

constexpr double kUnit_kcd_m2 = kUnitLuminance_cd_m2 / 1000;

// The model's clear sky lights the ground with 28 klx when the sun stands at 60 degrees; measured are 14 to 17 klx.
constexpr double kMeasuredShare = 0.55;

// Twilight loses this many powers of ten a degree (Rozenberg 1966: 400 lx at sunset, 3.4 lx at -6 degrees); the night
// sky keeps what is left.
constexpr double kTwilightPerDegree = 0.345, kNight = 1e-6;

// The horizon lies at most this low, and light from below it is what a darker ground would throw back.
constexpr double kLowestCos = 0.01, kBelowHorizon = 0.35;

// Coefficients A to E of Perez' function, each a + b T. Rows: Y, x, y.
struct Linear {
  double per_turbidity, constant;
};
constexpr Linear kPerez[3][5] = {
    {{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}},
    {{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}},
    {{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}}};

// Zenith chromaticities: polynomials of the sun's zenith angle (falling powers), for T², T and 1.
constexpr double kZenithX[3][4] = {
    {0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886}};
constexpr double kZenithY[3][4] = {
    {0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688}};

double chromaticity(const double (&rows)[3][4], double angle, double turbidity) {
  double sum = 0;
  for (const auto& row : rows) sum = sum * turbidity + ((row[0] * angle + row[1]) * angle + row[2]) * angle + row[3];
  return sum;
}

double zenith_luminance(double angle, double turbidity) {
  const double chi = (4.0 / 9 - turbidity / 120) * (std::numbers::pi - 2 * angle);
  return std::max(0.05, (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192);
}

double perez(const std::array<double, 9>& c, double cos_zenith, double cos_sun) {
  const double angle = std::acos(std::clamp(cos_sun, -1.0, 1.0));
  return (1 + c[0] * std::exp(c[1] / cos_zenith)) * (1 + c[2] * std::exp(c[3] * angle) + c[4] * cos_sun * cos_sun);
}

double twilight(double cos_zenith) {
  const double below_deg = std::asin(std::clamp(-cos_zenith, 0.0, 1.0)) * 180 / std::numbers::pi;
  return std::max(kNight, std::pow(10.0, -kTwilightPerDegree * below_deg));
}

// Relative units of a chromaticity and a luminance in kcd/m².
Rgb rgb_of(double x, double y, double luminance) {
  Rgb rgb = rgb_of_xyz({x / y * luminance, luminance, (1 - x - y) / y * luminance});
  for (double& c : rgb) c = std::max(0.0, c * (kMeasuredShare / kUnit_kcd_m2));
  return rgb;
}

}  // namespace

SkyModel generate(const Sky& sky) {
  SkyModel dome;
  dome.to_sun = unit(sky.to_sun);
  dome.sun_cos_radius = std::cos(kSunRadius_rad);
  dome.sun_radiance = sun_luminance_kcd_m2(dome.to_sun.z, sky.turbidity);
  for (double& c : dome.sun_radiance) c /= kUnit_kcd_m2;
  const double cos_zenith = std::clamp(dome.to_sun.z, 0.0, 1.0), angle = std::acos(cos_zenith);
  dome.zenith = {zenith_luminance(angle, sky.turbidity) * twilight(dome.to_sun.z),
                 chromaticity(kZenithX, angle, sky.turbidity), chromaticity(kZenithY, angle, sky.turbidity)};
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 5; ++i)
      dome.coefficients[row][i] = kPerez[row][i].per_turbidity * sky.turbidity + kPerez[row][i].constant;
    // so that the zenith itself has the zenith's value
    dome.zenith[row] /= perez(dome.coefficients[row], 1, cos_zenith);
  }
  return dome;
}

Rgb radiance(const SkyModel& dome, Vec3 direction) {
  const bool is_below = direction.z < 0;
  const Vec3 seen = is_below ? unit(Vec3{direction.x, direction.y, 0}) : direction;
  const double cos_zenith = std::max(seen.z, kLowestCos), cos_sun = dot(seen, dome.to_sun);
  std::array<double, 3> yxy{};
  for (int row = 0; row < 3; ++row) yxy[row] = dome.zenith[row] * perez(dome.coefficients[row], cos_zenith, cos_sun);
  Rgb rgb = rgb_of(yxy[1], yxy[2], std::max(0.0, yxy[0]));
  if (is_below)
    for (double& c : rgb) c *= kBelowHorizon;
  return rgb;
}

}  // namespace citykiln::sky
