#include <gtest/gtest.h>

#include <cmath>

#include "preview/scene/world.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;

// A square of 200 m about (5000, 5000), and around it land up to 900 m away that rises to the outside: from 0 to 300 m.
const Vec3 kMiddle{5000, 5000, 0};
constexpr double kInner_m = 100, kOuter_m = 1000, kHigh_m = 300;

bake::BakedTile square() {
  bake::Primitive ground{Material::kGrass, {}, {}, {}, {}, {}};
  add_quad(ground, {-kInner_m, -kInner_m, 0}, {kInner_m, -kInner_m, 0}, {kInner_m, kInner_m, 0},
           {-kInner_m, kInner_m, 0});
  return tile(kMiddle, {ground});
}

bake::BakedTile rim() {
  bake::Primitive land{Material::kRock, {}, {}, {}, {}, {}};
  const double in = kInner_m, out = kOuter_m;
  add_quad(land, {-out, -out, kHigh_m}, {out, -out, kHigh_m}, {in, -in, 0}, {-in, -in, 0});
  add_quad(land, {out, -out, kHigh_m}, {out, out, kHigh_m}, {in, in, 0}, {in, -in, 0});
  add_quad(land, {out, out, kHigh_m}, {-out, out, kHigh_m}, {-in, in, 0}, {in, in, 0});
  add_quad(land, {-out, out, kHigh_m}, {-out, -out, kHigh_m}, {-in, -in, 0}, {-in, in, 0});
  return tile(kMiddle, {land});
}

const Box2 kClear{in_plan(kMiddle) - Vec2{kInner_m, kInner_m}, in_plan(kMiddle) + Vec2{kInner_m, kInner_m}};

// Rays in all directions, from inside and outside.
template <typename Check>
int for_all_rays(Check check) {
  int count = 0;
  for (const Vec3 from : {kMiddle + Vec3{3, 7, 20}, kMiddle + Vec3{-99, 90, 250}, kMiddle + Vec3{600, 0, 280},
                          kMiddle + Vec3{-1500, -300, 500}, kMiddle + Vec3{0, 0, 2000}})
    for (int i = 0; i < 2000; ++i) {
      const double z = 1 - (i + 0.5) / 1000, azimuth = 2.399963 * i, flat = std::sqrt(1 - z * z);
      check(from, Vec3{flat * std::cos(azimuth), flat * std::sin(azimuth), z});
      ++count;
    }
  return count;
}

TEST(Backdrop, IsSeenAsIfItWereATileOfTheScene) {
  const std::vector<bake::BakedTile> inner = {square()}, both = {square(), rim()};
  const bake::BakedTile around = rim();
  const World whole(both, kMiddle), divided(inner, kMiddle, {&around, kClear}), unclear(inner, kMiddle, {&around, {}});
  const Vec3 origin = whole.origin();
  int met = 0;
  const int count = for_all_rays([&](Vec3 from, Vec3 direction) {
    const auto expected = whole.first_hit(from - origin, direction);
    for (const World* world : {&divided, &unclear}) {
      const auto hit = world->first_hit(from - origin, direction);
      ASSERT_EQ(hit.has_value(), expected.has_value());
      if (!hit) continue;
      EXPECT_EQ(hit->material, expected->material);
      EXPECT_NEAR(hit->distance_m, expected->distance_m, 1e-3);
      // blocked by what is nearer than a distance, and only by that
      EXPECT_TRUE(world->is_blocked(from - origin, direction, hit->distance_m * 1.001));
      EXPECT_FALSE(world->is_blocked(from - origin, direction, hit->distance_m * 0.999));
    }
    met += expected && expected->material == Material::kRock;
  });
  EXPECT_GT(met, count / 20);
}

TEST(Backdrop, ThrowsItsShadowOnTheScene) {
  const std::vector<bake::BakedTile> inner = {square()};
  const bake::BakedTile around = rim();
  const World world(inner, kMiddle, {&around, kClear}), open(inner, kMiddle);
  const Vec3 on_ground = kMiddle + Vec3{0, 0, 1} - world.origin();
  const Vec3 low_sun = unit(Vec3{1, 0, 0.2}), high_sun = unit(Vec3{1, 0, 0.5});
  EXPECT_TRUE(world.is_blocked(on_ground, low_sun));
  EXPECT_FALSE(world.is_blocked(on_ground, high_sun));
  EXPECT_FALSE(open.is_blocked(on_ground, low_sun));
}

}  // namespace
}  // namespace citykiln::preview
