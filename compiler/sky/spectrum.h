// Light by wavelength: the sun's spectrum, optical depths of air, and the eye's colour matching. Uses libm, so last
// digits differ between systems: it is for previews, charts, and page.json, which rounds to four digits.
#pragma once

#include <array>

namespace citykiln::sky {

using Rgb = std::array<double, 3>;

/// Angular radius of the sun's disk as seen from the Earth. The moon's radius differs by at most a tenth.
inline constexpr double kSunRadius_rad = 0.004652;

/// The visible spectrum, nm, and the step of numerical integrals over it.
inline constexpr int kFirst_nm = 380, kLast_nm = 780, kStep_nm = 5;

/// Returns the CIE 1931 colour matching functions at a wavelength (x̄, ȳ, z̄), as sums of Gaussians. Source: Wyman,
/// Sloan, Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2), 2013.
Rgb matching(double nm);

/// Returns the spectral radiance of a black body in relative units (Planck's law).
double black_body(double nm, double kelvin);

/// Returns the sun's spectrum outside of the atmosphere, a black body of 5778 K: illuminance in klx per nm at a
/// luminous efficacy of 1. Its sum with matching()[1] over kStep_nm is 128 klx.
double solar(double nm);

/// Converts CIE 1931 XYZ to linear sRGB (IEC 61966-2-1); negative outside of the gamut.
Rgb rgb_of_xyz(const Rgb& xyz);

/// Returns the optical depth of molecules, seen vertically from sea level. The next functions return the optical depths
/// of aerosols and of ozone.
///
/// Source: Preetham, Shirley, Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999, appendix 1, for
/// molecules and aerosols (Ångström's law); Iqbal, "An Introduction to Solar Radiation", 1983, for a layer of 0.35 cm
/// of ozone.
double molecules_depth(double nm);
double aerosols_depth(double nm, double turbidity);
double ozone_depth(double nm);

}  // namespace citykiln::sky
