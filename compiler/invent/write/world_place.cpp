// Karney 2011: equations 15 to 21 and 36, here to the fourth order.
#include "compiler/invent/write/world_place.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"

namespace citykiln::invent {
namespace {

constexpr double kEquator_m = 6378137, kFlattening = 1 / 298.257223563;
constexpr double kN = kFlattening / (2 - kFlattening), kN2 = kN * kN, kN3 = kN2 * kN, kN4 = kN3 * kN;
constexpr double kRectifying_m = kEquator_m / (1 + kN) * (1 + kN2 / 4 + kN4 / 64);
constexpr std::array kAlpha = {kN / 2 - 2 * kN2 / 3 + 5 * kN3 / 16 + 41 * kN4 / 180,
                               13 * kN2 / 48 - 3 * kN3 / 5 + 557 * kN4 / 1440, 61 * kN3 / 240 - 103 * kN4 / 140,
                               49561 * kN4 / 161280};
constexpr std::array kBeta = {kN / 2 - 2 * kN2 / 3 + 37 * kN3 / 96 - kN4 / 360, kN2 / 48 + kN3 / 15 - 437 * kN4 / 1440,
                              17 * kN3 / 480 - 37 * kN4 / 840, 4397 * kN4 / 161280};
constexpr double kDegrees = 180 / kPi;

double hyperbolic_sine(double x) { return (exponential(x) - exponential(-x)) / 2; }
double hyperbolic_cosine(double x) { return (exponential(x) + exponential(-x)) / 2; }
double inverse_hyperbolic_tangent(double x) { return logarithm((1 + x) / (1 - x)) / 2; }

/// The tangent of the conformal latitude, from that of the latitude.
double conformal(double tau) {
  const double e = std::sqrt(kFlattening * (2 - kFlattening));
  const double sigma = hyperbolic_sine(e * inverse_hyperbolic_tangent(e * tau / std::sqrt(1 + tau * tau)));
  return tau * std::sqrt(1 + sigma * sigma) - sigma * std::sqrt(1 + tau * tau);
}

/// The inverse of conformal(), by Newton's method; three steps are enough for the last bit.
double geographic(double conformal_tau) {
  constexpr double kE2 = kFlattening * (2 - kFlattening);
  double tau = conformal_tau / (1 - kE2);
  for (int i = 0; i < 5; ++i) {
    const double here = conformal(tau);
    tau += (conformal_tau - here) / std::sqrt(1 + here * here) * (1 + (1 - kE2) * tau * tau) /
           ((1 - kE2) * std::sqrt(1 + tau * tau));
  }
  return tau;
}

/// The northing of a place on the central meridian, in rectifying radii.
double northing_of(double lat_deg) {
  const double xi = arctangent_deg(conformal(tangent(lat_deg))) / kDegrees;
  double sum = xi;
  for (std::size_t j = 0; j < kAlpha.size(); ++j) sum += kAlpha[j] * sine(2 * (j + 1.0) * xi * kDegrees);
  return sum;
}

double wrapped(double lon_deg) { return lon_deg > 180 ? lon_deg - 360 : lon_deg < -180 ? lon_deg + 360 : lon_deg; }

}  // namespace

WorldPlace::WorldPlace(LonLat middle) : middle_(middle), northing_(northing_of(middle.lat_deg)) {}

LonLat WorldPlace::degrees_of(Vec2 p) const {
  const double xi = northing_ + p.y / kRectifying_m, eta = p.x / kRectifying_m;
  double xi_sphere = xi, eta_sphere = eta;
  for (std::size_t j = 0; j < kBeta.size(); ++j) {
    const double k = 2 * (j + 1.0);
    xi_sphere -= kBeta[j] * sine(k * xi * kDegrees) * hyperbolic_cosine(k * eta);
    eta_sphere -= kBeta[j] * cosine(k * xi * kDegrees) * hyperbolic_sine(k * eta);
  }
  const double across = hyperbolic_sine(eta_sphere), along = cosine(xi_sphere * kDegrees);
  const double tau = geographic(sine(xi_sphere * kDegrees) / std::sqrt(across * across + along * along));
  return {wrapped(middle_.lon_deg + arctangent2_deg(across, along)), arctangent_deg(tau)};
}

MapPlace WorldPlace::map_place_of(Vec2 p) const {
  const LonLat place = degrees_of(p);
  return {static_cast<std::int32_t>(std::floor(place.lon_deg * 1e7 + 0.5)),
          static_cast<std::int32_t>(std::floor(place.lat_deg * 1e7 + 0.5))};
}

std::array<MapPlace, 2> WorldPlace::box_inside(double side_m) const {
  constexpr int kSteps = 16;
  const double half_m = side_m / 2;
  MapPlace low{INT32_MIN, INT32_MIN}, high{INT32_MAX, INT32_MAX};
  for (int i = 0; i <= kSteps; ++i) {
    const double v = -half_m + side_m * i / kSteps;
    low.lon = std::max(low.lon, map_place_of({-half_m, v}).lon);
    high.lon = std::min(high.lon, map_place_of({half_m, v}).lon);
    low.lat = std::max(low.lat, map_place_of({v, -half_m}).lat);
    high.lat = std::min(high.lat, map_place_of({v, half_m}).lat);
  }
  // one step inside, so that rounding does not lead out of the square
  return {MapPlace{low.lon + 1, low.lat + 1}, MapPlace{high.lon - 1, high.lat - 1}};
}

}  // namespace citykiln::invent
