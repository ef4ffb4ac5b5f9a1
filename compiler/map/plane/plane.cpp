#include "compiler/map/plane/plane.h"

#include <GeographicLib/TransverseMercator.hpp>
#include <algorithm>
#include <cmath>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/precise_plane.h"

namespace citykiln::map {
namespace {

// Share of a step. Larger than the whole error of the double computation, so that beyond it every CPU rounds to the
// same side. The error is at most 4.2e-9 m or 5.4e-7 step, measured up to 78° N against long double; results with and
// without FMA differ by up to 1.9e-9 m.
constexpr double kNearStepTie = 1e-5;

bool is_near_tie(double v) {
  const double steps = v / kMapStep_m + 0.5;
  return std::abs(steps - std::round(steps)) < kNearStepTie;
}

// The longitude up to which the series still gives finite results: nodes at 0, 0 by mistake must not become infinite.
constexpr double kMostAway_deg = 80;

LonLat within_reach(LonLat origin, LonLat place) {
  double away_deg = place.lon_deg - origin.lon_deg;
  if (std::abs(away_deg) <= kMostAway_deg) return place;
  if (away_deg > 180) away_deg -= 360;
  if (away_deg < -180) away_deg += 360;
  return {origin.lon_deg + std::clamp(away_deg, -kMostAway_deg, kMostAway_deg), place.lat_deg};
}

double precisely_snapped(long double v) { return static_cast<double>(floorl(v / kMapStep_m + 0.5L)) * kMapStep_m; }

}  // namespace

struct Plane::Projection {
  LonLat origin;
  GeographicLib::TransverseMercator mercator =
      GeographicLib::TransverseMercator(GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), 1);
  double northing_m = 0;  // of the origin

  explicit Projection(LonLat o) : origin(o) {
    // computed in long double and rounded, so that it is the same on every CPU: minus the distance from the origin to
    // the equator
    northing_m = -static_cast<double>(precise_forward(o, {o.lon_deg, 0}).y);
  }
};

Plane::Plane(LonLat origin) : projection_(std::make_unique<Projection>(origin)) {}
Plane::~Plane() = default;
Plane::Plane(Plane&&) noexcept = default;
Plane& Plane::operator=(Plane&&) noexcept = default;

LonLat Plane::origin() const { return projection_->origin; }

Vec2 Plane::forward(LonLat place) const {
  place = within_reach(projection_->origin, place);
  Vec2 p;
  projection_->mercator.Forward(projection_->origin.lon_deg, place.lat_deg, place.lon_deg, p.x, p.y);
  return {p.x, p.y - projection_->northing_m};
}

LonLat Plane::backward(Vec2 p) const {
  LonLat place;
  projection_->mercator.Reverse(projection_->origin.lon_deg, p.x, p.y + projection_->northing_m, place.lat_deg,
                                place.lon_deg);
  return place;
}

Vec2 Plane::snapped_forward(source::Location place) const {
  const Vec2 p = forward({place.lon_deg(), place.lat_deg()});
  if (!is_near_tie(p.x) && !is_near_tie(p.y)) return snapped_to(kMapStep_m, p);
  // from the same doubles as the fast computation
  const LonLat degrees = within_reach(projection_->origin, {place.lon_deg(), place.lat_deg()});
  const PrecisePoint precise = precise_forward(projection_->origin, {degrees.lon_deg, degrees.lat_deg});
  return {is_near_tie(p.x) ? precisely_snapped(precise.x) : snapped_to(kMapStep_m, p.x),
          is_near_tie(p.y) ? precisely_snapped(precise.y) : snapped_to(kMapStep_m, p.y)};
}

}  // namespace citykiln::map
