#include "preview/light/light_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace citykiln::preview {
namespace {

// Small lights on walls and lamps above streets, all over a town.
std::vector<LightBounds> town_lights(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share;
  std::vector<LightBounds> lights;
  for (int i = 0; i < count; ++i) {
    const Vec3 at{1000 * share(random), 800 * share(random), 15 * share(random)};
    const double turn = 2 * std::numbers::pi * share(random);
    LightBounds light{.low = at, .high = at + Vec3{0.5, 0.5, 1.2}, .axis = {std::cos(turn), std::sin(turn), 0}};
    light.reach_rad = std::numbers::pi / 2, light.flux = i % 50 == 0 ? 0 : 1 + share(random);
    lights.push_back(light);
  }
  return lights;
}

TEST(LightTree, ProbabilitiesAddUpToOne) {
  const std::vector<LightBounds> lights = town_lights(700);
  const LightTree tree(lights);
  for (const Vec3 at : {Vec3{500, 400, 1.5}, Vec3{-50, 30, 0}, Vec3{990, 790, 40}})
    for (const Vec3 normal : {Vec3{}, Vec3{0, 0, 1}, Vec3{1, 0, 0}}) {
      double sum = 0;
      for (std::uint32_t i = 0; i < lights.size(); ++i) sum += tree.probability(i, at, normal);
      // choose() fails where a group may light the place, but none of its lights does
      EXPECT_LE(sum, 1 + 1e-9);
      if (at.x == 500) {
        EXPECT_GT(sum, 0.7);
      }
    }
}

TEST(LightTree, ChoicesHaveTheProbabilitiesStated) {
  const std::vector<LightBounds> lights = town_lights(60);
  const LightTree tree(lights);
  const Vec3 at{500, 400, 1.5}, normal{0, 0, 1};
  std::vector<double> found(lights.size());
  constexpr int kDraws = 200000;
  for (int i = 0; i < kDraws; ++i) {
    const auto chosen = tree.choose(at, normal, (i + 0.5) / kDraws);
    if (!chosen) continue;
    EXPECT_NEAR(chosen->probability, tree.probability(chosen->light, at, normal), 1e-9);
    ++found[chosen->light];
  }
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    EXPECT_NEAR(found[i] / kDraws, tree.probability(i, at, normal), 1e-4) << i;
}

// Every light that shines on a place is found: else it would be missing from pictures.
TEST(LightTree, EveryLightThatShinesOnAPlaceMayBeChosen) {
  const std::vector<LightBounds> lights = town_lights(400);
  const LightTree tree(lights);
  int shining = 0;
  for (const Vec3 at : {Vec3{500, 400, 1.5}, Vec3{20, 780, 8}})
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      const Vec3 middle = (lights[i].low + lights[i].high) * 0.5;
      const bool is_lit = dot(lights[i].axis, at - middle) > 1 && dot(Vec3{0, 0, 1}, middle - at) > 0.5;
      if (lights[i].flux == 0) {
        EXPECT_EQ(tree.probability(i, at, {0, 0, 1}), 0);
      }
      if (!is_lit || lights[i].flux == 0) continue;
      ++shining;
      EXPECT_GT(tree.probability(i, at, {0, 0, 1}), 0) << i;
    }
  EXPECT_GT(shining, 100);
}

// One straight above and one at eye level, as far away: lanterns light the place alike, lamps that shine downwards do
// not.
TEST(LightTree, LanternsAreNoLessLikelyFromTheSide) {
  const Vec3 at{0, 0, 5}, up{0, 0, 1};
  LightBounds above{.low = at + Vec3{0, 0, 8}, .high = at + Vec3{0, 0, 8}, .axis = up * -1};
  above.reach_rad = 2 * std::numbers::pi / 3, above.flux = 1, above.is_even = true;
  LightBounds beside = above;
  beside.low = beside.high = at + Vec3{8, 0, 0.1};
  const std::vector even = {above, beside};
  EXPECT_NEAR(LightTree(even).probability(0, at, {}), 0.5, 1e-3);
  above.is_even = beside.is_even = false;
  const std::vector by_cosine = {above, beside};
  EXPECT_GT(LightTree(by_cosine).probability(0, at, {}), 0.9);
}

// Near lights are preferred: the estimate of the light of all by one choice varies far less than by uniform choice.
TEST(LightTree, VariesLessThanUniformChoice) {
  const std::vector<LightBounds> lights = town_lights(3000);
  const LightTree tree(lights);
  const Vec3 at{500, 400, 0}, normal{0, 0, 1};
  double sum = 0, by_tree = 0, uniform = 0;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const Vec3 to = (lights[i].low + lights[i].high) * 0.5 - at;
    const double d2 = dot(to, to), light = lights[i].flux * std::max(0.0, -dot(lights[i].axis, to)) * to.z / (d2 * d2);
    if (light <= 0) continue;
    sum += light, by_tree += light * light / tree.probability(i, at, normal);
    uniform += light * light * static_cast<double>(lights.size());
  }
  EXPECT_LT((by_tree - sum * sum) * 10, uniform - sum * sum);
}

// The standard deviation of the light that one choice estimates, over the light, for level ground.
double deviation(const std::vector<LightBounds>& lanterns, Vec3 at) {
  const LightTree tree(lanterns);
  double sum = 0, squares = 0;
  for (std::uint32_t i = 0; i < lanterns.size(); ++i) {
    const Vec3 to = lanterns[i].low - at;
    const double light = lanterns[i].flux * to.z / std::pow(dot(to, to), 1.5);
    sum += light, squares += light * light / tree.probability(i, at, {0, 0, 1});
  }
  return std::sqrt(std::max(0.0, squares / (sum * sum) - 1));
}

// A dim lantern next to a place, in a group with bright ones far away.
TEST(LightTree, ANearDimLightIsChosenAsOftenAsItShines) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share;
  double most = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 at{1000 * share(random), 1000 * share(random), 0};
    std::vector<LightBounds> lanterns(2 + i % 62);
    for (LightBounds& lantern : lanterns) {
      const bool is_near = share(random) < 0.1;
      lantern.low = is_near ? at + Vec3{0.1 * share(random), 0.1 * share(random), 0.01 + 0.1 * share(random)}
                            : Vec3{1000 * share(random), 1000 * share(random), 3 + 9 * share(random)};
      lantern.high = lantern.low, lantern.axis = {0, 0, -1}, lantern.reach_rad = std::numbers::pi / 2;
      lantern.flux = std::pow(10, 7 * share(random) - 3), lantern.is_even = true;
    }
    most = std::max(most, deviation(lanterns, at));
  }
  EXPECT_LT(most, 3);
}

TEST(LightTree, WithoutLightsNothingIsChosen) {
  EXPECT_TRUE(LightTree({}).is_empty());
  const std::vector<LightBounds> dark(3);
  EXPECT_FALSE(LightTree(dark).choose({1, 2, 3}, {}, 0.4));
}

}  // namespace
}  // namespace citykiln::preview
