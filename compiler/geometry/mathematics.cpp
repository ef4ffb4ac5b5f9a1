#include "compiler/geometry/mathematics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "compiler/geometry/trig.h"

namespace citykiln {
namespace {

constexpr double kDegreesInARadian = 57.295779513082320876798154814105;
constexpr double kLn2 = 0.69314718055994530941723212145818;
constexpr double kLargest = std::numeric_limits<double>::max();

// x in 0 … tan(π/8); the first omitted term is below 1e-16
double small_arctangent(double x) {
  const double s = x * x;
  double sum = 0;
  for (int n = 39; n >= 1; n -= 2) sum = 1.0 / n - s * sum;
  return x * sum;
}

// x in 0 … 1; halves the angle until the series converges quickly
double arctangent_rad(double x) {
  constexpr double kEighth = 0.39269908169872415480783042290994;
  constexpr double kTangentOfEighth = 0.41421356237309504880168872420970;
  if (x <= kTangentOfEighth) return small_arctangent(x);
  return kEighth + small_arctangent((x - kTangentOfEighth) / (1 + x * kTangentOfEighth));
}

double whole_power(double base, std::int64_t exponent) {
  double result = 1;
  for (std::uint64_t left = exponent < 0 ? -exponent : exponent; left > 0; left >>= 1) {
    if (left & 1) result *= base;
    base *= base;
  }
  return exponent < 0 ? 1 / result : result;
}

double within_doubles(double x) { return std::isnan(x) ? 0 : std::clamp(x, -kLargest, kLargest); }

}  // namespace

double sine(double angle_deg) { return direction_of(angle_deg / 360).y; }
double cosine(double angle_deg) { return direction_of(angle_deg / 360).x; }
double tangent(double angle_deg) {
  const Vec2 d = direction_of(angle_deg / 360);
  return within_doubles(d.y / d.x);
}

double arctangent2_deg(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y);
  if (ax == 0 && ay == 0) return 0;
  const double steep = ay > ax;
  const double first = arctangent_rad(steep ? ax / ay : ay / ax) * kDegreesInARadian;
  const double in_quadrant = steep ? 90 - first : first;
  const double upper = x < 0 ? 180 - in_quadrant : in_quadrant;
  return y < 0 ? -upper : upper;
}

double arctangent_deg(double x) { return arctangent2_deg(x, 1); }
double arcsine_deg(double x) {
  const double sine = std::clamp(x, -1.0, 1.0);
  return arctangent2_deg(sine, std::sqrt((1 - sine) * (1 + sine)));
}
double arccosine_deg(double x) {
  const double cosine = std::clamp(x, -1.0, 1.0);
  return arctangent2_deg(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
}

double exponential(double x) {
  if (!(x > -745)) return 0;
  if (x > 709.7) return kLargest;
  // e^x = 2^k e^r with |r| ≤ ln 2 / 2, where few terms suffice
  const double k = std::floor(x / kLn2 + 0.5);
  const double r = x - k * kLn2;
  double sum = 1;
  for (int n = 20; n >= 1; --n) sum = 1 + r * sum / n;
  return within_doubles(std::ldexp(sum, static_cast<int>(k)));
}

double logarithm(double x) {
  // x = 2^k m with m about 1, and ln m = 2 artanh((m - 1) / (m + 1))
  int k = 0;
  double m = std::frexp(std::clamp(x, std::numeric_limits<double>::min(), kLargest), &k);
  if (m < 0.70710678118654752440) m *= 2, --k;
  const double t = (m - 1) / (m + 1), s = t * t;
  double sum = 0;
  for (int n = 27; n >= 1; n -= 2) sum = 1.0 / n + s * sum;
  return k * kLn2 + 2 * t * sum;
}

double power(double base, double exponent) {
  if (std::abs(exponent) <= 1024 && exponent == std::floor(exponent))
    return within_doubles(whole_power(base, static_cast<std::int64_t>(exponent)));
  if (!(base > 0)) return 0;
  return exponential(exponent * logarithm(base));
}

}  // namespace citykiln
