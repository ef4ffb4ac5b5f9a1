#include "compiler/geometry/trig.h"

#include <cassert>

namespace citykiln {
namespace {

constexpr double kTau = 6.283185307179586476925286766559;

// Taylor polynomials about 0 for |x| <= π/4; the first omitted term is below 1e-18.
double small_sine(double x) {
  const double s = x * x;
  double sum = 1;
  for (int n = 17; n >= 3; n -= 2) sum = 1 - s * sum / (n * (n - 1));
  return x * sum;
}

double small_cosine(double x) {
  const double s = x * x;
  double sum = 1;
  for (int n = 18; n >= 2; n -= 2) sum = 1 - s * sum / (n * (n - 1));
  return sum;
}

}  // namespace

Vec2 direction_of(double turns) {
  assert(std::isfinite(turns));
  // the nearest quarter turn, and the remainder of at most an eighth of a turn
  const double fraction = turns - std::floor(turns);
  const double quarter = std::floor(fraction * 4 + 0.5);
  const double x = (fraction - quarter * 0.25) * kTau;
  const Vec2 d = {small_cosine(x), small_sine(x)};
  switch (static_cast<int>(quarter) % 4) {
    case 0:
      return d;
    case 1:
      return left_of(d);
    case 2:
      return {-d.x, -d.y};
    default:
      return {d.y, -d.x};
  }
}

}  // namespace citykiln
