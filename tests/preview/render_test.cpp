#include "preview/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;

const sky::Sky kAfternoon{{}, unit(Vec3{-0.5, -0.4, 0.7}), 2.6};

Options options_of_size(int width, int height, int samples) {
  Options options;
  options.width = width, options.height = height, options.samples = samples;
  return options;
}

// Ground, houses, water that mirrors them.
bake::BakedTile place_by_a_lake(Vec3 origin) {
  return tile(
      origin,
      {floor({-60, -60, 0}, {60, 0, 0}, Material::kGrass), floor({-60, 0, -0.5}, {60, 60, -0.5}, Material::kWater),
       box({-20, -12, 0}, {-8, -4, 9}, Material::kPlaster), box({6, -20, 0}, {18, -8, 14}, Material::kGlassFacade)});
}

Camera over_the_lake(Vec3 origin) { return {origin + Vec3{30, 55, 14}, origin + Vec3{0, -5, 2}, 45}; }

TEST(Render, AnyNumberOfThreadsIsTheSamePicture) {
  const std::vector tiles = {place_by_a_lake({1024, 2048, 10})};
  Options options = options_of_size(75, 50, 4);
  options.threads = 1;
  const Image one = render(tiles, kAfternoon, over_the_lake({1024, 2048, 10}), options);
  ASSERT_EQ(one.rgb.size(), 75u * 50 * 3);
  for (const int threads : {2, 7}) {
    options.threads = threads;
    const Image other = render(tiles, kAfternoon, over_the_lake({1024, 2048, 10}), options);
    ASSERT_EQ(other.rgb.size(), one.rgb.size());
    EXPECT_EQ(std::memcmp(one.rgb.data(), other.rgb.data(), one.rgb.size() * sizeof(float)), 0) << threads;
  }
}

TEST(Render, AnotherSeedIsAnotherGrainOfTheSamePicture) {
  const std::vector tiles = {place_by_a_lake({0, 0, 0})};
  Options options = options_of_size(40, 30, 16);
  const Image one = render(tiles, kAfternoon, over_the_lake({0, 0, 0}), options);
  options.seed = 1;
  const Image other = render(tiles, kAfternoon, over_the_lake({0, 0, 0}), options);
  EXPECT_NE(one.rgb, other.rgb);
  double a = 0, b = 0;
  for (std::size_t i = 0; i < one.rgb.size(); ++i) a += one.rgb[i], b += other.rgb[i];
  EXPECT_NEAR(b / a, 1, 0.01);
}

// A ceiling that shines with 100 cd/m² under a sky of which 1 is 6,250.
TEST(Render, WhatShinesIsSeenByNight) {
  const std::vector tiles = {tile({}, {floor({-60, -60, 0}, {60, 60, 0}, Material::kOfficeCeiling)})};
  const sky::Sky night{{}, unit(Vec3{0, -0.9, -0.4}), 2.6};
  const Image image = render(tiles, night, {{0, 0, 10}, {0, 1, 0}, 30}, options_of_size(8, 8, 4));
  ASSERT_FALSE(image.rgb.empty());
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) EXPECT_NEAR(image.rgb[i], 100.0 / 6250, 1e-4);
}

TEST(Render, ExposureMultiplies) {
  const std::vector tiles = {place_by_a_lake({0, 0, 0})};
  Options options = options_of_size(16, 9, 2);
  const Image one = render(tiles, kAfternoon, over_the_lake({0, 0, 0}), options);
  options.exposure = 2;
  const Image bright = render(tiles, kAfternoon, over_the_lake({0, 0, 0}), options);
  ASSERT_FALSE(one.rgb.empty());
  for (std::size_t i = 0; i < one.rgb.size(); ++i) EXPECT_FLOAT_EQ(bright.rgb[i], 2 * one.rgb[i]);
}

// Up is up, left is left: red ground, a dark box to the left of the middle.
TEST(Render, RowsStartAtTheTopLeft) {
  const std::vector tiles = {tile({0, 0, 0}, {floor({-900, -900, 0}, {900, 900, 0}, Material::kBrick),
                                              box({-30, 40, 0}, {-10, 60, 3}, Material::kPaint)})};
  const Image image = render(tiles, kAfternoon, {{0, 0, 8}, {0, 50, 5}, 45}, options_of_size(40, 30, 8));
  const auto at = [&](int x, int y) { return &image.rgb[static_cast<std::size_t>((y * 40 + x) * 3)]; };
  EXPECT_GT(at(20, 1)[2], at(20, 1)[0]);          // sky: blue
  EXPECT_GT(at(20, 28)[0], 1.5 * at(20, 28)[2]);  // ground: red
  int left = 0, right = 0;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const bool is_white_low = y > 12 && at(x, y)[2] > 0.6 * at(x, y)[0] && at(x, y)[0] > 0.2;
      (x < 20 ? left : right) += is_white_low ? 1 : 0;
    }
  EXPECT_GT(left, right + 10);
}

