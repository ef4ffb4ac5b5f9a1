// Clouds over an extent, as meshes and as voxels.
#include "compiler/sky/clouds/clouds_over.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/contract/random_sequence.h"
#include "compiler/sky/clouds/cloud_surface.h"
#include "compiler/sky/clouds/cloud_voxels.h"

namespace citykiln::sky {
namespace {

constexpr CloudLayer kCumulus = {CloudKind::kCumulus, 0.4, 1500, 2300, {3, 4}, 7};
constexpr CloudLayer kCirrus = {CloudKind::kCirrus, 0.4, 8000, 8600, {20, 5}, 7};
constexpr Box2 kExtent = {{-500, -500}, {500, 500}};

std::vector<LayerParticles> particles_of(const CloudLayer& layer, int threads = 2) {
  return clouds_over(std::span(&layer, 1), kExtent, 40, threads);
}

// Less than 0 inside, in the layer's frame.
double distance_to(const LayerParticles& particles, Vec3 own) {
  double nearest = 1e9;
  for (const CloudParticle& sphere : particles.spheres)
    nearest = std::min(nearest, length(own - sphere.centre) - sphere.radius_m);
  return std::max(nearest, -own.z);
}

TEST(CloudsOver, AreThoseWithinTheMargin) {
  const auto layers = particles_of(kCumulus);
  ASSERT_EQ(layers.size(), 1U);
  EXPECT_GE(layers[0].clouds, clouds_in(kCumulus, kExtent.widened(kCloudMargin_m)).size());
  EXPECT_LE(layers[0].clouds, clouds_in(kCumulus, kExtent.widened(kCloudMargin_m + 1000)).size());
  EXPECT_GT(layers[0].clouds, 20U);
  // streaks of 20 km and more
  EXPECT_GT(particles_of(kCirrus)[0].clouds, clouds_in(kCirrus, kExtent.widened(kCloudMargin_m)).size());
}

TEST(CloudsOver, MillionsOfThemAreLimitedToTheMiddle) {
  const CloudLayer thin = {CloudKind::kCumulus, 1, 1500, 1520, {}, 1};
  const Box2 all = kExtent.widened(40000), some = within_limit(thin, all);
  EXPECT_LT(some.width(), all.width() / 5);
  const std::size_t count = clouds_in(thin, some).size();
  EXPECT_LE(count, kMostClouds * 1.05);
  EXPECT_GT(count, kMostClouds * 0.9);
  EXPECT_EQ(within_limit(kCumulus, kExtent), kExtent);
}

// The volume of the particles above the base, in the frame, by random points of a box.
double volume_m3(const LayerParticles& particles) {
  Vec3 low{1e9, 1e9, 0}, high{-1e9, -1e9, 0};
  for (const auto& [centre, radius_m] : particles.spheres) {
    low = {std::min(low.x, centre.x - radius_m), std::min(low.y, centre.y - radius_m), 0};
    high = {std::max(high.x, centre.x + radius_m), std::max(high.y, centre.y + radius_m),
            std::max(high.z, centre.z + radius_m)};
  }
  const RandomSequence draw(5, StableId{1}, "points");
  constexpr std::uint32_t kPoints = 20000;
  int inside = 0;
  for (std::uint32_t i = 0; i < kPoints; ++i)
    inside += distance_to(particles, {draw.between(low.x, high.x, 3 * i), draw.between(low.y, high.y, 3 * i + 1),
                                      draw.between(low.z, high.z, 3 * i + 2)}) < 0;
  return (high.x - low.x) * (high.y - low.y) * high.z * inside / kPoints;
}

LayerParticles one_cloud(const CloudLayer& layer) {
  LayerParticles particles{.layer = layer, .frame = frame_of(layer), .spheres = {}, .clouds = 1};
  const Cloud cloud = clouds_in(layer, {{-20000, -20000}, {20000, 20000}}).front();
  particles.spheres = generate_cloud(layer, cloud, 60).spheres;
  return particles;
}

TEST(CloudSurfaces, AreClosedAcrossParts) {
  for (const CloudLayer& layer : {kCumulus, kCirrus}) {
    const std::vector<CloudSurface> parts = cloud_surfaces(particles_of(layer)[0], 100, 2);
    ASSERT_GT(parts.size(), 1U);
    std::map<std::pair<Vec3, Vec3>, int> edges;
    for (const CloudSurface& part : parts)
      for (const auto& triangle : part.triangles)
        for (std::size_t i = 0; i < 3; ++i)
          ++edges[{part.positions[triangle[i]], part.positions[triangle[(i + 1) % 3]]}];
    ASSERT_GT(edges.size(), 10000U);
    for (const auto& [edge, count] : edges) {
      const auto back = edges.find({edge.second, edge.first});
      ASSERT_TRUE(back != edges.end() && back->second == count);
    }
  }
}

TEST(CloudSurfaces, AreNearTheParticlesAndFaceOutwards) {
  for (const CloudLayer& layer : {kCumulus, kCirrus}) {
    const LayerParticles particles = one_cloud(layer);
    double volume = 0;
    for (const CloudSurface& part : cloud_surfaces(particles, 40, 1)) {
      for (std::size_t v = 0; v < part.positions.size(); ++v) {
        const Vec3 own = particles.frame.into(part.positions[v]);
        EXPECT_LE(std::abs(distance_to(particles, own)), 40 * std::sqrt(3.0));
        EXPECT_NEAR(length(part.normals[v]), 1, 1e-9);
        EXPECT_TRUE(part.opacity[v] >= 0 && part.opacity[v] <= 1);
      }
      for (const auto& [a, b, c] : part.triangles)
        volume += dot(part.positions[a], cross(part.positions[b], part.positions[c])) / 6;
    }
    const double expected = volume_m3(particles) * particles.frame.stretch * particles.frame.flatten;
    EXPECT_NEAR(volume / expected, 1, 0.06) << name_of(layer.kind);
  }
}

TEST(CloudSurfaces, AreTheSameForAnyNumberOfThreads) {
  const auto one = cloud_surfaces(particles_of(kCumulus, 1)[0], 80, 1),
             seven = cloud_surfaces(particles_of(kCumulus, 7)[0], 80, 7);
  ASSERT_EQ(one.size(), seven.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].positions, seven[i].positions);
    EXPECT_EQ(one[i].triangles, seven[i].triangles);
  }
}

TEST(CloudVoxels, HoldTheExtinctionOfTheParticles) {
  for (const CloudLayer& layer : {kCumulus, kCirrus}) {
    const LayerParticles particles = one_cloud(layer);
    const CloudVoxels voxels = cloud_voxels(std::span(&particles, 1), {0, 0, 0}, 30);
    double sum = 0, most = 0;
    for (const VoxelBlock& block : voxels.blocks)
      for (const float extinction : block.extinction) sum += extinction, most = std::max<double>(most, extinction);
    const double expected = volume_m3(particles) * particles.frame.stretch * particles.frame.flatten;
    EXPECT_NEAR(sum * 30 * 30 * 30 / extinction_per_m(layer.kind) / expected, 1, 0.06) << name_of(layer.kind);
    EXPECT_FLOAT_EQ(static_cast<float>(most), static_cast<float>(extinction_per_m(layer.kind)));
  }
}

}  // namespace
}  // namespace citykiln::sky
