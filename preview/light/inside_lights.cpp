#include "preview/light/inside_lights.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/props/luminaire.h"
#include "compiler/sky/generate.h"
#include "compiler/sky/inside/thin_air.h"

namespace citykiln::preview {
namespace {

// Bare hull: the colour of dry, dusty metal.
constexpr Rgb kHull = {0.20, 0.19, 0.18};

// Extinction of molecules at sea level in red, green and blue (610, 550 and 465 nm), per metre.
constexpr Rgb kMolecules_per_m = {0.77e-5, 1.16e-5, 2.27e-5};
constexpr double kContrast = 3.912;  // -ln 0.02

// Points and weights of Gauss and Legendre on [-1, 1].
constexpr std::array<double, 4> kPoints = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                           0.9602898564975363},
                                kWeights = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                            0.1012285362903763};

Rgb shade_of(double temperature_k) {
  const auto [r, g, b] = props::black_body_colour(temperature_k);
  return {r, g, b};
}

// Extinction of air at the ground: molecules, and dust that takes as much as the visibility is less.
Rgb extinction_of(double visibility_km) {
  const double dust_per_m = std::max(0.0, kContrast / (visibility_km * 1000) - kMolecules_per_m[1]);
  return kMolecules_per_m + Rgb{dust_per_m, dust_per_m, dust_per_m};
}

// The distances at which a ray enters and leaves a circle of the plane of y and z; empty if it misses it.
struct Crossing {
  double enters_m, leaves_m;
};
std::optional<Crossing> cross_circle(Vec2 out, Vec2 direction, double radius_m) {
  const double a = dot(direction, direction), b = dot(out, direction), c = dot(out, out) - radius_m * radius_m;
  const double under = b * b - a * c;
  if (!(a > 1e-18) || !(under >= 0)) return std::nullopt;
  const double root = std::sqrt(under);
  return Crossing{(-b - root) / a, (-b + root) / a};
}

Vec2 across_axis(Vec3 v) { return {v.y, v.z}; }

}  // namespace

InsideLights::InsideLights(const sky::Sky& sky)
    : inside_(*sky.inside), are_lit_(sky::are_lines_lit(sky)), extinction_per_m_(extinction_of(sky.visibility_km)) {
  for (const sky::LineLight& line : inside_.lines) {
    const double across = sky::candela_per_m(line.lumen_per_m) / sky::kUnitLuminance_cd_m2;
    const Rgb intensity = shade_of(line.temperature_k) * across;
    lines_.push_back({.from = map::at(inside_.cylinder, line.from).at,
                      .to = map::at(inside_.cylinder, line.to).at,
                      .radius_m = line.radius_m,
                      .intensity = intensity,
                      .radiance = intensity * (1 / (2 * line.radius_m))});
  }
}

Rgb InsideLights::passed(double column_m) const {
  return {std::exp(-extinction_per_m_[0] * column_m), std::exp(-extinction_per_m_[1] * column_m),
          std::exp(-extinction_per_m_[2] * column_m)};
}

std::optional<LightSample> InsideLights::sample(Vec3 at, Vec3 normal, UnitPair chance) const {
  constexpr std::size_t kMost = 64;
  if (!are_lit_) return std::nullopt;
  const bool has_normal = dot(normal, normal) > 0;
  std::array<std::optional<sky::SeenLine>, kMost> seen;
  std::array<double, kMost> until{};
  double sum = 0;
  const std::size_t count = std::min(lines_.size(), kMost);
  for (std::size_t i = 0; i < count; ++i) {
    const Line& line = lines_[i];
    seen[i] = has_normal ? sky::seen_line(line.from, line.to, at, normal) : sky::seen_line(line.from, line.to, at);
    if (seen[i])
      sum += luminance(line.intensity) * (has_normal ? sky::irradiance(*seen[i], normal) : sky::fluence(*seen[i]));
    until[i] = sum;
  }
  if (!(sum > 0)) return std::nullopt;
  const auto i =
      std::min(static_cast<std::size_t>(
                   std::upper_bound(until.begin(), until.begin() + static_cast<std::ptrdiff_t>(count), chance.u * sum) -
                   until.begin()),
               count - 1);
  if (!seen[i]) return std::nullopt;
  const double probability = (until[i] - (i > 0 ? until[i - 1] : 0)) / sum;
  const double sine = seen[i]->low_sine + chance.v * seen[i]->extent();
  const double distance_m = seen[i]->distance_m / std::sqrt(std::max(1e-12, 1 - sine * sine));
  LightSample drawn{.direction = direction_to(*seen[i], sine), .distance_m = distance_m};
  drawn.light = lines_[i].intensity * passed(sky::column_m(inside_, at, drawn.direction, distance_m)) *
                (sky::fluence(*seen[i]) / probability);
  // the tube throws no shadow
  drawn.distance_m = std::max(distance_m - lines_[i].radius_m, 1e-3 * distance_m);
  return drawn;
}

