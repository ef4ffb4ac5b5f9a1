// Sun position: The Astronomical Almanac, section C, "low-precision formulas for the Sun's coordinates" (mean anomaly,
// equation of the centre, ecliptic longitude, obliquity), and mean sidereal time from section B. Then rotations from
// the ecliptic to the equator and to the horizon of the place.
#include "compiler/sky/plan.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

constexpr double kUnixEpoch = 2440587.5, kJ2000 = 2451545.0;  // Julian dates

// Default time: shadows are visible and short.
constexpr double kDefaultSolarHour = 15;

// Two digits at `at`, or nothing.
std::optional<unsigned> two_digits(const std::string& text, std::size_t at) {
  const auto is_digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  if (!is_digit(at) || !is_digit(at + 1)) return std::nullopt;
  return static_cast<unsigned>((text[at] - '0') * 10 + (text[at + 1] - '0'));
}

bool has(const std::string& text, std::size_t at, char c) { return at < text.size() && text[at] == c; }

// Days since 2000-01-01T12:00 UTC.
std::optional<double> parse_days(const std::string& time) {
  const auto century = two_digits(time, 0), year = two_digits(time, 2), month = two_digits(time, 5),
             day = two_digits(time, 8);
  const auto hour = two_digits(time, 11), minute = two_digits(time, 14), second = two_digits(time, 17);
  const bool has_seconds = has(time, 16, ':');
  const std::size_t end = has_seconds ? 19 : 16;
  const bool ends = time.size() == end || (time.size() == end + 1 && time[end] == 'Z');
  if (!century || !year || !month || !day || !hour || !minute || (has_seconds && !second)) return std::nullopt;
  if (!has(time, 4, '-') || !has(time, 7, '-') || !has(time, 10, 'T') || !has(time, 13, ':') || !ends)
    return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(*century * 100 + *year)),
                                         std::chrono::month(*month), std::chrono::day(*day)};
  const unsigned seconds = has_seconds ? *second : 0;
  if (!date.ok() || *hour > 23 || *minute > 59 || seconds > 59) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<double>(days) + (*hour * 3600.0 + *minute * 60.0 + seconds) / 86400 + kUnixEpoch - kJ2000;
}

// Midsummer day, at the UTC of mean solar time kDefaultSolarHour at the place.
std::string default_time(map::LonLat place) {
  const int minutes = static_cast<int>(std::floor((kDefaultSolarHour - place.lon_deg / 15) * 60 + 0.5));
  const int of_day = (minutes % 1440 + 1440) % 1440;
  char text[32];
  std::snprintf(text, sizeof text, "2026-%s-21T%02d:%02d", place.lat_deg < 0 ? "12" : "06", of_day / 60, of_day % 60);
  return text;
}

// Not by libm, whose last bit differs between CPUs.
Vec2 direction_of_deg(double deg) { return direction_of(deg / 360); }

// `v` in a frame that is rotated by the angle of the unit vector `turn`.
Vec2 rotated_frame(Vec2 v, Vec2 turn) { return {v.x * turn.x + v.y * turn.y, v.y * turn.x - v.x * turn.y}; }

// Unit vector to the sun: east, north, up; without refraction.
Vec3 to_sun(map::LonLat place, double days) {
  const double anomaly_deg = 357.529 + 0.98560028 * days;
  const double centre_deg = 1.915 * direction_of_deg(anomaly_deg).y + 0.020 * direction_of_deg(2 * anomaly_deg).y;
  const Vec2 ecliptic = direction_of_deg(280.459 + 0.98564736 * days + centre_deg);
  const Vec2 obliquity = direction_of_deg(23.439 - 0.00000036 * days);
  const double sin_declination = obliquity.y * ecliptic.y;
  const double sidereal_deg = 15 * (18.697374558 + 24.06570982441908 * days);
  // equatorial plane: x towards the meridian, y to the east
  const Vec2 level =
      rotated_frame({ecliptic.x, obliquity.x * ecliptic.y}, direction_of_deg(sidereal_deg + place.lon_deg));
  const Vec2 latitude = direction_of_deg(place.lat_deg);
  return {level.y, latitude.x * sin_declination - latitude.y * level.x,
          latitude.y * sin_declination + latitude.x * level.x};
}

// Six digits keep the manifest small.
double quantised(double v) { return std::floor(v * 0x1p20 + 0.5) * 0x1p-20; }

}  // namespace

Result<Sky> plan(map::LonLat place, const std::string& time) {
  Sky sky;
  sky.time = time.empty() ? default_time(place) : time;
  const auto days = parse_days(sky.time);
  if (!days) return Error{time, "expected a time like 2026-06-21T15:00, with seconds or not, in UTC"};
  const Vec3 sun = to_sun(place, *days);
  sky.to_sun = {quantised(sun.x), quantised(sun.y), quantised(sun.z)};
  return sky;
}

}  // namespace citykiln::sky
