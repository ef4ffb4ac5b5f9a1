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

double distance_m2(source::Location a, source::Location b) {
  const double x = (static_cast<double>(a.lon_e7) - b.lon_e7) * east_m_at(a.lat_e7),
               y = (static_cast<double>(a.lat_e7) - b.lat_e7) * kNorth_m;
  return x * x + y * y;
}

}  // namespace citykiln::edits
