#include "compiler/sky/plan.h"

#include <cmath>

#include "compiler/geometry/trig.h"
#include "compiler/geometry/vec.h"
#include "compiler/sky/horizon.h"
#include "compiler/sky/moment.h"

namespace citykiln::sky {
namespace {

// The positions of sun, moon and stars, seen from the Earth's centre.
//
// Sun: The Astronomical Almanac, section C, low-precision formulas; mean sidereal time: section B. Moon: Meeus,
// Astronomical Algorithms, 1998, chapter 47, the terms above 0.002° in longitude and latitude and above 7 km in
// distance. Precession: Lieske et al. 1977, in Meeus' chapter 21.

constexpr double kDaysInCentury = 36525, kEarth_km = 6378.137;

// Terrestrial time is ahead of UTC by 63 to 93 s from 2000 to 2050, in which the moon moves by up to 0.01°.
constexpr double kTerrestrial_days = 70.0 / 86400;

Vec2 direction_of_deg(double deg) { return direction_of(deg / 360); }

double sine_of(double deg) { return direction_of_deg(deg).y; }

double cosine_of(double deg) { return direction_of_deg(deg).x; }

// Multiples of elongation D, the sun's anomaly M, the moon's anomaly M' and argument of latitude F.
struct LongitudeTerm {
  int d, m, m_moon, f;
  double longitude_udeg, distance_m;
};

constexpr LongitudeTerm kLongitude[] = {
    {0, 0, 1, 0, 6288774, -20905355}, {2, 0, -1, 0, 1274027, -3699111}, {2, 0, 0, 0, 658314, -2955968},
    {0, 0, 2, 0, 213618, -569925},    {0, 1, 0, 0, -185116, 48888},     {0, 0, 0, 2, -114332, -3149},
    {2, 0, -2, 0, 58793, 246158},     {2, -1, -1, 0, 57066, -152138},   {2, 0, 1, 0, 53322, -170733},
    {2, -1, 0, 0, 45758, -204586},    {0, 1, -1, 0, -40923, -129620},   {1, 0, 0, 0, -34720, 108743},
    {0, 1, 1, 0, -30383, 104755},     {2, 0, 0, -2, 15327, 10321},      {0, 0, 1, 2, -12528, 0},
    {0, 0, 1, -2, 10980, 79661},      {4, 0, -1, 0, 10675, -34782},     {0, 0, 3, 0, 10034, -23210},
    {4, 0, -2, 0, 8548, -21636},      {2, 1, -1, 0, -7888, 24208},      {2, 1, 0, 0, -6766, 30824},
    {1, 0, -1, 0, -5163, -8379},      {1, 1, 0, 0, 4987, -16675},       {2, -1, 1, 0, 4036, -12831},
    {2, 0, 2, 0, 3994, -10445},       {4, 0, 0, 0, 3861, -11650},       {2, 0, -3, 0, 3665, 14403},
    {0, 1, -2, 0, -2689, -7003},      {2, 0, -1, 2, -2602, 0},          {2, -1, -2, 0, 2390, 10056}};

struct LatitudeTerm {
  int d, m, m_moon, f;
  double latitude_udeg;
};

constexpr LatitudeTerm kLatitude[] = {
    {0, 0, 0, 1, 5128122}, {0, 0, 1, 1, 280602},  {0, 0, 1, -1, 277693}, {2, 0, 0, -1, 173237}, {2, 0, -1, 1, 55413},
    {2, 0, -1, -1, 46271}, {2, 0, 0, 1, 32573},   {0, 0, 2, 1, 17198},   {2, 0, 1, -1, 9266},   {0, 0, 2, -1, 8822},
    {2, -1, 0, -1, 8216},  {2, 0, -2, -1, 4324},  {2, 0, 1, 1, 4200},    {2, 1, 0, -1, -3359},  {2, -1, -1, 1, 2463},
    {2, -1, 0, 1, 2211},   {2, -1, -1, -1, 2065}, {0, 1, -1, -1, -1870}, {4, 0, -1, -1, 1828}};

// From the ecliptic to the equator of date.
Vec3 equatorial(Vec3 ecliptic, double days) {
  const Vec2 tilt = direction_of_deg(23.439 - 0.00000036 * days);
  return {ecliptic.x, tilt.x * ecliptic.y - tilt.y * ecliptic.z, tilt.y * ecliptic.y + tilt.x * ecliptic.z};
}

// In the plane of two axes, `v` in a frame that is rotated by an angle.
Vec2 rotated_frame(Vec2 v, double deg) {
  const Vec2 turn = direction_of_deg(deg);
  return {v.x * turn.x + v.y * turn.y, v.y * turn.x - v.x * turn.y};
}

// Returns the direction to the sun, a unit vector. Error: 0.01° from 1950 to 2050.
Vec3 sun_of_date(double days) {
  const double anomaly_deg = 357.529 + 0.98560028 * days;
  const double centre_deg = 1.915 * sine_of(anomaly_deg) + 0.020 * sine_of(2 * anomaly_deg);
  const Vec2 ecliptic = direction_of_deg(280.459 + 0.98564736 * days + centre_deg);
  return equatorial({ecliptic.x, ecliptic.y, 0}, days);
}

// Returns the position of the moon's middle, in equatorial radii of the Earth. Error of its direction: 0.02° from 1950
// to 2050.
Vec3 moon_of_date_radii(double days) {
  const double t = (days + kTerrestrial_days) / kDaysInCentury;
  const double d = 297.8501921 + (445267.1114034 - 0.0018819 * t) * t, m = 357.5291092 + 35999.0502909 * t;
  const double m_moon = 134.9633964 + (477198.8675055 + 0.0087414 * t) * t;
  const double f = 93.2720950 + (483202.0175233 - 0.0036539 * t) * t;
  const auto angle_deg = [&](const auto& term) { return term.d * d + term.m * m + term.m_moon * m_moon + term.f * f; };
  double longitude_deg = 218.3164477 + (481267.88123421 - 0.0015786 * t) * t, latitude_deg = 0, distance_km = 385000.56;
  for (const LongitudeTerm& term : kLongitude) {
    const Vec2 turn = direction_of_deg(angle_deg(term));
    longitude_deg += term.longitude_udeg * 1e-6 * turn.y;
    distance_km += term.distance_m * 1e-3 * turn.x;
  }
  for (const LatitudeTerm& term : kLatitude) latitude_deg += term.latitude_udeg * 1e-6 * sine_of(angle_deg(term));
  const double level = cosine_of(latitude_deg) * distance_km / kEarth_km;
  return equatorial({level * cosine_of(longitude_deg), level * sine_of(longitude_deg),
                     sine_of(latitude_deg) * distance_km / kEarth_km},
                    days);
}

// Converts a direction from the frame of J2000.0 to the frame of date, by precession alone. Nutation and aberration
// are below 0.01°.
Vec3 precessed(Vec3 j2000, double days) {
  const double t = days / kDaysInCentury;
  const double zeta_deg = (2306.2181 + 0.30188 * t) * t / 3600, z_deg = (2306.2181 + 1.09468 * t) * t / 3600;
  const double theta_deg = (2004.3109 - 0.42665 * t) * t / 3600;
  const Vec2 first = rotated_frame({j2000.x, j2000.y}, -zeta_deg);
  const Vec2 second = rotated_frame({first.x, j2000.z}, -theta_deg);
  const Vec2 third = rotated_frame({second.x, first.y}, -z_deg);
  return {third.x, third.y, second.y};
}

// Returns the mean sidereal time at Greenwich in degrees, not reduced to one turn.
double sidereal_deg(double days) { return 15 * (18.697374558 + 24.06570982441908 * days); }

// Default time: shadows are visible and short.
constexpr double kDefaultSolarHour = 15;

// Midsummer day, at the UTC of mean solar time kDefaultSolarHour at the place.
Moment default_time(LonLat place) {
  const int minutes = static_cast<int>(std::floor((kDefaultSolarHour - place.lon_deg / 15) * 60 + 0.5));
  const auto month = place.lat_deg < 0 ? std::chrono::December : std::chrono::June;
  return moment_of(std::chrono::year(2026) / month / 21, (minutes % 1440 + 1440) % 1440);
}

// Six digits keep the manifest small.
double quantised(double v) { return std::floor(v * 0x1p20 + 0.5) * 0x1p-20; }
Vec3 quantised(Vec3 v) { return {quantised(v.x), quantised(v.y), quantised(v.z)}; }

// The lit share of the moon's disk, by the angle between sun and moon: the sun is 400 times as far away.
double lit_share(Vec3 to_sun, Vec3 to_moon) { return (1 - dot(to_sun, to_moon)) / 2; }

}  // namespace

Sky plan(LonLat place, const std::optional<Moment>& time) {
  const Moment moment = time.value_or(default_time(place));
  const double days = days_of(moment), sidereal = sidereal_deg(days);
  const Vec3 sun = sun_of_date(days), moon = moon_of_date_radii(days) - place_radii(place, sidereal);
  const auto local = [&](Vec3 v) { return at_horizon(v, place, sidereal); };
  Sky sky;
  sky.time = moment;
  sky.to_sun = quantised(refracted(local(sun)));
  sky.to_moon = quantised(refracted(unit(local(moon))));
  sky.moon_lit = quantised(lit_share(sun, unit(moon)));
  sky.to_pole = quantised(local(precessed({0, 0, 1}, days)));
  sky.to_equinox = quantised(local(precessed({1, 0, 0}, days)));
  return sky;
}

}  // namespace citykiln::sky
