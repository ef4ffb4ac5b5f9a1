// Light of a straight line that shines as a thin matt tube does: the intensity of a piece is in proportion to its
// length and to the sine of the angle with the line.
//
//            from ========== line ======== to        theta is the angle at the place, from the nearest point of the
//                    \     |    /                     endless line; a piece that is seen under d theta gives the
//                     \    |h  /                      place  cos(theta) d theta / h  of light from its direction.
//                      \   |  /
//                        place
//
// Irradiance by a segment is then an integral of cos(theta) (a cos(theta) + b sin(theta)) / h, in closed form, with a
// and b the parts of the normal across and along the line. Compare Nishita, Okamura, Nakamae, "Shading models for point
// and linear light sources", ACM TOG 4(2), 1985, who integrate from ends above the horizon only.
#pragma once

#include <optional>

#include "compiler/geometry/vec.h"

namespace citykiln::sky {

/// A line as a place sees it.
struct SeenLine {
  Vec3 across;                     ///< Unit vector from the place to the nearest point of the endless line.
  Vec3 along;                      ///< Unit vector along the line.
  double distance_m = 0;           ///< To that nearest point. > 0.
  double low_sine = 0, high_sine;  ///< Sines of theta at the ends of the part that is seen, low first.

  double extent() const { return high_sine - low_sine; }
};

/// Returns the line as a place sees it; empty for a place on the line. Lines of no length have no extent.
std::optional<SeenLine> seen_line(Vec3 from, Vec3 to, Vec3 place);
/// Returns the line's part above the horizon of a surface; empty if it has none.
///
/// @param normal  Unit normal of the surface.
std::optional<SeenLine> seen_line(Vec3 from, Vec3 to, Vec3 place, Vec3 normal);

/// Returns the direction from the place to a point of the line, by the sine of theta.
Vec3 direction_to(const SeenLine& line, double sine);

/// Returns the illuminance of a surface by an unblocked line of one candela per metre across the line.
/// @param line  From seen_line() with the same normal.
/// Error: below 1e-12 of the largest value. Same bits on every CPU. About 0.2 µs.
double irradiance(const SeenLine& line, Vec3 normal);
/// Returns the illuminance from all directions together (fluence) by an unblocked line of one candela per metre.
inline double fluence(const SeenLine& line) { return line.extent() / line.distance_m; }

/// Returns the intensity of a metre, across the line, of a line with this luminous flux.
inline double candela_per_m(double lumen_per_m) {
  constexpr double kPiSquared = 9.8696044010893586188;
  return lumen_per_m / kPiSquared;
}

}  // namespace citykiln::sky
