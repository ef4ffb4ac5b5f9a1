// Techniques that save time do not change the light that is found: means over many seeds agree.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "preview/path_trace.h"
#include "preview/render.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;

constexpr int kSeeds = 64;
// Student's t for 63 degrees of freedom, two-sided 99.9 %
constexpr double kLimit = 3.45;

// A street: houses in the sun and in the shade, water, a wall that shines.
bake::BakedTile street() {
  return tile(
      {}, {floor({-30, -30, 0}, {30, 8, 0}, Material::kConcrete),
           floor({-30, 8, -0.3}, {30, 30, -0.3}, Material::kWater), box({-20, -12, 0}, {-6, -2, 9}, Material::kPlaster),
           box({4, -20, 0}, {16, -4, 14}, Material::kBrick), box({-3, -1, 1}, {1, 0, 2.5}, Material::kOfficeCeiling)});
}

const Camera kCamera{{14, 22, 6}, {-2, -3, 2}, 50};

double mean_of_image(const Image& image) {
  double sum = 0;
  for (const float v : image.rgb) sum += v;
  return sum / static_cast<double>(image.rgb.size());
}

// Student's t of the difference of two estimates, seed by seed.
double paired_t_of(const std::function<double(std::uint64_t)>& one, const std::function<double(std::uint64_t)>& other) {
  double sum = 0, squares = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const double difference = one(seed) - other(seed + 1000);
    sum += difference, squares += difference * difference;
  }
  const double mean = sum / kSeeds, variance = (squares - kSeeds * mean * mean) / (kSeeds - 1);
  return mean / std::sqrt(variance / kSeeds);
}

// The scene for rays, made once for all pictures.
struct Made {
  bake::BakedTile tile = street();
  World world{std::span(&tile, 1), kCamera.eye};
  Lights lights;
  LocalLights local;

  explicit Made(Vec3 to_sun) : lights(sky::generate({{}, unit(to_sun), 2.6})), local(world, {}, 1) {}
  double mean(const Options& options, std::uint64_t seed) const {
    Options own = options;
    own.seed = seed;
    return mean_of_image(render(world, lights, local, kCamera, own));
  }
};

Options options_without_roulette() {
  Options options;
  options.width = 24, options.height = 16, options.samples = 16, options.bounces = 4, options.has_caustics = true;
  options.roulette = 0;
  return options;
}

TEST(Unbiased, RouletteEndsPathsWithoutLosingLight) {
  for (const Vec3 to_sun : {Vec3{-0.5, 0.6, 0.6}, Vec3{0, -0.9, -0.4}}) {
    const Made made(to_sun);
    Options roulette = options_without_roulette();
    roulette.roulette = 0.8;
    const double t = paired_t_of([&](std::uint64_t seed) { return made.mean(roulette, seed); },
                                 [&](std::uint64_t seed) { return made.mean(options_without_roulette(), seed); });
    EXPECT_LT(std::abs(t), kLimit) << to_sun.z;
  }
}

TEST(Unbiased, AdaptiveSamplesFindTheSameLight) {
  const Made made({-0.5, 0.6, 0.6});
  Options adaptive = options_without_roulette();
  adaptive.samples = 64, adaptive.noise = 0.1;
  const double t = paired_t_of([&](std::uint64_t seed) { return made.mean(adaptive, seed); },
                               [&](std::uint64_t seed) { return made.mean(options_without_roulette(), seed); });
  EXPECT_LT(std::abs(t), kLimit);
}

// The mean radiance that a matt place sends up, with and without sampling of the lights that it sees.
TEST(Unbiased, SampledEmittersAreAsBrightAsThoseFoundByChance) {
  bake::BakedTile room = tile(
      {}, {floor({-9, -9, 0}, {9, 9, 0}, Material::kConcrete), box({-2, -1, 2}, {1, 1, 3}, Material::kOfficeCeiling)});
  const World world(std::span(&room, 1), {});
  const Lights dark(sky::generate({{}, unit(Vec3{0, -0.5, -0.9}), 2.6}));
  const LocalLights local(world, {}, 1);
  ASSERT_TRUE(local.has_emitters());
  ASSERT_EQ(world.emitters().size(), 12u);
  const auto light_at = [&](int bounces, std::uint64_t seed) {
    const TraceContext context{.world = world, .lights = dark, .local = local, .bounces = bounces, .roulette = 0};
    constexpr int kSamples = 256;
    const PixelSamples pixel(seed, 0, 0, grid_of(1, 1, kSamples));
    double sum = 0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      PathDraw draw(pixel, i);
      sum += trace(context, {4, 0.5, 1}, unit(Vec3{-2.5, -0.2, -1}), draw).light[1];
    }
    return sum / kSamples;
  };
  // without a bounce there are shadow rays alone; with one, rays that find the lights by chance are combined with them.
  // The box's sides do not see each other, and the sky is dark: both are the same light
  const auto direct = [&](std::uint64_t seed) { return light_at(0, seed); };
  const auto combined = [&](std::uint64_t seed) { return light_at(1, seed); };
  EXPECT_GT(direct(0), 0);
  EXPECT_LT(std::abs(paired_t_of(direct, combined)), kLimit);
}

// Candela over the square of the distance, times cosine and reflectance.
TEST(Unbiased, ALampLightsTheStreetByItsLumen) {
  bake::BakedTile ground = tile({}, {floor({-50, -50, 0}, {50, 50, 0}, Material::kAsphalt)});
  const World world(std::span(&ground, 1), {});
  const StreetLamp lamp{{0, 0, 8}, 8.2f, props::luminaire_of(props::LampKind::kArm, 8.2)};
  const LocalLights local(world, std::span(&lamp, 1), 1);
  for (const double away : {0.0, 3.0, 12.0}) {
    const auto light = local.sample_lamp({away, 0, 0}, {0, 0, 1}, 0.5);
    ASSERT_TRUE(light);
    const double d2 = away * away + 64, cosine = 8 / std::sqrt(d2);
    // 6500 lm into a cosine lobe, 3500 K
    const double candela = 6500 / std::numbers::pi * cosine / 6250;
    EXPECT_NEAR(luminance(light->light), candela / d2, 0.01 * candela / d2) << away;
  }
  // nothing above the lamp
  EXPECT_FALSE(local.sample_lamp({1, 0, 9}, {0, 0, -1}, 0.5));
}

}  // namespace
}  // namespace citykiln::preview
