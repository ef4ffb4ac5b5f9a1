#include "preview/scene/world.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "compiler/materials/texture_cache.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;

// Heights on the grid of baked positions, 2^-10 m.
double height_m(int k) { return std::round(1024 * 3 * std::sin(k * 1.7)) / 1024; }

// Hilly ground west (0) or east (1) of a line 1024 m east of `at`, cut every 16 m to the north.
bake::BakedTile side(Vec3 at, int east) {
  bake::Primitive ground{Material::kAsphalt, {}, {}, {}, {}, {}};
  const double edge = east == 0 ? 1024 : 0, far = east == 0 ? 0 : 1024;
  for (int i = 0; i < 64; ++i) {
    const Vec3 low{edge, 16.0 * i, height_m(i)}, high{edge, 16.0 * (i + 1), height_m(i + 1)};
    const Vec3 far_low{far, low.y, low.z}, far_high{far, high.y, high.z};
    if (east == 0)
      add_quad(ground, far_low, low, high, far_high);
    else
      add_quad(ground, low, far_low, far_high, high);
  }
  return tile(at + Vec3{1024.0 * east, 0, 0}, {ground});
}

// 20 km from the plane's origin, seen from near and from 15 km away, steeply and flat.
TEST(World, ARayAtASeamMeetsOneOfItsSides) {
  const Vec3 at{20480, -20480, 300};
  const std::vector tiles = {side(at, 0), side(at, 1)};
  for (const Vec3 from :
       {Vec3{1024, 500, 40}, Vec3{1020, 512, 900}, Vec3{1024, -9000, 1500}, Vec3{-9000, -9000, 9000}}) {
    const World world(tiles, at + from);
    const Vec3 eye = at + from - world.origin();
    int missed = 0;
    for (int i = 0; i < 64 * 64; ++i) {
      const int k = i / 64;
      const double share = (i % 64 + 0.5) / 64, y = 16 * (k + share);
      const double z = height_m(k) * (1 - share) + height_m(k + 1) * share;
      for (const double aside : {-1e-3, -1e-4, 0.0, 1e-4, 1e-3}) {
        const Vec3 to = at + Vec3{1024 + aside, y, z} - world.origin();
        missed += world.first_hit(eye, unit(to - eye)) ? 0 : 1;
      }
    }
    EXPECT_EQ(missed, 0) << from.z;
  }
}

TEST(World, ARayThatLeavesASurfaceDoesNotMeetItAgain) {
  const Vec3 at{20480, -20480, 300};
  const std::vector tiles = {side(at, 0), side(at, 1)};
  for (const Vec3 near : {at + Vec3{900, 500, 100}, at + Vec3{-15000, 0, 2000}, Vec3{0, 0, 0}}) {
    const World world(tiles, near);
    int met = 0;
    for (int i = 0; i < 4000; ++i) {
      // in the bottom of a valley the other slope is met
      if (std::abs(std::remainder(5 + std::fmod(7.77 * i, 1000), 16)) < 0.2) continue;
      const Vec3 above = at + Vec3{3 + 0.511 * i, 5 + std::fmod(7.77 * i, 1000), 50} - world.origin();
      const auto hit = world.first_hit(above, {0, 0, -1});
      ASSERT_TRUE(hit);
      // along the slope and a hair off it, and straight up
      const Vec3 flat = unit(cross(hit->geometric_normal, {1, 0, 0}));
      for (const Vec3 out : {unit(flat + hit->geometric_normal * 1e-4), Vec3{0, 0, 1}}) {
        const auto again = world.first_hit(leave(*hit, out), out);
        met += again && again->distance_m < 0.1 ? 1 : 0;
      }
      // strips of 16 by 1024 m are as bad as it gets: twice the largest plane error, 0.03 m
      EXPECT_LT(length(leave(*hit, {0, 0, 1}) - hit->position), 0.061);
    }
    EXPECT_EQ(met, 0) << near.x;
  }
}

