// Powers, logarithms and angles without libm, whose last bits differ between CPUs.
#pragma once

namespace citykiln {

/// Each is made of + - * / and the square root, so that every CPU gives the same bits; within 1e-14 of the true value,
/// relative for power and exponential, absolute for the others. Angles are degrees, as in CGA and L-systems.
/// Bad input: where there is no value (the logarithm of -1, arcsine of 2) the nearest argument that has one is taken;
/// overflow is the largest double. Cost: some 50 operations.

double sine(double angle_deg);
double cosine(double angle_deg);
double tangent(double angle_deg);
double arcsine_deg(double x);
double arccosine_deg(double x);
double arctangent_deg(double x);
/// The direction of (x, y), -180 … 180; 0 for (0, 0).
double arctangent2_deg(double y, double x);
double exponential(double x);
/// The natural logarithm; of what is not above zero, that of the smallest normal double.
double logarithm(double x);
/// Whole exponents by repeated squaring; else by logarithm, and 0 for a base below zero.
double power(double base, double exponent);

}  // namespace citykiln
