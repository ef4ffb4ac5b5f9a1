#include "compiler/sky/plan.h"

#include <cmath>
#include <cstdio>

#include "compiler/sky/ephemeris.h"
#include "compiler/sky/horizon.h"
#include "compiler/sky/parse_time.h"

namespace citykiln::sky {
namespace {

// Default time: shadows are visible and short.
constexpr double kDefaultSolarHour = 15;

// Midsummer day, at the UTC of mean solar time kDefaultSolarHour at the place.
std::string default_time(LonLat place) {
  const int minutes = static_cast<int>(std::floor((kDefaultSolarHour - place.lon_deg / 15) * 60 + 0.5));
  const int of_day = (minutes % 1440 + 1440) % 1440;
  char text[32];
  std::snprintf(text, sizeof text, "2026-%s-21T%02d:%02d", place.lat_deg < 0 ? "12" : "06", of_day / 60, of_day % 60);
  return text;
}

// Six digits keep the manifest small.
double quantised(double v) { return std::floor(v * 0x1p20 + 0.5) * 0x1p-20; }
Vec3 quantised(Vec3 v) { return {quantised(v.x), quantised(v.y), quantised(v.z)}; }

// The lit share of the moon's disk, by the angle between sun and moon: the sun is 400 times as far away.
double lit_share(Vec3 to_sun, Vec3 to_moon) { return (1 - dot(to_sun, to_moon)) / 2; }

}  // namespace

Result<Sky> plan(LonLat place, const std::string& time) {
  const Result<Moment> moment = parse_time(time.empty() ? default_time(place) : time);
  if (!moment) return moment.error();
  const double days = moment->days, sidereal = sidereal_deg(days);
  const Vec3 sun = sun_of_date(days), moon = moon_of_date_radii(days) - place_radii(place, sidereal);
  const auto local = [&](Vec3 v) { return at_horizon(v, place, sidereal); };
  Sky sky;
  sky.time = moment->text;
  sky.to_sun = quantised(refracted(local(sun)));
  sky.to_moon = quantised(refracted(unit(local(moon))));
  sky.moon_lit = quantised(lit_share(sun, unit(moon)));
  sky.to_pole = quantised(local(precessed({0, 0, 1}, days)));
  sky.to_equinox = quantised(local(precessed({1, 0, 0}, days)));
  return sky;
}

}  // namespace citykiln::sky
