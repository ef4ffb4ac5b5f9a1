// What is left of the sun's light when it comes through the air.
#pragma once

#include "compiler/sky/generate.h"

namespace citykiln::sky {

/// Half the width of the sun's disk as seen from the Earth.
inline constexpr double kSunRadius_rad = 0.004652;

/// From CIE 1931 to linear sRGB (IEC 61966-2-1), negative where out of gamut.
Rgb rgb_of_xyz(const Rgb& xyz);

/// Luminance of the disk as linear RGB, kcd/m², not negative.
///
/// Method: a black body of 5778 K with the sun's illuminance, dimmed at every 5 nm by Rayleigh scattering, haze and
/// ozone along the air mass.
/// @param cos_zenith  Of the sun's angle from the zenith; at or below the horizon's -0.005 the disk has set: black.
/// Source: Preetham, Shirley, Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999, appendix 1; Iqbal 1983
/// for ozone; Wyman, Sloan, Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT
/// 2(2), 2013. libm: for previews alone.
Rgb sun_luminance_kcd_m2(double cos_zenith, double turbidity);

}  // namespace citykiln::sky
