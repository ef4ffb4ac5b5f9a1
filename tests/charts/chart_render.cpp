// Error of rendered pictures over time, against a long reference: how many samples, how many bounces, Russian roulette,
// denoising; and error of light from many lamps, chosen by the light tree or uniformly.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake_scene.h"
#include "preview/picture/denoise.h"
#include "preview/render.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

constexpr double kStreetTolerance_m = 0.5;
constexpr int kReferenceSamples = 1024, kMostSamples = 64;

preview::Options picture_options(const ChartRequest& request) {
  preview::Options options;
  options.width = 320, options.height = 180, options.threads = request.threads, options.has_guides = true;
  return options;
}

/// Root of the mean square of the difference, each pixel relative to the reference's brightness there and on average.
double error_of(const preview::Image& image, const preview::Image& reference) {
  double mean = 0, sum = 0;
  for (const float v : reference.rgb) mean += v / static_cast<double>(reference.rgb.size());
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const double difference = image.rgb[i] - reference.rgb[i], scale = reference.rgb[i] + 0.1 * mean;
    sum += difference * difference / (scale * scale);
  }
  return std::sqrt(sum / static_cast<double>(image.rgb.size()));
}

/// The scene to render: baked tiles in a sky, from a street.
struct Street {
  std::vector<bake::BakedTile> tiles;
  preview::Camera camera;
  preview::Lights lights;

  preview::World world() const { return {tiles, camera.eye}; }
};

Result<Street> bake_street(const ChartRequest& request) {
  const Result<scene::Scene> scene = compile_first_map(request);
  if (!scene) return scene.error();
  std::vector<bake::BakedTile> tiles = bake_tiles(*scene, kStreetTolerance_m, request.threads);
  const Result<preview::Camera> camera = preview::named_view(tiles, "street");
  if (!camera) return camera.error();
  return Street{std::move(tiles), *camera, preview::Lights(sky::generate(scene->header.sky))};
}

/// A way to render, by the name of its series.
struct Way {
  const char* name;
  int bounces = 3;
  double roulette = 0.1;
  bool is_denoised = false;
};

constexpr Way kWays[] = {{.name = "3 bounces, roulette 0.1"},
                         {.name = "1 bounce", .bounces = 1},
                         {.name = "without roulette", .roulette = 0},
                         {.name = "roulette 0.4", .roulette = 0.4},
                         {.name = "denoised", .is_denoised = true}};

/// Lamps along streets 60 m apart, one every 30 m.
std::vector<preview::StreetLamp> lamps_in_streets(int count) {
  const int columns = std::max(1, static_cast<int>(std::sqrt(count * 2.0)));
  std::vector<preview::StreetLamp> lamps;
  for (int i = 0; i < count; ++i) {
    const auto kind = i % 3 != 0 ? props::LampKind::kArm : props::LampKind::kPostTop;
    lamps.push_back({{30.0 * (i % columns), 60.0 * (i / columns), 6}, 6.2f, props::luminaire_of(kind, 6.2)});
  }
  return lamps;
}

/// Errors of both choices, relative to the light of all lamps, for one sample at each of many places.
struct ChoiceErrors {
  double by_tree = 0, uniform = 0;
};

ChoiceErrors errors_of_choices(const preview::World& world, std::span<const preview::StreetLamp> lamps) {
  const preview::LocalLights all(world, lamps, 1);
  std::vector<preview::LocalLights> each;
  for (const preview::StreetLamp& lamp : lamps) each.emplace_back(world, std::span(&lamp, 1), 1);
  const Vec3 up{0, 0, 1}, far = lamps.back().at;
  constexpr int kPlaces = 400;
  ChoiceErrors errors;
  for (std::uint32_t i = 0; i < kPlaces; ++i) {
    const preview::PixelSamples pixel(i, 0, 0, {0, 0});
    const preview::UnitPair place = pixel.pair(0, 30), chance = pixel.pair(0, 31);
    const Vec3 at{place.u * (far.x + 30), place.v * (far.y + 60), 0};
    double sum = 0, squares = 0;
    for (const preview::LocalLights& lamp : each) {
      const auto light = lamp.sample_lamp(at, up, 0.5);
      const double of_lamp = light ? preview::luminance(light->light) * light->direction.z : 0;
      sum += of_lamp, squares += of_lamp * of_lamp;
    }
    if (sum <= 0) continue;
    const auto drawn = all.sample_lamp(at, up, chance.u);
    const double estimate = drawn ? preview::luminance(drawn->light) * drawn->direction.z : 0;
    errors.by_tree += std::pow(estimate / sum - 1, 2) / kPlaces;
    // the exact variance of a uniform choice
    errors.uniform += (squares * static_cast<double>(lamps.size()) / (sum * sum) - 1) / kPlaces;
  }
  return {std::sqrt(errors.by_tree), std::sqrt(errors.uniform)};
}

}  // namespace

Result<std::vector<Chart>> chart_render(const ChartRequest& request) {
  const Result<Street> street = bake_street(request);
  if (!street) return street.error();
  const preview::World world = street->world();
  preview::Options options = picture_options(request);
  preview::Options most = options;
  most.samples = kReferenceSamples, most.roulette = 0, most.seed = 1;
  const preview::Image reference = preview::render(world, street->lights, street->camera, most);
  Chart chart{"render_error",
              "A street, 320 x 180 pixels, against 1024 paths a pixel",
              {"time (s)", true},
              {"relative error", true},
              {}};
  for (const Way& way : kWays) {
    Series series{.name = way.name, .points = {}};
    options.bounces = way.bounces, options.roulette = way.roulette;
    for (options.samples = 1; options.samples <= kMostSamples; options.samples *= 2) {
      const Stopwatch watch;
      preview::Image image = preview::render(world, street->lights, street->camera, options);
      if (way.is_denoised) image = preview::denoise(image, request.threads);
      series.points.emplace_back(watch.seconds(), error_of(image, reference));
    }
    chart.series.push_back(std::move(series));
  }
  return std::vector{std::move(chart)};
}

Result<std::vector<Chart>> chart_lights(const ChartRequest&) {
  const preview::World empty(std::span<const bake::BakedTile>(), {});
  Chart chart{"lights_error",
              "Light of many lamps by one of them, 400 places in their streets",
              {"lamps", true},
              {"relative error of one sample", true},
              {}};
  Series tree{.name = "light tree", .points = {}}, uniform{.name = "uniform choice", .points = {}};
  for (const int count : {2, 10, 50, 200, 1000, 5000}) {
    const std::vector<preview::StreetLamp> lamps = lamps_in_streets(count);
    const ChoiceErrors errors = errors_of_choices(empty, lamps);
    tree.points.emplace_back(count, errors.by_tree), uniform.points.emplace_back(count, errors.uniform);
  }
  chart.series = {std::move(tree), std::move(uniform)};
  return std::vector{std::move(chart)};
}

}  // namespace citykiln::charts