std::optional<Seen> InsideLights::tube(Vec3 from, Vec3 direction) const {
  std::optional<Seen> nearest;
  if (!are_lit_) return nearest;
  for (const Line& line : lines_) {
    const auto crossing = cross_circle(across_axis(from - line.from), across_axis(direction), line.radius_m);
    if (!crossing || !(crossing->enters_m > 0) || (nearest && nearest->distance_m <= crossing->enters_m)) continue;
    const double x = from.x + direction.x * crossing->enters_m;
    if (x < line.from.x || x > line.to.x) continue;
    nearest = Seen{crossing->enters_m, line.radiance};
  }
  return nearest;
}

Rgb InsideLights::irradiance_at(Vec3 place, Vec3 normal) const {
  Rgb sum{};
  if (!are_lit_) return sum;
  for (const Line& line : lines_)
    if (const auto seen = sky::seen_line(line.from, line.to, place, normal))
      sum = sum + line.intensity * sky::irradiance(*seen, normal);
  return sum;
}

Seen InsideLights::hull(Vec3 from, Vec3 direction) const {
  const Vec3 axis{0, 0, inside_.cylinder.radius_m};
  double distance_m = std::numeric_limits<double>::infinity();
  bool is_end = false;
  if (const auto crossing = cross_circle(across_axis(from - axis), across_axis(direction), inside_.cylinder.radius_m);
      crossing && crossing->leaves_m > 0)
    distance_m = crossing->leaves_m;
  const double end_m = ((direction.x > 0 ? inside_.east_m : inside_.west_m) - from.x) / direction.x;
  if (direction.x != 0 && end_m >= 0 && end_m < distance_m) distance_m = end_m, is_end = true;
  if (!std::isfinite(distance_m)) return {0, {}};
  const Vec3 place = from + direction * distance_m;
  const Vec3 normal = is_end ? Vec3{direction.x > 0 ? -1.0 : 1.0, 0, 0} : unit(Vec3{0, -place.y, axis.z - place.z});
  return {distance_m, irradiance_at(place, normal) * kHull * (1 / std::numbers::pi)};
}

// The light that the air at the end of a ray scatters into it, of a metre of the line's distance: without 1 / h.
Rgb InsideLights::scattered_at(const Line& line, Vec3 from, Vec3 direction, double distance_m) const {
  const Vec3 at = from + direction * distance_m;
  const auto seen = sky::seen_line(line.from, line.to, at);
  if (!seen) return {};
  // light comes through the air between the place and the line's middle as it is seen
  const double sine = (seen->low_sine + seen->high_sine) / 2,
               away_m = seen->distance_m / std::sqrt(std::max(1e-6, 1 - sine * sine));
  const Vec3 towards = direction_to(*seen, sine);
  const double between_m = away_m * (sky::density_at(inside_, at + towards * (away_m / 2)));
  const double column_m = sky::column_m(inside_, from, direction, distance_m);
  return extinction_per_m_ * passed(column_m + between_m) *
         (sky::density_at(inside_, at) * seen->extent() / (4 * std::numbers::pi));
}

Rgb InsideLights::added_by(const Line& line, Vec3 from, Vec3 direction, double distance_m) const {
  // the distance from the line is the root of near² + speed² (t - nearest)²
  const Vec2 out = across_axis(from - line.from), along = across_axis(direction);
  const double speed = std::max(length(along), 1e-3), nearest_m = -dot(out, along) / (speed * speed);
  const Vec2 closest = out + along * nearest_m;
  const double near_m = std::max(length(closest), line.radius_m);
  const auto parameter = [&](double t) { return std::asinh(speed * (t - nearest_m) / near_m); };
  const double begin = parameter(0), end = parameter(distance_m), middle = std::clamp(0.0, begin, end);
  Rgb sum{};
  for (const auto& [low, high] : {std::pair(begin, middle), std::pair(middle, end)}) {
    const double half = (high - low) / 2;
    if (!(half > 1e-9)) continue;
    for (std::size_t i = 0; i < kPoints.size(); ++i)
      for (const double side : {-kPoints[i], kPoints[i]}) {
        const double t = nearest_m + near_m / speed * std::sinh((low + high) / 2 + half * side);
        sum = sum + scattered_at(line, from, direction, std::clamp(t, 0.0, distance_m)) * (kWeights[i] * half / speed);
      }
  }
  return sum * line.intensity;
}

sky::AirPath InsideLights::air(Vec3 from, Vec3 direction, double distance_m) const {
  sky::AirPath path;
  path.passed = passed(sky::column_m(inside_, from, direction, distance_m));
  if (!are_lit_) return path;
  for (const Line& line : lines_) path.added = path.added + added_by(line, from, direction, distance_m);
  return path;
}

}  // namespace citykiln::preview
