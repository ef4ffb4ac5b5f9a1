// Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 85, 2011: equations 11, 15, 25 and 36.
// The series from conformal to geodetic latitude is that of Krüger 1912, to sixth order.
#include "compiler/map/plane/globe.h"

#include <cassert>
#include <cmath>

#include "compiler/geometry/trig.h"
#include "compiler/map/plane/precise_plane.h"

namespace citykiln::map {
namespace {

constexpr double kTau = 6.283185307179586476925286766559;
constexpr double kA_m = 6378137, kFlattening = 1 / 298.257223563, kE2 = kFlattening * (2 - kFlattening);
constexpr double n1 = kFlattening / (2 - kFlattening), n2 = n1 * n1, n3 = n2 * n1, n4 = n3 * n1, n5 = n4 * n1,
                 n6 = n5 * n1;
constexpr double kRectifyingRadius_m = kA_m / (1 + n1) * (1 + n2 / 4 + n4 / 64 + n6 / 256);

using Coefficients = std::array<double, 6>;

// From the plane to the conformal sphere.
constexpr Coefficients kBeta = {n1 / 2 - 2 * n2 / 3 + 37 * n3 / 96 - n4 / 360 - 81 * n5 / 512 + 96199 * n6 / 604800,
                                n2 / 48 + n3 / 15 - 437 * n4 / 1440 + 46 * n5 / 105 - 1118711 * n6 / 3870720,
                                17 * n3 / 480 - 37 * n4 / 840 - 209 * n5 / 4480 + 5569 * n6 / 90720,
                                4397 * n4 / 161280 - 11 * n5 / 504 - 830251 * n6 / 7257600,
                                4583 * n5 / 161280 - 108847 * n6 / 3991680,
                                20648693 * n6 / 638668800};

// From conformal to geodetic latitude.
constexpr Coefficients kDelta = {2 * n1 - 2 * n2 / 3 - 2 * n3 + 116 * n4 / 45 + 26 * n5 / 45 - 2854 * n6 / 675,
                                 7 * n2 / 3 - 8 * n3 / 5 - 227 * n4 / 45 + 2704 * n5 / 315 + 2323 * n6 / 945,
                                 56 * n3 / 15 - 136 * n4 / 35 - 1262 * n5 / 105 + 73814 * n6 / 2835,
                                 4279 * n4 / 630 - 332 * n5 / 35 - 399572 * n6 / 14175,
                                 4174 * n5 / 315 - 144838 * n6 / 6237,
                                 601676 * n6 / 22275};

// Taylor polynomials for |x| <= 0.5; the first omitted term is below 1e-17 of the sum.
double small_hyperbolic_sine(double x) {
  double sum = 1;
  for (int n = 15; n >= 3; n -= 2) sum = 1 + x * x * sum / (n * (n - 1));
  return x * sum;
}
double small_sine(double x) { return x * (1 - x * x / 6 * (1 - x * x / 20 * (1 - x * x / 42))); }

/// The direction of an angle: {cosine, sine}.
Vec2 direction_of_rad(double angle_rad) { return direction_of(angle_rad / kTau); }

// Clenshaw's sum of c_j sin(2 j z), for real and complex z.
template <typename T>
T sine_sum(const Coefficients& c, T sine_2z, T cosine_2z) {
  T b1 = 0, b2 = 0;
  for (std::size_t j = c.size(); j-- > 0;) {
    const T b = c[j] + (cosine_2z + cosine_2z) * b1 - b2;
    b2 = b1, b1 = b;
  }
  return b1 * sine_2z;
}

// Its product has no tests for infinities, as that of std::complex has.
struct Complex {
  double re = 0, im = 0;
  Complex() = default;
  // implicit, as of std::complex; NOLINTNEXTLINE(google-explicit-constructor)
  Complex(double r, double i = 0) : re(r), im(i) {}
};
Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }

/// A place by the directions of its latitude and of its longitude from the origin's meridian.
struct Directions {
  double cos_lat, sin_lat, cos_lon, sin_lon;
};

// The conformal latitude's direction turned by the difference to the geodetic one.
Vec2 geodetic_of(Vec2 conformal) {
  const double c = conformal.x, s = conformal.y;
  const double more = sine_sum<double>(kDelta, 2 * s * c, c * c - s * s);
  const double sin_more = small_sine(more), cos_more = std::sqrt(1 - sin_more * sin_more);
  return {c * cos_more - s * sin_more, s * cos_more + c * sin_more};
}

/// @param xi, eta  Plane metres from the equator and the meridian, in rectifying radii.
Directions directions_of(double xi, double eta) {
  const Vec2 d = direction_of_rad(2 * xi);
  const double sinh_2eta = small_hyperbolic_sine(2 * eta), cosh_2eta = std::sqrt(1 + sinh_2eta * sinh_2eta);
  const Complex moved =
      sine_sum<Complex>(kBeta, {d.y * cosh_2eta, d.x * sinh_2eta}, {d.x * cosh_2eta, -d.y * sinh_2eta});
  const Vec2 on_sphere = direction_of_rad(xi - moved.re);
  const double sinh_eta = small_hyperbolic_sine(eta - moved.im), cosh_eta = std::sqrt(1 + sinh_eta * sinh_eta);
  const double radius = std::sqrt(sinh_eta * sinh_eta + on_sphere.x * on_sphere.x);
  const Vec2 lat = geodetic_of({radius / cosh_eta, on_sphere.y / cosh_eta});
  return {lat.x, lat.y, on_sphere.x / radius, sinh_eta / radius};
}

Vec3 up_at(const Directions& d) { return {d.cos_lat * d.cos_lon, d.cos_lat * d.sin_lon, d.sin_lat}; }

// Earth-centred, with the origin's meridian as longitude 0.
Vec3 earth_at(const Directions& d, double height_m) {
  const double normal_m = kA_m / std::sqrt(1 - kE2 * d.sin_lat * d.sin_lat);
  const double across_m = (normal_m + height_m) * d.cos_lat;
  return {across_m * d.cos_lon, across_m * d.sin_lon, (normal_m * (1 - kE2) + height_m) * d.sin_lat};
}

}  // namespace

