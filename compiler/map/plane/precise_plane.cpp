// Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 85, 2011: equations 7 to 14 and 35.
#include "compiler/map/plane/precise_plane.h"

#include <cassert>
#include <cmath>

namespace citykiln::map {
namespace {

using Real = long double;

constexpr Real kDegree = 3.14159265358979323846264338327950288L / 180;
constexpr Real kPreciseA_m = 6378137, kPreciseFlattening = 1 / 298.257223563L;

// The Krüger coefficients alpha_1 … alpha_6 for WGS84, and the rectifying radius (Karney 2011, equations 14 and 35).
struct Series {
  Real alpha[6];
  Real radius_m;
};

Series wgs84_series() {
  const Real n = kPreciseFlattening / (2 - kPreciseFlattening), n2 = n * n, n3 = n2 * n, n4 = n3 * n, n5 = n4 * n,
             n6 = n5 * n;
  return {{n / 2 - 2 * n2 / 3 + 5 * n3 / 16 + 41 * n4 / 180 - 127 * n5 / 288 + 7891 * n6 / 37800,
           13 * n2 / 48 - 3 * n3 / 5 + 557 * n4 / 1440 + 281 * n5 / 630 - 1983433 * n6 / 1935360,
           61 * n3 / 240 - 103 * n4 / 140 + 15061 * n5 / 26880 + 167603 * n6 / 181440,
           49561 * n4 / 161280 - 179 * n5 / 168 + 6601661 * n6 / 7257600, 34729 * n5 / 80640 - 3418889 * n6 / 1995840,
           212378941 * n6 / 319334400},
          kPreciseA_m / (1 + n) * (1 + n2 / 4 + n4 / 64 + n6 / 256)};
}

// Easting and northing from the central meridian and the equator, metres.
PrecisePoint krueger(Real lat_deg, Real lon_deg, Real lon0_deg) {
  static const Series series = wgs84_series();
  const Real e = sqrtl(kPreciseFlattening * (2 - kPreciseFlattening)), phi = lat_deg * kDegree,
             lambda = (lon_deg - lon0_deg) * kDegree;
  const Real t = sinhl(atanhl(sinl(phi)) - e * atanhl(e * sinl(phi)));
  const Real xi = atan2l(t, cosl(lambda)), eta = atanhl(sinl(lambda) / sqrtl(1 + t * t));
  PrecisePoint p{eta, xi};
  for (int k = 1; k <= 6; ++k) {
    p.x += series.alpha[k - 1] * cosl(2 * k * xi) * sinhl(2 * k * eta);
    p.y += series.alpha[k - 1] * sinl(2 * k * xi) * coshl(2 * k * eta);
  }
  return {p.x * series.radius_m, p.y * series.radius_m};
}

}  // namespace

PrecisePoint precise_forward(LonLat origin, PreciseLonLat place) {
  const PrecisePoint p = krueger(place.lat_deg, place.lon_deg, origin.lon_deg),
                     zero = krueger(origin.lat_deg, origin.lon_deg, origin.lon_deg);
  return {p.x - zero.x, p.y - zero.y};
}

PreciseLonLat precise_backward(LonLat origin, Vec2 p, LonLat near) {
  assert(std::abs(near.lat_deg) <= 90);
  PreciseLonLat place{near.lon_deg, near.lat_deg};
  // each step reduces the error to a hundredth or less: the spherical metres per degree are within half a percent, and
  // the convergence of the meridians is small
  for (int i = 0; i < 12; ++i) {
    const PrecisePoint here = precise_forward(origin, place);
    place.lat_deg += (p.y - here.y) / (kPreciseA_m * kDegree);
    place.lon_deg += (p.x - here.x) / (kPreciseA_m * kDegree * cosl(place.lat_deg * kDegree));
  }
  return place;
}

}  // namespace citykiln::map
