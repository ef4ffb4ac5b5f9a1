// Linear Rec. 709 colours of light.
#pragma once

#include <algorithm>
#include <array>

namespace citykiln::preview {

using Rgb = std::array<double, 3>;

inline Rgb operator*(const Rgb& a, const Rgb& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
inline Rgb operator*(const Rgb& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline Rgb operator+(const Rgb& a, const Rgb& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Rgb operator-(const Rgb& a, const Rgb& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Rgb mixed(const Rgb& a, const Rgb& b, double share) { return a * (1 - share) + b * share; }
inline double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }
inline double largest(const Rgb& c) { return std::max({c[0], c[1], c[2]}); }

}  // namespace citykiln::preview
