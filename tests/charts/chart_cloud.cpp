// Clouds: particles against the errors of optical depth and of radiance, and the time of both ways to light them.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "compiler/contract/random_sequence.h"
#include "preview/clouds/cloud_paths.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

constexpr sky::CloudLayer kLayer = {sky::CloudKind::kCumulus, 0.4, 1500, 2300, {5, 2}, 7};
constexpr Box2 kField = {{-9000, -9000}, {9000, 9000}};
constexpr double kFinestStep_m = 12, kFar_m = std::numeric_limits<double>::infinity();
constexpr int kRays = 10000, kClouds = 3;

const preview::CloudLight kLight = {
    .to_sun = unit(Vec3{1, 0, 1}), .sun = {3, 3, 3}, .sky = {0.2, 0.2, 0.2}, .ground = {0.1, 0.1, 0.1}};

struct Random {
  RandomSequence draw;
  std::uint32_t next = 0;
  double operator()() { return draw.unit(next++); }
};

Chart depth_chart(std::span<const sky::Cloud> clouds) {
  Chart chart{"cloud_depth",
              "Optical depth of three cumulus clouds, against particles down to 12 m",
              {"particles", true},
              {"largest error of optical depth, of 10,000 rays", true},
              {}};
  for (std::size_t c = 0; c < clouds.size(); ++c) {
    Series series{.name = fmt::format("cloud {}", c + 1), .points = {}},
        stated{.name = fmt::format("cloud {}, stated", c + 1), .points = {}};
    for (const double coarse_m : {200.0, 120.0, 80.0, 50.0, 30.0, 20.0}) {
      const sky::CloudParticles coarse = sky::generate_cloud(kLayer, clouds[c], coarse_m);
      const auto particles = static_cast<double>(coarse.spheres.size());
      stated.points.emplace_back(particles, coarse.depth_error);
      series.points.emplace_back(particles,
                                 sky::optical_depth_error(kLayer, clouds[c], coarse_m, kFinestStep_m, kRays));
    }
    chart.series.push_back(std::move(series)), chart.series.push_back(std::move(stated));
  }
  return chart;
}

// A cloud's mean light towards an eye 3 km away, and the time of a ray.
struct Seen {
  double light = 0, seconds = 0;
};

template <typename Light>
Seen seen_of(const sky::Cloud& cloud, double turn, int rays, Light light) {
  const Vec3 middle = sky::frame_of(kLayer).out_of(at_height(cloud.centre, cloud.height_m * 0.4));
  const Vec3 eye = middle + Vec3{std::cos(turn), std::sin(turn), -0.3} * 3000;
  Seen seen;
  const Stopwatch watch;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rays); ++i) {
    const RandomSequence draw(3, StableId{i}, "ray");
    const auto off = [&](std::uint32_t n) { return draw.between(-0.6, 0.6, n) * cloud.radius_m; };
    seen.light += light(eye, unit(middle + Vec3{off(0), off(1), off(2) / 2} - eye), i) / rays;
  }
  seen.seconds = watch.seconds() / rays;
  return seen;
}

// The cost of a path for a relative standard error of 1 %, which is some 10,000 times that of one path.
constexpr double kPathsForOnePercent = 1e4;

void add_light(const sky::Cloud& cloud, const std::string& name, Chart& ratios, Chart& times) {
  const std::vector<sky::CloudParticle> spheres = sky::generate_cloud(kLayer, cloud, kFar_m).spheres;
  const preview::CloudField field(kLayer, spheres, kLight, preview::CloudEdges::kBillowed);
  Series ratio{.name = name, .points = {}}, single{.name = fmt::format("{}, scattered once", name), .points = {}},
      time{.name = name, .points = {}};
  for (int side = 0; side < 8; ++side) {
    const double turn = side * 0.7853981633974483;
    const auto path = [&](int most) {
      return [&, most](Vec3 eye, Vec3 along, std::uint32_t i) {
        return preview::cloud_path(field, eye, along, kFar_m, most, Random{{9, StableId{i}, "path"}}).added[1];
      };
    };
    const auto fast = [&](Vec3 eye, Vec3 along, std::uint32_t) { return field.along(eye, along, kFar_m).added[1]; };
    const Seen reference = seen_of(cloud, turn, 2000, path(1000)), once = seen_of(cloud, turn, 2000, path(1)),
               ours = seen_of(cloud, turn, 2000, fast);
    ratio.points.emplace_back(45 * side, ours.light / reference.light);
    single.points.emplace_back(45 * side, once.light / reference.light);
    time.points.emplace_back(45 * side, reference.seconds * kPathsForOnePercent / ours.seconds);
  }
  ratios.series.push_back(std::move(ratio)), ratios.series.push_back(std::move(single));
  times.series.push_back(std::move(time));
}

}  // namespace

Result<std::vector<Chart>> chart_cloud(const ChartRequest&) {
  std::vector<sky::Cloud> clouds = sky::clouds_in(kLayer, kField);
  clouds.resize(std::min<std::size_t>(clouds.size(), kClouds));
  std::vector<Chart> charts = {depth_chart(clouds)};
  Chart ratios{"cloud_light",
               "Light of clouds over that of paths with all orders of scattering, sun at 45 degrees",
               {"degrees of the eye from the sun's azimuth"},
               {"ratio"},
               {}};
  Chart times{"cloud_time",
              "Time of paths (1 % of noise) over the time of one lookup",
              {"degrees of the eye from the sun's azimuth"},
              {"ratio", true},
              {}};
  for (std::size_t c = 0; c < clouds.size(); ++c) add_light(clouds[c], fmt::format("cloud {}", c + 1), ratios, times);
  charts.push_back(std::move(ratios)), charts.push_back(std::move(times));
  return charts;
}

}  // namespace citykiln::charts
