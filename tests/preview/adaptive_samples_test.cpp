#include "preview/adaptive_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "preview/render.h"
#include "tests/preview/solids.h"
#include "tests/test_files.h"

namespace citykiln::preview {
namespace {

using materials::Material;

TEST(SamplePlan, PilotIsAQuarterAndAtMostSixteen) {
  EXPECT_EQ(plan_samples(64, 0.1).pilot, 16);
  EXPECT_EQ(plan_samples(4096, 0.1).pilot, 16);
  EXPECT_EQ(plan_samples(20, 0.1).pilot, 5);
  EXPECT_EQ(plan_samples(7, 0.1).pilot, 0);
  EXPECT_EQ(plan_samples(64, 0).pilot, 0);
}

// The weights of pilot and further samples give the variance that was asked for, just so.
TEST(FurtherSamples, AreAsManyAsTheErrorNeeds) {
  const SamplePlan plan = plan_samples(1024, 0.05);
  for (const double variance : {0.1, 0.3, 1.0}) {
    const int count = further_samples(plan, {1, variance}, 1, 0.05);
    const double w = plan.pilot_weight();
    const auto error = [&](int n) { return std::sqrt(variance * (w * w / plan.pilot + (1 - w) * (1 - w) / n)); };
    EXPECT_LE(error(count), 0.05 * (1 + 1e-12)) << variance;
    EXPECT_GT(error(count - 1), 0.05) << variance;
  }
}

TEST(FurtherSamples, AreAtLeastThePilotAndAtMostTheRest) {
  const SamplePlan plan = plan_samples(64, 0.05);
  EXPECT_EQ(further_samples(plan, {1, 0}, 1, 0.05), 16);
  EXPECT_EQ(further_samples(plan, {0, 0}, 0, 0.05), 16);
  EXPECT_EQ(further_samples(plan, {1, 1e6}, 1, 0.05), 48);
  EXPECT_EQ(further_samples(plan, {0, 1}, 0, 0.05), 48);
}

// Grass under the sky, and a dark passage into which little light falls.
bake::BakedTile passage() {
  return tile({},
              {floor({-60, -60, 0}, {60, 60, 0}, Material::kGrass), box({-9, 8, 0}, {-3, 40, 7}, Material::kPlaster),
               box({3, 8, 0}, {9, 40, 7}, Material::kPlaster), box({-3, 10, 3}, {3, 40, 4}, Material::kStone)});
}

struct Halves {
  double left = 0, right = 0;
};

Halves means_of(const Image& image) {
  Halves sums;
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    (static_cast<int>(i / 3) % image.width < image.width / 2 ? sums.left : sums.right) += image.rgb[i];
  return {2 * sums.left / static_cast<double>(image.rgb.size()),
          2 * sums.right / static_cast<double>(image.rgb.size())};
}

// Student's t of the means of two lists (Welch 1947).
double welch_t_of(const std::vector<double>& a, const std::vector<double>& b) {
  const auto moments = [](const std::vector<double>& v) {
    double mean = 0, squares = 0;
    for (const double x : v) mean += x / static_cast<double>(v.size());
    for (const double x : v) squares += (x - mean) * (x - mean) / static_cast<double>(v.size() - 1);
    return std::pair(mean, squares / static_cast<double>(v.size()));
  };
  const auto [mean_a, variance_a] = moments(a);
  const auto [mean_b, variance_b] = moments(b);
  return (mean_a - mean_b) / std::sqrt(variance_a + variance_b);
}

TEST(AdaptiveSampling, HasNoBias) {
  const std::vector tiles = {passage()};
  const sky::Sky sky{{}, unit(Vec3{-0.5, -0.4, 0.7}), 2.6};
  const Camera camera{{0, 2, 1.6}, {12, 20, 6}, 50};
  Options options;
  options.width = 64, options.height = 32, options.samples = 32;
  const World world(tiles, camera.eye);
  const Lights lights(sky::generate(sky));
  std::vector<double> fixed_left, fixed_right, adapted_left, adapted_right;
  bool adapts = false;
  for (std::uint64_t seed = 0, seeds = quick_or_full(24, 64); seed < seeds; ++seed) {
    options.seed = 2 * seed, options.noise = 0, options.samples = 16;
    const Halves fixed = means_of(render(world, lights, camera, options));
    options.seed = 2 * seed + 1, options.noise = 0.05, options.samples = 64;
    const Image image = render(world, lights, camera, options);
    adapts |= image.statistics.least_samples < image.statistics.most_samples;
    const Halves adapted = means_of(image);
    fixed_left.push_back(fixed.left), fixed_right.push_back(fixed.right);
    adapted_left.push_back(adapted.left), adapted_right.push_back(adapted.right);
  }
  EXPECT_TRUE(adapts);
  // 99.9 % of Student's t with some 100 degrees of freedom, two-sided; with 40 it is 3.55
  EXPECT_LT(std::abs(welch_t_of(fixed_left, adapted_left)), 3.4);
  EXPECT_LT(std::abs(welch_t_of(fixed_right, adapted_right)), 3.4);
}

TEST(AdaptiveSampling, AnyNumberOfThreadsIsTheSamePicture) {
  const std::vector tiles = {passage()};
  const sky::Sky sky{{}, unit(Vec3{-0.5, -0.4, 0.7}), 2.6};
  Options options;
  options.width = 70, options.height = 50, options.samples = 32, options.noise = 0.2, options.has_guides = true;
  options.threads = 1;
  const Image one = render(tiles, sky, {{0, 2, 1.6}, {0, 20, 2}, 50}, options);
  options.threads = 3;
  const Image other = render(tiles, sky, {{0, 2, 1.6}, {0, 20, 2}, 50}, options);
  EXPECT_EQ(one.rgb, other.rgb);
  EXPECT_EQ(one.samples, other.samples);
  EXPECT_EQ(one.guides.variance, other.guides.variance);
}

}  // namespace
}  // namespace citykiln::preview
