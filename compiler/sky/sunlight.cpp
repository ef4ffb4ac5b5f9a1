#include "compiler/sky/sunlight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace citykiln::sky {
namespace {

// Illuminance of the sun outside of the atmosphere, klx, and the solid angle of its disk.
constexpr double kSolar_klx = 128;
constexpr double kSolidAngle_sr = std::numbers::pi * kSunRadius_rad * kSunRadius_rad;

constexpr int kFirst_nm = 380, kLast_nm = 780, kStep_nm = 5;

// Absorption of ozone in the Chappuis band, 1/cm, every 10 nm from 450 (Iqbal 1983); a layer of 0.35 cm.
constexpr std::array kOzone = {.003, .006, .009, .014, .021, .030, .040, .048, .063, .075, .085, .103, .120, .120,
                               .115, .125, .120, .105, .090, .079, .067, .057, .048, .036, .028, .023, .018};
constexpr double kOzoneLayer_cm = 0.35;

double ozone(double nm) {
  const double place = (nm - 450) / 10;
  if (place < 0 || place >= kOzone.size() - 1) return 0;
  const auto i = static_cast<std::size_t>(place);
  return kOzone[i] + (kOzone[i + 1] - kOzone[i]) * (place - static_cast<double>(i));
}

// A Gaussian with different widths below and above its mean.
double bell(double nm, double middle, double below, double above) {
  const double t = (nm - middle) / (nm < middle ? below : above);
  return std::exp(-0.5 * t * t);
}

// CIE 1931 colour matching functions as sums of Gaussians (Wyman et al. 2013).
Rgb matching(double nm) {
  return {
      1.056 * bell(nm, 599.8, 37.9, 31.0) + 0.362 * bell(nm, 442.0, 16.0, 26.7) - 0.065 * bell(nm, 501.1, 20.4, 26.2),
      0.821 * bell(nm, 568.8, 46.9, 40.5) + 0.286 * bell(nm, 530.9, 16.3, 31.1),
      1.217 * bell(nm, 437.0, 11.8, 36.0) + 0.681 * bell(nm, 459.0, 26.0, 13.8)};
}

// Planck's law, relative.
double black_body(double nm) {
  constexpr double kSecondConstant_nm = 1.438777e7, kSun_K = 5778;
  return 1e15 / (nm * nm * nm * nm * nm * (std::exp(kSecondConstant_nm / (nm * kSun_K)) - 1));
}

// Preetham et al. 1999, appendix 1: Rayleigh scattering, Ångström's aerosol extinction, ozone.
double transmittance(double nm, double air_mass, double turbidity) {
  const double um = nm / 1000;
  const double rayleigh = 0.008735 * std::pow(um, -4.08);
  const double aerosols = std::max(0.0, 0.04608 * turbidity - 0.04586) * std::pow(um, -1.3);
  return std::exp(-air_mass * (rayleigh + aerosols + ozone(nm) * kOzoneLayer_cm));
}

}  // namespace

Rgb rgb_of_xyz(const Rgb& c) {
  return {3.2406 * c[0] - 1.5372 * c[1] - 0.4986 * c[2], -0.9689 * c[0] + 1.8758 * c[1] + 0.0415 * c[2],
          0.0557 * c[0] - 0.2040 * c[1] + 1.0570 * c[2]};
}

Rgb sun_luminance_kcd_m2(double cos_zenith, double turbidity) {
  if (cos_zenith <= -0.005) return {0, 0, 0};
  const double zenith_deg = std::acos(std::clamp(cos_zenith, 0.0, 1.0)) * 180 / std::numbers::pi;
  // relative optical air mass (Kasten 1965)
  const double air_mass = 1 / (std::max(cos_zenith, 0.0) + 0.15 * std::pow(93.885 - zenith_deg, -1.253));
  Rgb xyz{};
  double outside_y = 0;
  for (int nm = kFirst_nm; nm <= kLast_nm; nm += kStep_nm) {
    const Rgb cie = matching(nm);
    const double light = black_body(nm);
    outside_y += light * cie[1];
    for (int i = 0; i < 3; ++i) xyz[i] += light * cie[i] * transmittance(nm, air_mass, turbidity);
  }
  Rgb rgb = rgb_of_xyz(xyz);
  for (double& c : rgb) c = std::max(0.0, c * kSolar_klx / (kSolidAngle_sr * outside_y));
  return rgb;
}

}  // namespace citykiln::sky
