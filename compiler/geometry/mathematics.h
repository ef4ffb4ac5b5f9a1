// Elementary functions without libm, whose last bits differ between CPUs.
#pragma once

namespace citykiln {

/// The functions of this file use + - * / and the square root only, so that every CPU gives the same bits. Angles are
/// in degrees, as in CGA and L-systems. Outside of a function's domain (logarithm(-1), arcsine_deg(2)) the nearest
/// argument inside is used; overflow gives the largest double. Cost: about 50 operations.
///
/// Errors, as tested against libm: sine and cosine 1e-14 up to two turns, arctangent2 1e-13 degrees, arcsine and
/// arccosine 1e-12 degrees, logarithm 1e-14 for 0.01 to 100; exponential and power 1e-13, relative. The tangent has no
/// absolute bound near 90 degrees.

double sine(double angle_deg);
double cosine(double angle_deg);
double tangent(double angle_deg);
double arcsine_deg(double x);
double arccosine_deg(double x);
double arctangent_deg(double x);
/// Returns the direction of (x, y) in degrees, from -180 to 180; 0 for (0, 0).
double arctangent2_deg(double y, double x);
double exponential(double x);
/// Returns the natural logarithm; for x <= 0 that of the smallest normal double.
double logarithm(double x);
/// Returns base^exponent, by repeated squaring for integer exponents, else by logarithm. A negative base with an
/// exponent that is not an integer gives 0.
double power(double base, double exponent);

}  // namespace citykiln
