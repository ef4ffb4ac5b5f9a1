#include "grammars/shapes/scope.h"

#include <algorithm>
#include <cmath>

namespace citykiln::grammars {

std::array<Vec3, 8> Scope::corners() const {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[i] = to_space(i & 1 ? size_m[0] : 0, i & 2 ? size_m[1] : 0, i & 4 ? size_m[2] : 0);
  return corners;
}

double Scope::diagonal_m() const { return length(Vec3{size_m[0], size_m[1], size_m[2]}); }

Scope scope_around(std::span<const Face> faces, const std::array<Vec3, 3>& axis, Vec3 origin_if_empty) {
  std::array<double, 3> low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Face& face : faces) {
    for (const Vec3 p : face.outer) {
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], dot(axis[i], p));
        high[i] = std::max(high[i], dot(axis[i], p));
      }
    }
  }
  Scope scope{origin_if_empty, axis, {}};
  if (!(low[0] <= high[0])) return scope;
  scope.origin = axis[0] * low[0] + axis[1] * low[1] + axis[2] * low[2];
  for (int i = 0; i < 3; ++i) scope.size_m[i] = high[i] - low[i];
  // the thickness of a planar face is rounding error
  for (double& size_m : scope.size_m) size_m = size_m < kOnPlane_m ? 0 : size_m;
  return scope;
}

std::array<Vec3, 3> axes_of(const Face& face) { return axes_of(face, normal_of(face)); }

std::array<Vec3, 3> axes_of(const Face& face, Vec3 normal) {
  // the sine of half a degree
  constexpr double kLevel = 0.0087;
  const Vec3 foot = cross(Vec3{0, 0, 1}, normal);
  if (length(foot) < kLevel) {
    const FaceFrame frame = frame_of(face);
    return {frame.x, frame.y, frame.z};
  }
  const Vec3 x = unit(foot);
  return {x, cross(normal, x), normal};
}

NearestAxis nearest_axis(const Scope& scope, Vec3 direction) {
  NearestAxis best;
  double best_cosine = -1;
  // of equal axes z is preferred, then x
  for (const int i : {2, 0, 1}) {
    const double cosine = dot(scope.axis[i], direction);
    if (std::abs(cosine) <= best_cosine + 1e-9) continue;
    best_cosine = std::abs(cosine);
    best = {i, cosine < 0};
  }
  return best;
}

}  // namespace citykiln::grammars
