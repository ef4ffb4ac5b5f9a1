#include "compiler/edits/offsets.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"

namespace citykiln::edits {
namespace {

// metres in 1e-7 degrees: of the meridian at 45 degrees, and of the equator
constexpr double kNorth_m = 0.0111132, kEast_m = 0.0111320;
// the cosine of 89.9 degrees, so that a move beside a pole stays finite
constexpr double kLeastCosine = 0.0017;

double east_m_at(std::int32_t lat_e7) { return kEast_m * std::max(kLeastCosine, cosine(lat_e7 * 1e-7)); }

std::int32_t rounded(double v) { return static_cast<std::int32_t>(std::floor(v + 0.5)); }

}  // namespace

source::Location moved(source::Location at, Vec2 by_m) {
  constexpr std::int32_t kPole_e7 = 900000000;
  return {at.lon_e7 + rounded(by_m.x / east_m_at(at.lat_e7)),
          std::clamp(at.lat_e7 + rounded(by_m.y / kNorth_m), -kPole_e7, kPole_e7)};
}

Circle circle_about(source::Location centre, double radius_m) { return {centre, radius_m, east_m_at(centre.lat_e7)}; }

bool is_in(const Circle& circle, source::Location at) {
  const double y_m = (static_cast<double>(at.lat_e7) - circle.centre.lat_e7) * kNorth_m;
  if (std::abs(y_m) > circle.radius_m) return false;
  const double x_m = (static_cast<double>(at.lon_e7) - circle.centre.lon_e7) * circle.east_m;
  return x_m * x_m + y_m * y_m <= circle.radius_m * circle.radius_m;
}

}  // namespace citykiln::edits
