// Tables of shadows, of light on surfaces and of the sky that is seen, against rays.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compiler/contract/random_sequence.h"
#include "preview/clouds/cloud_dome.h"
#include "preview/clouds/cloud_panorama.h"
#include "preview/clouds/cloud_shadow.h"
#include "preview/turn.h"

namespace citykiln::preview {
namespace {

constexpr sky::CloudLayer kTabledLayer = {sky::CloudKind::kCumulus, 0.5, 1500, 2300, {3, 4}, 7};
const CloudLight kLight{
    .to_sun = unit(Vec3{1, 0, 1}), .sun = {3, 3, 3}, .sky = {0.2, 0.2, 0.2}, .ground = {0.1, 0.1, 0.1}};
constexpr Vec3 kEye{0, 0, 100};

const CloudField& cumulus_field() {
  static const CloudField made(std::span(&kTabledLayer, 1), kLight, kEye, 0.002);
  return made;
}

TEST(CloudShadow, IsThatOfRays) {
  const CloudShadow shadow(cumulus_field(), kLight.to_sun, {}, 2);
  const RandomSequence draw(3, StableId{1}, "places");
  double error = 0, mean = 0;
  constexpr std::uint32_t kPlaces = 2000;
  for (std::uint32_t i = 0; i < kPlaces; ++i) {
    const Vec3 at{draw.between(-2000, 2000, 3 * i), draw.between(-2000, 2000, 3 * i + 1),
                  draw.between(0, 1400, 3 * i + 2)};
    const auto passed = shadow.passed(at);
    ASSERT_TRUE(passed);
    error += std::abs(*passed - cumulus_field().sun_passed(at)) / kPlaces, mean += *passed / kPlaces;
  }
  EXPECT_GT(mean, 0.2);
  EXPECT_LT(mean, 0.8);
  EXPECT_LT(error, 0.03);
  EXPECT_FALSE(shadow.passed({0, 0, 1600}));
  EXPECT_FALSE(shadow.passed({1e5, 0, 0}));
}

TEST(CloudDome, HasTheLightOfRaysOnTheAverage) {
  const sky::SkyModel model = sky::generate(sky::Sky{.time = {}, .to_sun = kLight.to_sun}, 0);
  const CloudDome dome(cumulus_field(), model, kEye, 2);
  const RandomSequence draw(3, StableId{1}, "rays");
  double ours = 0, exact = 0, passed = 0, exactly_passed = 0;
  constexpr std::uint32_t kRays = 3000;
  for (std::uint32_t i = 0; i < kRays; ++i) {
    const Vec3 from{draw.between(-500, 500, 4 * i), draw.between(-500, 500, 4 * i + 1), 50};
    const double z = std::sqrt(draw.unit(4 * i + 2));
    const Vec3 along = at_height(on_circle(draw.unit(4 * i + 3)) * std::sqrt(1 - z * z), z);
    const auto veil = dome.along(from, along);
    ASSERT_TRUE(veil);
    const CloudPath path = cumulus_field().along(from, along, std::numeric_limits<double>::infinity());
    const CloudVeil ray = path.passed < 1 ? veil_of(path, sky::air(model, along, path.distance_m)) : CloudVeil{};
    ours += veil->added[1], exact += ray.added[1], passed += veil->passed, exactly_passed += ray.passed;
  }
  EXPECT_NEAR(ours / exact, 1, 0.03);
  EXPECT_NEAR(passed / exactly_passed, 1, 0.05);
  EXPECT_FALSE(dome.along({0, 0, 1600}, {0, 0, 1}));
}

TEST(CloudPanorama, ShowsWhatRaysMeet) {
  const CloudPanorama panorama(cumulus_field(), kEye, 0.002);
  const RandomSequence draw(4, StableId{1}, "rays");
  double error = 0, opaque = 0;
  constexpr std::uint32_t kRays = 1000;
  for (std::uint32_t i = 0; i < kRays; ++i) {
    const double z = draw.between(0.1, 0.4, 2 * i);
    const Vec3 along = at_height(on_circle(0.1 * draw.unit(2 * i + 1)) * std::sqrt(1 - z * z), z);
    const auto seen = panorama.along(kEye, along);
    ASSERT_TRUE(seen);
    const CloudPath path = cumulus_field().along(kEye, along, std::numeric_limits<double>::infinity());
    error += std::abs(seen->passed - path.passed) / kRays, opaque += (1 - path.passed) / kRays;
  }
  EXPECT_GT(opaque, 0.2);
  EXPECT_LT(error, 0.03);
  EXPECT_FALSE(panorama.along(kEye, {1, 0, 0}));
  EXPECT_FALSE(panorama.along({0, 0, 1600}, {0, 0, 1}));
}

// The eye moves by a metre: the table follows the ray to the height of the clouds.
TEST(CloudPanorama, IsReadFromOtherPlacesBelowTheClouds) {
  const CloudPanorama panorama(cumulus_field(), kEye, 0.002);
  for (const double turn : {0.1, 0.4, 0.8}) {
    const Vec3 along = at_height(on_circle(turn) * 0.8, 0.6);
    const auto here = panorama.along(kEye, along), there = panorama.along(kEye + along * 10, along);
    ASSERT_TRUE(here && there);
    EXPECT_NEAR(here->passed, there->passed, 1e-6);
  }
}

}  // namespace
}  // namespace citykiln::preview
