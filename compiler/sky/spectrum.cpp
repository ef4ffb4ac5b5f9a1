#include "compiler/sky/spectrum.h"

#include <algorithm>
#include <cmath>

namespace citykiln::sky {
namespace {

// Illuminance of the sun outside of the atmosphere.
constexpr double kSolar_klx = 128, kSun_K = 5778;

// Absorption of ozone in the Chappuis band, 1/cm, every 10 nm from 450 (Iqbal 1983).
constexpr std::array kOzone = {.003, .006, .009, .014, .021, .030, .040, .048, .063, .075, .085, .103, .120, .120,
                               .115, .125, .120, .105, .090, .079, .067, .057, .048, .036, .028, .023, .018};
constexpr double kOzoneLayer_cm = 0.35;

// A Gaussian with different widths below and above its mean.
double bell(double nm, double middle, double below, double above) {
  const double t = (nm - middle) / (nm < middle ? below : above);
  return std::exp(-0.5 * t * t);
}

double solar_scale() {
  double seen = 0;
  for (int nm = kFirst_nm; nm <= kLast_nm; nm += kStep_nm) seen += black_body(nm, kSun_K) * matching(nm)[1] * kStep_nm;
  return kSolar_klx / seen;
}

}  // namespace

Rgb matching(double nm) {
  return {
      1.056 * bell(nm, 599.8, 37.9, 31.0) + 0.362 * bell(nm, 442.0, 16.0, 26.7) - 0.065 * bell(nm, 501.1, 20.4, 26.2),
      0.821 * bell(nm, 568.8, 46.9, 40.5) + 0.286 * bell(nm, 530.9, 16.3, 31.1),
      1.217 * bell(nm, 437.0, 11.8, 36.0) + 0.681 * bell(nm, 459.0, 26.0, 13.8)};
}

double black_body(double nm, double kelvin) {
  constexpr double kSecondConstant_nm_K = 1.438777e7;
  return 1e15 / (nm * nm * nm * nm * nm * (std::exp(kSecondConstant_nm_K / (nm * kelvin)) - 1));
}

double solar(double nm) {
  static const double kScale = solar_scale();
  return black_body(nm, kSun_K) * kScale;
}

Rgb rgb_of_xyz(const Rgb& c) {
  return {3.2406 * c[0] - 1.5372 * c[1] - 0.4986 * c[2], -0.9689 * c[0] + 1.8758 * c[1] + 0.0415 * c[2],
          0.0557 * c[0] - 0.2040 * c[1] + 1.0570 * c[2]};
}

double molecules_depth(double nm) { return 0.008735 * std::pow(nm / 1000, -4.08); }

double aerosols_depth(double nm, double turbidity) {
  return std::max(0.0, 0.04608 * turbidity - 0.04586) * std::pow(nm / 1000, -1.3);
}

double ozone_depth(double nm) {
  const double place = (nm - 450) / 10;
  if (place < 0 || place >= kOzone.size() - 1) return 0;
  const auto i = static_cast<std::size_t>(place);
  return (kOzone[i] + (kOzone[i + 1] - kOzone[i]) * (place - static_cast<double>(i))) * kOzoneLayer_cm;
}

}  // namespace citykiln::sky
