// Fits a plane, or a gently bent surface, to heights of which many may be wrong.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "compiler/geometry/vec.h"

namespace citykiln::ground {

/// The surface z = sum of coefficients times 1, x, y, x², x y, y², with x and y in metres from `centre`.
struct FittedSurface {
  Vec2 centre;
  std::array<double, 6> coefficients{};

  double height_m(Vec2 p) const;
  Vec2 gradient(Vec2 p) const;
};

/// The form of a fitted surface.
enum class SurfaceForm : std::uint8_t { kPlane, kBent };

/// Returns the surface with the least sum of Cauchy's distances from the points, in kFitRounds rounds of weighted least
/// squares, whose scale is the median distance. Points off the surface by many times the median do not move it: a
/// quarter of the points may be wrong.
///
/// If its slope at any point exceeds `most_slope`, all its slopes are reduced by one factor, and it has the median
/// height of the points above it. Without points it is level at 0. O(points).
FittedSurface fitted_surface(std::span<const Vec3> points, SurfaceForm form, double most_slope);

/// Rounds of reweighting.
inline constexpr int kFitRounds = 8;

}  // namespace citykiln::ground
