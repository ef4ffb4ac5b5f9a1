// Fits a plane, or a gently bent surface, to heights of which many may be outliers.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "compiler/geometry/vec.h"

namespace citykiln::ground {

/// The surface z = c0 + c1 x + c2 y + c3 x² + c4 x y + c5 y², with x and y in plane metres from
/// `centre`, z in metres, and c0 to c5 in `coefficients`.
struct FittedSurface {
  Vec2 centre;
  std::array<double, 6> coefficients{};

  double height_m(Vec2 p) const;
  /// The slope east and north, metres for each metre.
  Vec2 gradient(Vec2 p) const;
};

/// The form of a fitted surface: a plane, or one with all six coefficients.
enum class SurfaceForm : std::uint8_t { kPlane, kBent };

/// Returns a robust fit of a surface to points: weighted least squares in kFitRounds rounds, with
/// Cauchy's weights 1 / (1 + (d / s)²). d is a point's vertical distance from the surface, s the
/// median of these, at least 5 cm. Outliers hardly move the surface: up to a quarter of the points
/// may be wrong.
///
/// The result is no steeper than `most_slope` at any of the points: a steeper one has all slopes
/// multiplied by one factor, and is then moved up or down so that half of the points lie above it.
/// It is level at 0 if there are no points. O(points).
/// @param points  Plane metres, and heights in metres.
FittedSurface fitted_surface(std::span<const Vec3> points, SurfaceForm form, double most_slope);

/// The number of rounds of fitting, each with the weights of the one before.
inline constexpr int kFitRounds = 8;

}  // namespace citykiln::ground
