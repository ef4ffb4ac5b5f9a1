#include "compiler/sky/inside/plan_inside.h"

#include <algorithm>
#include <cmath>

#include "compiler/sky/inside/line_light.h"
#include "compiler/sky/inside/thin_air.h"

namespace citykiln::sky {
namespace {

// Sizes of a line as shares of the radius: its height above the ground, the tube, the gap to the middle and to the end.
constexpr double kHeight = 0.06, kTube = 0.006, kMiddleGap = 0.15, kEndGap = 0.3;
constexpr double kTemperature_k = 5500, kLeastLength = 6;
// Turns of the lines from the middle of the map.
constexpr double kTurns[] = {-1.0 / 6, 1.0 / 6, 0.5};

LineLight line_between(const map::Cylinder& cylinder, double west_m, double east_m, double y_m) {
  const double height_m = kHeight * cylinder.radius_m;
  return {.from = {std::round(west_m), std::round(y_m), std::round(height_m)},
          .to = {std::round(east_m), std::round(y_m), std::round(height_m)},
          .lumen_per_m = 1,
          .temperature_k = kTemperature_k,
          .radius_m = kTube * cylinder.radius_m};
}

}  // namespace

Inside plan_inside(const map::Cylinder& cylinder, const Box2& extent) {
  const double radius_m = cylinder.radius_m;
  const Vec2 middle = extent.centre();
  const double half_m = std::max(extent.width() / 2 + radius_m, kLeastLength / 2 * radius_m);
  Inside inside{.cylinder = cylinder,
                .west_m = std::floor(middle.x - half_m),
                .east_m = std::ceil(middle.x + half_m),
                .fall = kUsualFall};
  for (const double turn : kTurns) {
    const double y_m = middle.y + turn * map::circumference_m(cylinder);
    inside.lines.push_back(
        line_between(cylinder, middle.x - half_m + kEndGap * radius_m, middle.x - kMiddleGap * radius_m, y_m));
    inside.lines.push_back(
        line_between(cylinder, middle.x + kMiddleGap * radius_m, middle.x + half_m - kEndGap * radius_m, y_m));
  }
  const double lumen_per_m = std::round(kInsideDaylight_lx / daylight_lx(inside, {middle.x, middle.y, 0}));
  for (LineLight& line : inside.lines) line.lumen_per_m = lumen_per_m;
  return inside;
}

double daylight_lx(const Inside& inside, Vec3 at) {
  const map::BentPoint place = map::at(inside.cylinder, at);
  double sum_lx = 0;
  for (const LineLight& line : inside.lines) {
    const auto seen =
        seen_line(map::at(inside.cylinder, line.from).at, map::at(inside.cylinder, line.to).at, place.at, place.up);
    if (seen) sum_lx += candela_per_m(line.lumen_per_m) * irradiance(*seen, place.up);
  }
  return sum_lx;
}

}  // namespace citykiln::sky
