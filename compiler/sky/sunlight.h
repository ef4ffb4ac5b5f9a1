// Sunlight after its way through the atmosphere.
#pragma once

#include "compiler/sky/generate.h"

namespace citykiln::sky {

/// Angular radius of the sun's disk as seen from the Earth.
inline constexpr double kSunRadius_rad = 0.004652;

/// Converts CIE 1931 XYZ to linear sRGB (IEC 61966-2-1); negative outside of the gamut.
Rgb rgb_of_xyz(const Rgb& xyz);

/// Returns the luminance of the sun's disk as linear RGB, kcd/m², clamped to 0.
///
/// Method: the spectrum of a black body of 5778 K, scaled to the solar illuminance, is attenuated by Rayleigh
/// scattering, aerosols and ozone along the relative air mass, and integrated in steps of 5 nm.
/// @param cos_zenith  Cosine of the sun's zenith angle; 0 below -0.005.
/// Source: Preetham, Shirley, Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999, appendix 1; Iqbal, "An
/// Introduction to Solar Radiation", 1983, for ozone; Wyman, Sloan, Shirley, "Simple Analytic Approximations to the CIE
/// XYZ Color Matching Functions", JCGT 2(2), 2013. Uses libm, so for previews alone.
Rgb sun_luminance_kcd_m2(double cos_zenith, double turbidity);

}  // namespace citykiln::sky
