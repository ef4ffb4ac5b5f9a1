// Light that can be computed by hand: a uniform white sky, a sun of known radiance.
#include "preview/path_trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "preview/surface/bsdf.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;

// White of radiance `sky_radiance` from everywhere above, and a sun.
sky::SkyModel even_sky(double sky_radiance, Vec3 to_sun = {0, 0, 1}, double sun_radiance = 0) {
  sky::SkyModel model;
  model.to_sun = unit(to_sun);
  model.sun_cos_radius = std::cos(0.004652);
  model.sun_radiance = {sun_radiance, sun_radiance, sun_radiance};
  model.everywhere = {sky_radiance, sky_radiance, sky_radiance};
  return model;
}

// Mean radiance seen from a point in a direction.
Rgb seen(const std::vector<bake::BakedTile>& tiles, const Lights& lights, Vec3 eye, Vec3 look_at, int samples,
         int bounces) {
  const World world(tiles, eye);
  const LocalLights local(world, lights.lamps(), 1);
  const TraceContext stage{world, lights, local, bounces};
  const PixelSamples pixel(0, 0, 0, grid_of(1, 1, samples));
  Rgb sum{};
  for (int i = 0; i < samples; ++i) {
    PathDraw draw(pixel, static_cast<std::uint32_t>(i));
    sum = sum + trace(stage, eye - world.origin(), unit(look_at - eye), draw).light;
  }
  return sum * (1.0 / samples);
}

Rgb albedo_of(Material material) {
  const auto& colour = values_of(material).base_colour;
  return {colour[0], colour[1], colour[2]};
}

// The share of even light that a surface reflects: towards an eye at this cosine, or on average for cosine 0.
Rgb reflectance_of(Material material, double cosine = 0) {
  const materials::MaterialValues& values = values_of(material);
  Hit hit;
  hit.geometric_normal = hit.shading_normal = {0, 0, 1};
  hit.albedo = albedo_of(material), hit.roughness = values.roughness;
  constexpr int kSamples = 16384;
  const PixelSamples pixel(11, 0, 0, grid_of(1, 1, kSamples));
  Rgb sum{};
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    PathDraw draw(pixel, i);
    const UnitPair eye = draw.next();
    const double z = cosine > 0 ? cosine : std::sqrt(1 - eye.u), lobe = draw.next().u;
    sum = sum + Bsdf(hit, direction_at(eye.v, z), 0).sample(lobe, draw.next()).weight;
  }
  return sum * (1.0 / kSamples);
}

// Half a sphere, open above, seen from inside; every facet flat.
bake::Primitive bowl(Vec3 centre, double radius, Material material) {
  constexpr int kAround = 96, kDown = 32;
  const auto at = [&](int i, int j) {
    const double turn = 2 * std::numbers::pi * i / kAround, down = std::numbers::pi / 2 * j / kDown;
    return centre + Vec3{std::cos(turn) * std::cos(down), std::sin(turn) * std::cos(down), -std::sin(down)} * radius;
  };
  bake::Primitive primitive{material, {}, {}, {}, {}, {}};
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kDown; ++j) add_quad(primitive, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return primitive;
}

TEST(Trace, AnEvenSkyIsEven) {
  const Lights lights(even_sky(1));
  const Rgb white = lights.falling({}, {0, 0, 1});
  EXPECT_NEAR(white[1], 1, 0.1);
  for (const Vec3 d : {Vec3{1, 0, 0.01}, Vec3{-1, 2, 0.5}, Vec3{0, 0, 1}})
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(lights.seen({0, 0, 2}, unit(d), 0.001, true)[c], white[c], 1e-9);
}

// The furnace test: an open surface under a uniform sky reflects exactly its reflectance of it.
TEST(Trace, OpenGroundSendsBackItsReflectanceOfAnEvenSky) {
  const Lights lights(even_sky(1));
  const Rgb white = lights.falling({}, {0, 0, 1});
  for (const Material material : {Material::kSnow, Material::kPaint, Material::kGrass, Material::kBrick})
    for (const int bounces : {0, 3}) {
      const std::vector tiles = {tile({0, 0, 0}, {floor({-9, -9, 0}, {9, 9, 0}, material)})};
      const Rgb light = seen(tiles, lights, {0, -1, 2}, {0.3, 0.4, 0}, 4096, bounces);
      const Rgb wanted = reflectance_of(material, unit(Vec3{0.3, 1.4, -2}).z * -1);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(light[c], wanted[c] * white[c], 0.005 * white[c]) << bounces;
    }
}

// In a bowl every place sees the sky with half of its hemisphere, and the bowl with the other half: after n bounces
// a/2 + (a/2)² + … of the sky, n + 1 terms.
TEST(Trace, ABowlShinesAsItsBouncesAddUp) {
  const Lights lights(even_sky(1));
  const Rgb white = lights.falling({}, {0, 0, 1});
  const std::vector tiles = {tile({0, 0, 0}, {bowl({0, 0, 0}, 10, Material::kPaint)})};
  const double half = reflectance_of(Material::kPaint)[0] / 2;
  double sum = 0;
  for (int bounces = 0; bounces <= 6; ++bounces) {
    sum += std::pow(half, bounces + 1);
    const Rgb light = seen(tiles, lights, {0.3, 0.2, 1}, {1, -2, -9.7}, 8192, bounces);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(light[c], sum * white[c], 0.012 * white[c]) << bounces;
  }
}

