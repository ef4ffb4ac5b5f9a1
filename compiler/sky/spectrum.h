// Light by wavelength: the sun, what air does to it, and what the eye sees. Uses libm, so for previews alone.
#pragma once

#include <array>

namespace citykiln::sky {

using Rgb = std::array<double, 3>;

/// Angular radius of the sun's disk as seen from the Earth; the moon's is within a tenth of it.
inline constexpr double kSunRadius_rad = 0.004652;

/// The visible spectrum, nm, and the step of numerical integrals over it.
inline constexpr int kFirst_nm = 380, kLast_nm = 780, kStep_nm = 5;

/// CIE 1931 colour matching functions as sums of Gaussians. Source: Wyman, Sloan, Shirley, "Simple Analytic
/// Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2), 2013.
Rgb matching(double nm);

/// Planck's law, relative.
double black_body(double nm, double kelvin);

/// The sun's spectrum outside of the atmosphere, klx per nm of illuminance at luminous efficacy 1: its sum with
/// matching()[1] over kStep_nm is 128 klx. A black body of 5778 K.
double solar(double nm);

/// Converts CIE 1931 XYZ to linear sRGB (IEC 61966-2-1); negative outside of the gamut.
Rgb rgb_of_xyz(const Rgb& xyz);

/// Optical depth of the whole air at sea level, seen vertically, by what makes it.
///
/// Source: Preetham, Shirley, Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999, appendix 1, for
/// molecules and aerosols (Ångström's law); Iqbal, "An Introduction to Solar Radiation", 1983, for ozone, 0.35 cm of
/// it.
double molecules_depth(double nm);
double aerosols_depth(double nm, double turbidity);
double ozone_depth(double nm);

}  // namespace citykiln::sky
