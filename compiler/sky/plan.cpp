// The Astronomical Almanac's low-precision formulas for the Sun (0.01° between 1950 and 2050).
#include "compiler/sky/plan.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace citykiln::sky {
namespace {

constexpr double kRadian = std::numbers::pi / 180;
// Fine enough for any shadow (a millionth of a radian), coarse enough that every CPU's sines round alike.
constexpr double kDirectionStep = 0x1p-20;
constexpr double kDefaultHour = 15;

struct Moment {
  int year, month, day;
  double hours;  // UTC
};

bool take_int(const std::string& text, std::size_t at, std::size_t digits, int& value) {
  if (text.size() < at + digits) return false;
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + at + digits, value);
  return error == std::errc() && end == text.data() + at + digits;
}

// "YYYY-MM-DDThh:mm", then ":ss", then "Z", each of the last two or not.
bool parse(const std::string& text, Moment& moment) {
  int hour = 0, minute = 0, second = 0;
  if (!take_int(text, 0, 4, moment.year) || !take_int(text, 5, 2, moment.month) || !take_int(text, 8, 2, moment.day) ||
      !take_int(text, 11, 2, hour) || !take_int(text, 14, 2, minute))
    return false;
  if (text[4] != '-' || text[7] != '-' || (text[10] != 'T' && text[10] != ' ') || text[13] != ':') return false;
  std::size_t end = 16;
  if (text.size() > end && text[end] == ':') {
    if (!take_int(text, end + 1, 2, second)) return false;
    end += 3;
  }
  if (text.size() > end && text[end] == 'Z') ++end;
  moment.hours = hour + minute / 60.0 + second / 3600.0;
  return end == text.size() && moment.month >= 1 && moment.month <= 12 && moment.day >= 1 && moment.day <= 31 && hour < 24 && minute < 60 && second < 61;
}

// Days since 2000-01-01 12:00 UTC (Fliegel, van Flandern 1968 for the day number).
double days_since_j2000(const Moment& m) {
  const int a = (14 - m.month) / 12, y = m.year + 4800 - a, n = m.month + 12 * a - 3;
  const int day_number = m.day + (153 * n + 2) / 5 + 365 * y + y / 4 - y / 100 + y / 400 - 32045;
  return day_number - 2451545 + (m.hours - 12) / 24;
}

Vec3 to_sun(double days, map::LonLat place) {
  const double g = (357.529 + 0.98560028 * days) * kRadian, q = 280.459 + 0.98564736 * days;
  const double longitude = (q + 1.915 * std::sin(g) + 0.020 * std::sin(2 * g)) * kRadian, tilt = (23.439 - 0.00000036 * days) * kRadian;
  const double ascension = std::atan2(std::cos(tilt) * std::sin(longitude), std::cos(longitude)), declination = std::asin(std::sin(tilt) * std::sin(longitude));
  const double sidereal = (280.46062 + 360.98564737 * days + place.lon_deg) * kRadian, hour_angle = sidereal - ascension, lat = place.lat_deg * kRadian;
  return {-std::cos(declination) * std::sin(hour_angle), std::sin(declination) * std::cos(lat) - std::cos(declination) * std::cos(hour_angle) * std::sin(lat),
          std::sin(declination) * std::sin(lat) + std::cos(declination) * std::cos(hour_angle) * std::cos(lat)};
}

Vec3 rounded(Vec3 v) {
  const auto step = [](double c) { return std::floor(c / kDirectionStep + 0.5) * kDirectionStep; };
  return {step(v.x), step(v.y), step(v.z)};
}

}  // namespace

Result<Sky> plan(map::LonLat place, const std::string& time) {
  Moment moment{2026, place.lat_deg >= 0 ? 6 : 12, 21, kDefaultHour - place.lon_deg / 15};
  if (!time.empty() && !parse(time, moment)) return Error{"--time " + time, "expected a time such as 2026-06-21T15:00 (UTC)"};
  Sky sky;
  sky.time = time;
  sky.to_sun = rounded(to_sun(days_since_j2000(moment), place));
  return sky;
}

}  // namespace citykiln::sky