Globe::Globe(LonLat origin)
    : direction_of_latitude_(direction_of(origin.lat_deg / 360)),
      direction_of_longitude_(direction_of(origin.lon_deg / 360)),
      earth_(earth_at({direction_of_latitude_.x, direction_of_latitude_.y, 1, 0}, 0)),
      along_m_(-static_cast<double>(precise_forward(origin, {origin.lon_deg, 0}).y)) {}

BentPoint Globe::at(Vec3 p) const {
  assert(std::abs(p.x) <= 1.5e6);
  const Directions d = directions_of((p.y + along_m_) / kRectifyingRadius_m, p.x / kRectifyingRadius_m);
  const Vec2 lat0 = direction_of_latitude_;
  const auto in_frame = [&](Vec3 v) { return Vec3{v.y, lat0.x * v.z - lat0.y * v.x, lat0.x * v.x + lat0.y * v.z}; };
  const Vec3 up = up_at(d), east{-d.sin_lon, d.cos_lon, 0}, north = cross(up, east);
  // the plane's north is turned clockwise from north by the convergence, whose tangent is tan(longitude) sin(latitude)
  const Vec2 turn = unit(Vec2{d.cos_lon, d.sin_lon * d.sin_lat});
  return {.at = in_frame(earth_at(d, p.z) - earth_),
          .east = in_frame(east * turn.x - north * turn.y),
          .north = in_frame(east * turn.y + north * turn.x),
          .up = in_frame(up)};
}

std::array<double, 16> Globe::to_earth() const {
  const Vec2 lat = direction_of_latitude_, lon = direction_of_longitude_;
  const auto turned = [&](Vec3 v) { return Vec3{lon.x * v.x - lon.y * v.y, lon.y * v.x + lon.x * v.y, v.z}; };
  const Vec3 e = turned({0, 1, 0}), n = turned({-lat.y, 0, lat.x}), u = turned({lat.x, 0, lat.y}), at = turned(earth_);
  return {e.x, e.y, e.z, 0, n.x, n.y, n.z, 0, u.x, u.y, u.z, 0, at.x, at.y, at.z, 1};
}

namespace {
constexpr double kClimb = 1.2;
}
double sag_m(double length_m) { return kClimb * length_m * length_m / (8 * kLeastRadius_m); }
double length_with_sag_m(double sag_m) { return std::sqrt(sag_m * 8 * kLeastRadius_m / kClimb); }

}  // namespace citykiln::map
