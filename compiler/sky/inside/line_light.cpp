#include "compiler/sky/inside/line_light.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

double arcsine_rad(double sine) { return arctangent2_deg(sine, std::sqrt(std::max(0.0, 1 - sine * sine))) * kPi / 180; }

// The integral of cos(theta) (a cos(theta) + b sin(theta)) up to an angle of this sine.
double irradiance_up_to(double a, double b, double sine) {
  const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
  return (a * (arcsine_rad(sine) + sine * cosine) + b * sine * sine) / 2;
}

}  // namespace

std::optional<SeenLine> seen_line(Vec3 from, Vec3 to, Vec3 place) {
  const Vec3 along = unit(to - from), out = from - place;
  const double begin_m = dot(out, along), end_m = begin_m + length(to - from);
  const Vec3 across = out - along * begin_m;
  const double distance_m = length(across);
  if (!(distance_m > 0)) return std::nullopt;
  return SeenLine{.across = across * (1 / distance_m),
                  .along = along,
                  .distance_m = distance_m,
                  .low_sine = begin_m / std::sqrt(begin_m * begin_m + distance_m * distance_m),
                  .high_sine = end_m / std::sqrt(end_m * end_m + distance_m * distance_m)};
}

std::optional<SeenLine> seen_line(Vec3 from, Vec3 to, Vec3 place, Vec3 normal) {
  std::optional<SeenLine> line = seen_line(from, to, place);
  if (!line) return line;
  // the horizon is where a cos(theta) + b sin(theta) = 0
  const double a = dot(normal, line->across), b = dot(normal, line->along);
  const double horizon = -a / std::sqrt(std::max(a * a + b * b, 1e-300));
  if (b > 0)
    line->low_sine = std::max(line->low_sine, horizon);
  else if (b < 0)
    line->high_sine = std::min(line->high_sine, -horizon);
  else if (a <= 0)
    return std::nullopt;
  if (!(line->low_sine < line->high_sine)) return std::nullopt;
  return line;
}

Vec3 direction_to(const SeenLine& line, double sine) {
  return line.across * std::sqrt(std::max(0.0, 1 - sine * sine)) + line.along * sine;
}

double irradiance(const SeenLine& line, Vec3 normal) {
  const double a = dot(normal, line.across), b = dot(normal, line.along);
  return std::max(0.0, irradiance_up_to(a, b, line.high_sine) - irradiance_up_to(a, b, line.low_sine)) /
         line.distance_m;
}

}  // namespace citykiln::sky