// Rounding matters for positions far from the world's origin, even on small triangles.
TEST(World, ARayThatLeavesASmallTriangleFarAwayDoesNotMeetItAgain) {
  bake::Primitive slope{Material::kRock, {}, {}, {}, {}, {}};
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 30; ++x) {
      const auto at = [](int i, int j) { return Vec3{1.0 * i, 1.0 * j, (300.0 * i + 500.0 * j) / 1024}; };
      add_quad(slope, at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
    }
  const std::vector tiles = {tile({14000, -15000, 700}, {slope})};
  const World world(tiles, {0, 0, 0});
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 below{14000 + std::fmod(0.7137 * i, 30), -15000 + std::fmod(0.3191 * i, 30), 690};
    const auto hit = world.first_hit(below, {0, 0, 1});
    ASSERT_TRUE(hit);
    met += world.is_blocked(leave(*hit, hit->geometric_normal), hit->geometric_normal) ? 1 : 0;
    EXPECT_LT(length(leave(*hit, hit->geometric_normal) - hit->position), 0.005);
  }
  EXPECT_EQ(met, 0);
}

// A copy of half the size shows the same image at half the resolution, so hits have the same uvs.
TEST(World, SharedMeshesShowTheirTilesTextures) {
  bake::Primitive bark = floor({0, 0, 0}, {4, 4, 0}, Material::kPlatedBark);
  for (const bake::Float3& p : bark.positions) bark.uvs.push_back({p[0] / 2, p[1] / 2});
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  tile.instanced = {{"pine_0", {bark}, {{0, 0, 0}, {10, 0, 0}}, {{0, 0, 0, 1}, {0, 0, 0, 1}}, {1, 0.5f}, {0, 0}}};
  tile.textures = materials::TextureCache(1).textures_of(std::array{Material::kPlatedBark}, 0.05);
  const World world(std::span(&tile, 1), {0, 0, 0});
  const auto light_at = [&](double x, double y) { return world.first_hit({x, y, 5}, {0, 0, -1}, 0)->albedo[1]; };
  double least = 1, most = 0;
  for (int i = 0; i < 100; ++i) {
    const double x = 0.02 + 0.0395 * i, y = 0.02 + std::fmod(1.37 * i, 3.9);
    EXPECT_NEAR(light_at(x, y), light_at(10 + x / 2, y / 2), 1e-4);
    least = std::min(least, light_at(x, y)), most = std::max(most, light_at(x, y));
  }
  EXPECT_GT(most, 2 * least);
}

TEST(World, AHitSaysWhereWhatAndHowFar) {
  bake::Primitive ground = floor({-10, -10, 2}, {10, 10, 2}, Material::kBrick);
  for (materials::Tint& tint : ground.colours) tint = {51, 102, 255, 255};
  const std::vector tiles = {tile({100, 200, 30}, {ground})};
  const World world(tiles, {103.4, 198.7, 50});
  EXPECT_EQ(world.origin(), (Vec3{103, 199, 50}));
  const Vec3 slant = unit(Vec3{3, 0, -4});
  const auto hit = world.first_hit(Vec3{100, 200, 42} - world.origin(), slant);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(length(hit->position + world.origin() - Vec3{107.5, 200, 32}), 0, 1e-5);
  EXPECT_NEAR(hit->distance_m, 12.5, 1e-5);
  EXPECT_EQ(hit->material, Material::kBrick);
  EXPECT_NEAR(hit->albedo[0], 0.300 * 0.2, 1e-6);
  EXPECT_NEAR(hit->albedo[1], 0.120 * 0.4, 1e-6);
  EXPECT_NEAR(hit->albedo[2], 0.080, 1e-6);
  // from below, too, the normal is turned to the eye
  EXPECT_EQ(hit->geometric_normal, (Vec3{0, 0, 1}));
  const auto below = world.first_hit(Vec3{100, 200, 20} - world.origin(), {0, 0, 1});
  ASSERT_TRUE(below);
  EXPECT_EQ(below->geometric_normal.z, -1);
  EXPECT_EQ(below->shading_normal.z, -1);
  EXPECT_TRUE(world.is_blocked(Vec3{100, 200, 20} - world.origin(), {0, 0, 1}));
  EXPECT_FALSE(world.is_blocked(Vec3{100, 200, 40} - world.origin(), {0, 0, 1}));
}

}  // namespace
}  // namespace citykiln::preview
