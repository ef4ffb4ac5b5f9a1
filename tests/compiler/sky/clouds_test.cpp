// Clouds: their cover, their particles at several tolerances, and files of layers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/sky/clouds/generate_cloud.h"
#include "compiler/sky/clouds/read_clouds.h"
#include "tests/scratch_folder.h"

namespace citykiln::sky {
namespace {

constexpr Box2 kField = {{-12000, -12000}, {12000, 12000}};

CloudLayer layer_of(CloudKind kind, double cover) { return {kind, cover, 1500, 2300, {3, 4}, 7}; }

// The share of vertical rays that meet cloud of an optical depth above 0.1.
double covered(const CloudLayer& layer) {
  const LayerFrame frame = frame_of(layer);
  const std::vector<Cloud> clouds = clouds_in(layer, kField);
  std::vector<CloudParticles> particles;
  for (const Cloud& cloud : clouds) particles.push_back(generate_cloud(layer, cloud, cloud.radius_m / 5));
  constexpr int kRays = 2000;
  int met = 0;
  for (std::uint32_t i = 0; i < kRays; ++i) {
    const RandomSequence draw(1, StableId{i}, "ray");
    const Vec3 from = frame.into({draw.between(-8000, 8000, 0), draw.between(-8000, 8000, 1), 0});
    const Vec3 up = frame.into_direction({0, 0, 1});
    bool is_met = false;
    for (std::size_t c = 0; c < clouds.size() && !is_met; ++c)
      is_met = distance(clouds[c].centre, in_plan(from)) < 2 * clouds[c].radius_m + clouds[c].height_m &&
               optical_depth(layer.kind, particles[c], from, up) > 0.1;
    met += is_met ? 1 : 0;
  }
  return static_cast<double>(met) / kRays;
}

TEST(Clouds, CoverTheShareOfTheSkyThatIsAskedFor) {
  for (const double cover : {0.15, 0.4, 0.7})
    EXPECT_NEAR(covered(layer_of(CloudKind::kCumulus, cover)), cover, 0.1) << cover;
  EXPECT_GT(covered(layer_of(CloudKind::kStratus, 1)), 0.95);
  EXPECT_EQ(clouds_in(layer_of(CloudKind::kCumulus, 0), kField).size(), 0U);
}

TEST(Clouds, DoNotDependOnTheBoxThatIsAskedFor) {
  const CloudLayer layer = layer_of(CloudKind::kCumulus, 0.4);
  const std::vector<Cloud> all = clouds_in(layer, kField), few = clouds_in(layer, {{-3000, -2000}, {4000, 5000}});
  ASSERT_GT(few.size(), 5U);
  EXPECT_LT(few.size(), all.size());
  for (const Cloud& cloud : few)
    EXPECT_TRUE(std::ranges::any_of(all, [&](const Cloud& other) {
      return other.id == cloud.id && other.centre == cloud.centre && other.radius_m == cloud.radius_m;
    }));
}

TEST(Clouds, CoarserOnesLackTheSmallestParticlesAlone) {
  const CloudLayer layer = layer_of(CloudKind::kCumulus, 0.4);
  const Cloud cloud = clouds_in(layer, kField).front();
  const CloudParticles fine = generate_cloud(layer, cloud, 8), coarse = generate_cloud(layer, cloud, 60);
  ASSERT_GT(fine.spheres.size(), 2 * coarse.spheres.size());
  ASSERT_GT(coarse.spheres.size(), 20U);
  for (const CloudParticle& sphere : coarse.spheres)
    EXPECT_TRUE(std::ranges::any_of(fine.spheres, [&](const CloudParticle& other) {
      return other.centre == sphere.centre && other.radius_m == sphere.radius_m;
    }));
  for (const CloudParticle& sphere : fine.spheres)
    EXPECT_LE(sphere.centre.z + sphere.radius_m, frame_of(layer).height_m * 1.05);
}

// A ray through the middle of a lone sphere, and one beside it.
TEST(Clouds, OpticalDepthOfASphereIsItsChord) {
  const CloudParticles one{.spheres = {{{0, 0, 500}, 100}}, .finest_m = 1};
  const double extinction = extinction_per_m(CloudKind::kCumulus);
  EXPECT_NEAR(optical_depth(CloudKind::kCumulus, one, {-1000, 0, 500}, {1, 0, 0}), 200 * extinction, 1e-9);
  EXPECT_NEAR(optical_depth(CloudKind::kCumulus, one, {-1000, 60, 500}, {1, 0, 0}), 160 * extinction, 1e-9);
  EXPECT_EQ(optical_depth(CloudKind::kCumulus, one, {-1000, 101, 500}, {1, 0, 0}), 0);
  // nothing is below the base
  const CloudParticles half{.spheres = {{{0, 0, 0}, 100}}, .finest_m = 1};
  EXPECT_NEAR(optical_depth(CloudKind::kCumulus, half, {0, 0, -1000}, {0, 0, 1}), 100 * extinction, 1e-9);
}

TEST(Clouds, OpticalDepthOfALevelIsWithinItsStatedError) {
  const CloudLayer layer = layer_of(CloudKind::kCumulus, 0.4);
  const std::vector<Cloud> clouds = clouds_in(layer, kField);
  ASSERT_GT(clouds.size(), 6U);
  double largest_share = 0;
  for (std::size_t c = 0; c < 6; ++c)
    for (const double coarse_m : {200.0, 100.0, 50.0}) {
      const CloudParticles coarse = generate_cloud(layer, clouds[c], coarse_m);
      const double error = optical_depth_error(layer, clouds[c], coarse_m, 12, c == 0 ? 10000 : 1000);
      EXPECT_LE(error, coarse.depth_error) << coarse_m;
      if (coarse.depth_error > 0) largest_share = std::max(largest_share, error / coarse.depth_error);
    }
  // the statement is not far from what is found
  EXPECT_GT(largest_share, 0.3);
  EXPECT_EQ(generate_cloud(layer, clouds[0], 1e-6).depth_error, 0);
}

std::string refusal(const std::string& text) {
  const ScratchFolder folder;
  const auto layers = read_clouds(folder.write("clouds.json", text));
  return layers ? "" : layers.error().message;
}

TEST(Clouds, NamesAndFilesGiveLayers) {
  EXPECT_EQ(read_clouds("clear")->size(), 0U);
  EXPECT_EQ(requested_clouds(*read_clouds("fair"), 100.4, 0).front().base_m, 1350);
  EXPECT_EQ(refusal(R"({"layers": [{"kind": "cumulus", "cover": 0.4, "base": 900, "top": 1500, "wind": [1, 2]}]})"),
            "");
  EXPECT_NE(refusal("{").find("expected {"), std::string::npos);
  EXPECT_NE(refusal(R"({"layers": [{"kind": "fog"}]})").find("layer 1: \"kind\""), std::string::npos);
  EXPECT_NE(refusal(R"({"layers": [{"kind": "cirrus", "hight": 1}]})").find("unknown key \"hight\""),
            std::string::npos);
  EXPECT_NE(refusal(R"({"layers": [{"kind": "cirrus", "base": 3000, "top": 2000}]})").find("layer 1: expected a cover"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"layers": [{"kind": "cirrus", "cover": 1e999}]})"), "");
  EXPECT_FALSE(read_clouds("none.json"));
}

TEST(Clouds, LayersOfAFileHaveTheGivenSeedUnlessTheyStateOne) {
  const ScratchFolder folder;
  const std::string path =
      folder.write("clouds.json", R"({"layers": [{"kind": "cumulus"}, {"kind": "stratus", "seed": 3}]})");
  const auto requests = read_clouds(path);
  ASSERT_TRUE(requests && requests->size() == 2);
  const std::vector<CloudLayer> layers = requested_clouds(*requests, 100, 7);
  EXPECT_EQ(layers.front().seed, 7U);
  EXPECT_EQ(layers.back().seed, 3U);
  EXPECT_EQ(layers.front().base_m, CloudLayer{}.base_m);
}

}  // namespace
}  // namespace citykiln::sky
