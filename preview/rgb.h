// Colours of light in linear Rec. 709: radiance or reflectance in red, green and blue. Products are by component.
#pragma once

#include <algorithm>
#include <array>

namespace citykiln::preview {

using Rgb = std::array<double, 3>;

inline Rgb operator*(const Rgb& a, const Rgb& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
inline Rgb operator*(const Rgb& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline Rgb operator+(const Rgb& a, const Rgb& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Rgb operator-(const Rgb& a, const Rgb& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
/// Returns `a` with weight 1 - share plus `b` with weight share.
inline Rgb mixed(const Rgb& a, const Rgb& b, double share) { return a * (1 - share) + b * share; }
/// Returns the luminance (Rec. 709) of a colour.
inline double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }
/// Returns the largest of the three components.
inline double largest_component(const Rgb& c) { return std::max({c[0], c[1], c[2]}); }

}  // namespace citykiln::preview