// sun's radiance · solid angle · cosine / π · albedo, and the sky's albedo share on top.
TEST(Trace, SunlitGroundHasItsIrradiance) {
  for (const double elevation_deg : {12.0, 45.0, 80.0}) {
    const double e = elevation_deg * std::numbers::pi / 180;
    const sky::SkyModel model = even_sky(0.5, {std::cos(e) * 0.6, std::cos(e) * 0.8, std::sin(e)}, 30000);
    const Lights lights(model);
    const double solid_angle = 2 * std::numbers::pi * (1 - std::cos(0.004652));
    EXPECT_NEAR(lights.sun_solid_angle(), solid_angle, 1e-12);
    const std::vector tiles = {tile({0, 0, 0}, {floor({-9, -9, 0}, {9, 9, 0}, Material::kConcrete)})};
    const Rgb light = seen(tiles, lights, {0, -1, 2}, {0.3, 0.4, 0}, 1024, 3);
    for (int c = 0; c < 3; ++c) {
      const double falling = 30000 * solid_angle * std::sin(e) / std::numbers::pi + lights.falling({}, {0, 0, 1})[c];
      // its coat adds up to a tenth
      const double wanted = albedo_of(Material::kConcrete)[c] * falling;
      EXPECT_GT(light[c], 0.98 * wanted) << elevation_deg;
      EXPECT_LT(light[c], 1.12 * wanted) << elevation_deg;
    }
  }
}

// A house 10 m high throws a shadow of 10 m · cot(elevation), away from the sun.
TEST(Trace, AShadowLiesWhereTheSunSays) {
  const double e = 35 * std::numbers::pi / 180, reach = 10 / std::tan(e);
  const Vec2 towards{0.6, 0.8};
  const Lights lights(even_sky(0.05, {towards.x * std::cos(e), towards.y * std::cos(e), std::sin(e)}, 30000));
  // far from the plane's origin, where single precision is coarse
  const Vec3 at{20480, -30720, 700};
  const std::vector tiles = {tile(
      at, {floor({-60, -60, 0}, {60, 60, 0}, Material::kConcrete), box({-1, -1, 0}, {1, 1, 10}, Material::kConcrete)})};
  const auto brightness = [&](Vec2 place) {
    return luminance(seen(tiles, lights, at + Vec3{place.x, place.y, 30}, at + Vec3{place.x, place.y, 0}, 64, 0));
  };
  const double lit = brightness(towards * 20), dark = brightness(towards * -5);
  EXPECT_GT(lit, 8 * dark);
  for (const double along : {2.0, 6.0, reach - 1.6}) EXPECT_LT(brightness(towards * -along), 0.3 * lit) << along;
  for (const double along : {reach + 1.6, reach + 8}) EXPECT_GT(brightness(towards * -along), 0.9 * lit) << along;
  for (const double along : {2.0, 6.0, 12.0})
    for (const double aside : {-1.7, 1.7})
      EXPECT_GT(brightness(towards * -along + Vec2{-towards.y, towards.x} * aside), 0.7 * lit) << along;
  EXPECT_GT(brightness(towards * 2.5), 0.7 * lit);
}

// Light comes from outside alone: a room without windows is black, at any distance from the plane's origin,
// but for the air in it.
TEST(Trace, AClosedRoomIsBlack) {
  const Lights lights(even_sky(1, {0.3, 0.4, 0.8}, 30000));
  for (const Vec3 at : {Vec3{0, 0, 0}, Vec3{20480, -30720, 700}}) {
    const std::vector tiles = {tile(at, {box({-4.1, -3.3, 0.2}, {5.7, 6.1, 3.9}, Material::kPaint)})};
    for (const Vec3 to : {Vec3{5.6, 6, 3.8}, Vec3{0, 0, 0.2}, Vec3{-4, 6, 0.3}, Vec3{5.7, 0, 3.89}})
      EXPECT_LT(luminance(seen(tiles, lights, at + Vec3{0.1, 0.2, 1.5}, at + to, 256, 6)), 0.0005);
  }
}

TEST(Trace, NotFiniteRaysSeeNothingBad) {
  const Lights lights(even_sky(1));
  const double nan = std::nan(""), far = std::numeric_limits<double>::infinity();
  const std::vector tiles = {tile({0, 0, 0}, {floor({-9, -9, 0}, {9, 9, 0}, Material::kGrass)})};
  const World world(tiles, {0, 0, 0});
  for (const Vec3 bad : {Vec3{nan, 0, 1}, Vec3{far, 0, 0}, Vec3{0, 0, 0}}) {
    EXPECT_FALSE(world.first_hit({0, 0, 1}, bad));
    EXPECT_FALSE(world.is_blocked({0, 0, 1}, bad));
  }
  EXPECT_FALSE(world.first_hit({nan, 0, 1}, {0, 0, -1}));
}

}  // namespace
}  // namespace citykiln::preview