// Two tiles that meet: no pixel may see the void below through the seam.
TEST(Render, NoSkyShinesThroughASeam) {
  const Vec3 at{20480, -20480, 300};
  const auto side = [&](double shift) {
    bake::Primitive ground{Material::kAsphalt, {}, {}, {}, {}, {}};
    // the same corners seen from two origins, at heights and places on the grid of baked positions
    const double edge = 1024 - shift;
    for (int i = 0; i < 64; ++i) {
      const auto height = [](int k) { return std::round(1024 * (3 * std::sin(k * 1.7))) / 1024; };
      const Vec3 low{edge, 16.0 * i, height(i)}, high{edge, 16.0 * (i + 1), height(i + 1)};
      const double far = shift == 0 ? 0 : 1024;
      if (shift == 0)
        add_quad(ground, {far, low.y, low.z}, low, high, {far, high.y, high.z});
      else
        add_quad(ground, low, {far, low.y, low.z}, {far, high.y, high.z}, high);
    }
    return tile(at + Vec3{shift, 0, 0}, {ground});
  };
  const std::vector tiles = {side(0), side(1024)};
  // white void, black ground: a ray through would be bright
  for (const Vec3 eye : {Vec3{1024, 500, 40}, Vec3{1024, -200, 80}, Vec3{1000, 512, 900}}) {
    const Image image = render(tiles, kAfternoon, {at + eye, at + Vec3{1024, 400, 0}, 4}, options_of_size(96, 96, 16));
    const auto brightest = *std::max_element(image.rgb.begin(), image.rgb.end());
    const auto darkest = *std::min_element(image.rgb.begin(), image.rgb.end());
    EXPECT_LT(brightest, 0.6) << eye.z;
    EXPECT_GT(darkest, 0) << eye.z;
  }
}

bake::Float4 turned(double angle) {
  return {0, 0, static_cast<float>(std::sin(angle / 2)), static_cast<float>(std::cos(angle / 2))};
}

// Instances look like the transformed mesh itself, also when rotated, scaled and far away.
TEST(Render, CopiesLookLikeTheMeshWrittenOut) {
  const Vec3 at{20480, 10240, 500};
  const std::vector<bake::Primitive> shape = {box({-1, -2, 0}, {1, 2, 3}, Material::kPlaster),
                                              box({-0.5, -0.5, 3}, {0.5, 0.5, 5}, Material::kBrick)};
  bake::BakedTile copies = tile(at, {floor({-40, -40, 0}, {40, 40, 0}, Material::kGrass)}), written = copies;
  bake::InstancedMesh instanced;
  instanced.name = "Hut", instanced.primitives = shape;
  for (bake::Primitive& primitive : instanced.primitives) primitive.features.clear();
  for (int i = 0; i < 25; ++i) {
    const Vec3 place{-16.0 + 8 * (i % 5), -16.0 + 8 * (i / 5), 0};
    const double angle = i * 0.7, scale = 0.5 + 0.0625 * i;
    instanced.translations.push_back(narrowed(place));
    instanced.rotations.push_back(turned(angle));
    instanced.scales.push_back(static_cast<float>(scale));
    instanced.features.push_back(0);
    const auto turn = [&](const bake::Float3& v) {
      return Vec3{std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1],
                  v[2]};
    };
    for (bake::Primitive primitive : shape) {
      for (bake::Float3& p : primitive.positions) p = narrowed(place + turn(p) * scale);
      for (bake::Float3& n : primitive.normals) n = narrowed(turn(n));
      written.primitives.push_back(primitive);
    }
  }
  copies.instanced.push_back(instanced);
  const Camera camera{at + Vec3{24, -30, 18}, at + Vec3{0, 0, 1}, 50};
  const Image a = render(std::vector{copies}, kAfternoon, camera, options_of_size(96, 64, 16));
  const Image b = render(std::vector{written}, kAfternoon, camera, options_of_size(96, 64, 16));
  // edges may fall to either side of a ray: a sample here or there
  std::size_t differing = 0;
  double difference = 0, sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    difference += std::abs(a.rgb[i] - b.rgb[i]), sum += a.rgb[i];
    differing += std::abs(a.rgb[i] - b.rgb[i]) > 0.01 * a.rgb[i] ? 1 : 0;
  }
  EXPECT_LT(difference, 2e-3 * sum);
  EXPECT_LT(differing, a.rgb.size() / 50);
}

// A mesh that two tiles share is kept once; its instances are relative to each tile's origin.
TEST(Render, CopiesInAnotherTileStandAboutItsOrigin) {
  const auto with_hut = [](Vec3 origin, Vec3 place) {
    bake::BakedTile t = tile(origin, {});
    bake::InstancedMesh hut;
    hut.primitives = {box({-1, -2, 0}, {1, 2, 3}, Material::kPlaster)};
    hut.translations = {narrowed(place)}, hut.rotations = {turned(0)}, hut.scales = {1}, hut.features = {0};
    t.instanced = {hut};
    return t;
  };
  const std::vector apart = {with_hut({0, 0, 0}, {4, 0, 0}), with_hut({1024, 0, 0}, {-1014, 0, 0})};
  const std::vector together = {with_hut({0, 0, 0}, {4, 0, 0}), with_hut({0, 0, 0}, {10, 0, 0})};
  const Camera camera{{7, -30, 6}, {7, 0, 1}, 30};
  EXPECT_EQ(render(apart, kAfternoon, camera, options_of_size(48, 32, 4)).rgb,
            render(together, kAfternoon, camera, options_of_size(48, 32, 4)).rgb);
}

TEST(Render, NothingIsSkyAndAPictureWithoutPixelsIsEmpty) {
  const Image image = render({}, kAfternoon, {{0, 0, 10}, {0, 50, 10}, 45}, options_of_size(16, 9, 1));
  for (const float v : image.rgb) EXPECT_TRUE(std::isfinite(v) && v > 0);
  EXPECT_TRUE(render({}, kAfternoon, {}, options_of_size(0, 9, 1)).rgb.empty());
  EXPECT_TRUE(render({}, kAfternoon, {}, options_of_size(16, -1, 1)).rgb.empty());
}

}  // namespace
}  // namespace citykiln::preview
