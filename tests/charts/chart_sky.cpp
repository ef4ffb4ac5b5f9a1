#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/sky/generate.h"
#include "tests/charts/chart.h"
#include "tests/charts/preetham.h"
#include "tests/charts/sky_reference.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// At twilight few paths find light.
int paths_for(double height_deg) { return height_deg > 0 ? 4000 : 20000; }

// A sun in the east.
sky::Sky sky_at(double height_deg) {
  sky::Sky sky;
  sky.to_sun = {std::cos(height_deg * kDegree), 0, std::sin(height_deg * kDegree)};
  return sky;
}

Chart vertical_of(double height_deg, int threads) {
  const sky::Sky sky = sky_at(height_deg);
  const sky::SkyModel model = sky::generate(sky);
  const PreethamSky preetham = preetham_sky(sky.to_sun, sky.turbidity);
  Chart chart{fmt::format("sky_{}{}", height_deg < 0 ? "minus" : "", std::abs(height_deg)),
              fmt::format("The sky along the sun's vertical, sun at {} degrees", height_deg),
              {"degrees from the horizon below the sun, over the zenith"},
              {"luminance (kcd/m2)", true},
              {}};
  Series ours{.name = "citykiln", .points = {}}, theirs{.name = "Preetham", .points = {}};
  const auto at = [](double deg) { return Vec3{std::cos(deg * kDegree), 0, std::sin(deg * kDegree)}; };
  for (int deg = 1; deg < 180; ++deg) {
    ours.points.emplace_back(deg, luminance(model.domes.front()->radiance(at(deg))));
    theirs.points.emplace_back(deg, luminance(radiance(preetham, at(deg))));
  }
  Series reference{
      .name = "spectral Monte Carlo", .points = std::vector<std::pair<double, double>>(36), .is_reference = true};
  for_each_index(reference.points.size(), threads, [&](std::size_t i) {
    const double deg = 2.5 + 5 * static_cast<double>(i);
    const sky::Rgb light = reference_radiance(air_of(sky), sky.to_sun, at(deg), paths_for(height_deg));
    reference.points[i] = {deg, luminance(light)};
  });
  chart.series = {std::move(ours), std::move(theirs), std::move(reference)};
  return chart;
}

Chart errors_chart(int threads) {
  Chart chart{"sky_error",
              "Error of the sky's luminance in 54 directions",
              {"height of the sun (degrees)"},
              {"relative error", true},
              {}};
  Series median{.name = "median", .points = {}}, most{.name = "95th percentile", .points = {}};
  for (const double height_deg : {-3.0, 0.0, 5.0, 20.0, 60.0}) {
    const std::vector<double> errors = sky_errors(sky_at(height_deg), 9, paths_for(height_deg), threads);
    median.points.emplace_back(height_deg, errors[errors.size() / 2]);
    most.points.emplace_back(height_deg, errors[errors.size() * 95 / 100]);
  }
  chart.series = {std::move(median), std::move(most)};
  return chart;
}

Chart time_chart() {
  Chart chart{"sky_time", "Time to prepare a sky, one thread", {"height of the sun (degrees)"}, {"time (s)"}, {}};
  Series time{.name = "citykiln", .points = {}};
  for (const double height_deg : {-15.0, -6.0, -3.0, 0.0, 5.0, 20.0, 60.0}) {
    const Stopwatch watch;
    const sky::SkyModel model = sky::generate(sky_at(height_deg));
    time.points.emplace_back(height_deg, watch.seconds());
  }
  chart.series = {std::move(time)};
  return chart;
}

}  // namespace

Result<std::vector<Chart>> chart_sky(const ChartRequest& request) {
  std::vector<Chart> charts;
  for (const double height_deg : {60.0, 20.0, 5.0, -3.0}) charts.push_back(vertical_of(height_deg, request.threads));
  charts.push_back(errors_chart(request.threads));
  charts.push_back(time_chart());
  return charts;
}

}  // namespace citykiln::charts
