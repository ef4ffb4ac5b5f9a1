// Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 85, 2011: the series to sixth order, by GeographicLib in double, and
// here once more in x87 long double for the few points that lie so near to a tie of snapping that the last bit of a CPU's sine would decide.
#include "compiler/map/plane.h"

#include <GeographicLib/TransverseMercator.hpp>
#include <cmath>

#include "compiler/contract/tolerance.h"
#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

using Real = long double;

constexpr Real kDegree = 3.14159265358979323846264338327950288L / 180;
constexpr Real kA_m = 6378137, kFlattening = 1 / 298.257223563L;

// The Krüger coefficients alpha_1 … alpha_6 for WGS84, and the rectifying radius (Karney 2011, equations 14 and 35).
struct Series {
  Real alpha[6];
  Real radius_m;
};

Series wgs84_series() {
  const Real n = kFlattening / (2 - kFlattening), n2 = n * n, n3 = n2 * n, n4 = n3 * n, n5 = n4 * n, n6 = n5 * n;
  return {{n / 2 - 2 * n2 / 3 + 5 * n3 / 16 + 41 * n4 / 180 - 127 * n5 / 288 + 7891 * n6 / 37800,
           13 * n2 / 48 - 3 * n3 / 5 + 557 * n4 / 1440 + 281 * n5 / 630 - 1983433 * n6 / 1935360,
           61 * n3 / 240 - 103 * n4 / 140 + 15061 * n5 / 26880 + 167603 * n6 / 181440,
           49561 * n4 / 161280 - 179 * n5 / 168 + 6601661 * n6 / 7257600, 34729 * n5 / 80640 - 3418889 * n6 / 1995840,
           212378941 * n6 / 319334400},
          kA_m / (1 + n) * (1 + n2 / 4 + n4 / 64 + n6 / 256)};
}

struct Precise {
  Real x, y;
};

// Easting and northing from the central meridian and the equator, metres.
Precise krueger(Real lat_deg, Real lon_deg, Real lon0_deg) {
  static const Series series = wgs84_series();
  const Real e = sqrtl(kFlattening * (2 - kFlattening)), phi = lat_deg * kDegree, lambda = (lon_deg - lon0_deg) * kDegree;
  const Real t = sinhl(atanhl(sinl(phi)) - e * atanhl(e * sinl(phi)));
  const Real xi = atan2l(t, cosl(lambda)), eta = atanhl(sinl(lambda) / sqrtl(1 + t * t));
  Precise p{eta, xi};
  for (int k = 1; k <= 6; ++k) {
    p.x += series.alpha[k - 1] * cosl(2 * k * xi) * sinhl(2 * k * eta);
    p.y += series.alpha[k - 1] * sinl(2 * k * xi) * coshl(2 * k * eta);
  }
  return {p.x * series.radius_m, p.y * series.radius_m};
}

// Libraries' sines differ by 1e-16 of 1e7 m between CPUs: 1e-9 m, 1e-6 quantum.
constexpr double kNearTie = 1e-6;

bool is_near_tie(double v) {
  const double steps = v / kQuantum_m + 0.5;
  return std::abs(steps - std::round(steps)) < kNearTie;
}

double precisely_snapped(Real v) { return static_cast<double>(floorl(v / kQuantum_m + 0.5L)) * kQuantum_m; }

}  // namespace

struct Plane::Projection {
  LonLat origin;
  GeographicLib::TransverseMercator mercator = GeographicLib::TransverseMercator(GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), 1);
  double northing_m = 0;        // of the origin
  Real precise_northing_m = 0;

  explicit Projection(LonLat o) : origin(o), precise_northing_m(krueger(o.lat_deg, o.lon_deg, o.lon_deg).y) {
    // the long double value, rounded: the same on every CPU
    northing_m = static_cast<double>(precise_northing_m);
  }
};

Plane::Plane(LonLat origin) : projection_(std::make_unique<Projection>(origin)) {}
Plane::~Plane() = default;
Plane::Plane(Plane&&) noexcept = default;
Plane& Plane::operator=(Plane&&) noexcept = default;

LonLat Plane::origin() const { return projection_->origin; }

Vec2 Plane::forward(LonLat place) const {
  Vec2 p;
  projection_->mercator.Forward(projection_->origin.lon_deg, place.lat_deg, place.lon_deg, p.x, p.y);
  return {p.x, p.y - projection_->northing_m};
}

LonLat Plane::backward(Vec2 p) const {
  LonLat place;
  projection_->mercator.Reverse(projection_->origin.lon_deg, p.x, p.y + projection_->northing_m, place.lat_deg, place.lon_deg);
  return place;
}

Vec2 Plane::snapped_forward(source::Location place) const {
  const Vec2 p = forward({place.lon_deg(), place.lat_deg()});
  if (!is_near_tie(p.x) && !is_near_tie(p.y)) return snapped(p);
  // degrees as the same doubles that the fast way sees
  const Precise precise = krueger(place.lat_deg(), place.lon_deg(), projection_->origin.lon_deg);
  return {is_near_tie(p.x) ? precisely_snapped(precise.x) : snapped(p.x),
          is_near_tie(p.y) ? precisely_snapped(precise.y - projection_->precise_northing_m) : snapped(p.y)};
}

}  // namespace citykiln::map
