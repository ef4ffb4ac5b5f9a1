// Air inside of a spinning cylinder of 8 km: its density over the distance from the axis, for several constants.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "compiler/sky/inside/plan_inside.h"
#include "compiler/sky/inside/thin_air.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

constexpr double kRamaRadius_m = 8000;
constexpr int kRadii = 33;

/// Density relative to that at the axis.
double relative_density(const sky::Inside& inside, double from_axis_m) {
  const Vec3 axis{0, 0, kRamaRadius_m};
  return sky::density_at(inside, axis - Vec3{0, 0, from_axis_m}) / sky::density_at(inside, axis);
}

/// The largest relative error of column_m() against the sum over a million parts, over rays across the cylinder.
double largest_column_error(const sky::Inside& inside) {
  double largest = 0;
  for (const double angle : {0.1, 0.5, 1.0, 1.5}) {
    const Vec3 direction{0.3 * std::cos(angle), 0.9539392014169457 * std::cos(angle), std::sin(angle)};
    const Vec3 unit_direction = unit(direction);
    constexpr int kParts = 1'000'000;
    const double distance_m = 7000;
    double sum = 0;
    for (int i = 0; i < kParts; ++i)
      sum += sky::density_at(inside, unit_direction * (distance_m * (i + 0.5) / kParts)) * distance_m / kParts;
    largest = std::max(largest, std::abs(sky::column_m(inside, {}, unit_direction, distance_m) / sum - 1));
  }
  return largest;
}

}  // namespace

Result<std::vector<Chart>> chart_air(const ChartRequest&) {
  const std::array<std::pair<const char*, double>, 3> falls = {
      {{"air at 1 g at the ground, as the work derives it", std::log(1.588)},
       {"five times as dense at the ground, as the work chose", sky::kUsualFall},
       {"the work's constant as printed, nu = 1", 16.0}}};
  Chart chart{.name = "air",
              .title = "Density of air inside of a cylinder of 8 km",
              .x = {"distance from the axis (km)"},
              .y = {"density relative to that at the axis", true},
              .series = {}};
  for (const auto& [name, fall] : falls) {
    sky::Inside inside = sky::plan_inside({kRamaRadius_m}, {{-25000, -25000}, {25000, 25000}});
    inside.fall = fall;
    Series series{name, {}};
    for (int i = 0; i < kRadii; ++i) {
      const double from_axis_m = kRamaRadius_m * i / (kRadii - 1);
      series.points.emplace_back(from_axis_m * 1e-3, relative_density(inside, from_axis_m));
    }
    chart.notes.push_back(fmt::format("{}: {:.4g} at the ground; columns within {:.1g}", name,
                                      series.points.back().second, largest_column_error(inside)));
    chart.series.push_back(std::move(series));
  }
  return std::vector{std::move(chart)};
}

}  // namespace citykiln::charts
