// Light in clouds against paths of light, and shapes whose light is known.
#include "preview/clouds/cloud_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/contract/random_sequence.h"
#include "preview/clouds/cloud_paths.h"

namespace citykiln::preview {
namespace {

constexpr sky::CloudLayer kSampledLayer = {sky::CloudKind::kCumulus, 0.4, 1500, 2300, {3, 4}, 7};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Numbers of a sequence of its own.
struct Random {
  RandomSequence draw;
  std::uint32_t next = 0;
  double operator()() { return draw.unit(next++); }
};

CloudField field_of(const std::vector<sky::CloudParticle>& spheres, const CloudLight& light, CloudEdges edges) {
  return CloudField(kSampledLayer, spheres, light, edges);
}

TEST(CloudField, ASphereLetsPassWhatItsChordDoes) {
  const CloudField field = field_of({{{0, 0, 400}, 60}}, {.sun = {}, .sky = {}, .ground = {}}, CloudEdges::kSharp);
  const double extinction = sky::extinction_per_m(sky::CloudKind::kCumulus);
  const CloudPath through = field.along({-1000, 0, 1900}, {1, 0, 0}, kInfinity);
  EXPECT_NEAR(through.passed, std::exp(-120 * extinction), 0.004);
  EXPECT_NEAR(field.along({-1000, 0, 1900}, {1, 0, 0}, 1000).passed, std::exp(-60 * extinction), 0.03);
  EXPECT_EQ(field.along({-1000, 70, 1900}, {1, 0, 0}, kInfinity).passed, 1);
  EXPECT_GT(through.distance_m, 940);
  EXPECT_LT(through.distance_m, 1000);
}

// Paths through a homogeneous sphere, too.
TEST(CloudField, PathsPassASphereAsOftenAsItsChordLets) {
  const CloudField field = field_of({{{0, 0, 400}, 30}}, {.sun = {}, .sky = {}, .ground = {}}, CloudEdges::kSharp);
  Random random{{5, StableId{1}, "path"}};
  int passed = 0;
  constexpr int kPaths = 20000;
  for (int i = 0; i < kPaths; ++i)
    passed += !std::isfinite(free_path(field, {-1000, 0, 1900}, {1, 0, 0}, kInfinity, random));
  const double expected = std::exp(-60 * sky::extinction_per_m(sky::CloudKind::kCumulus));
  EXPECT_NEAR(passed, kPaths * expected, 4 * std::sqrt(kPaths * expected));
}

TEST(CloudField, SoftEdgesDimAsTheyThin) {
  const CloudField field = field_of({{{0, 0, 400}, 60}}, {.sun = {}, .sky = {}, .ground = {}}, CloudEdges::kSoft);
  double before = field.along({-1000, 0, 1900}, {1, 0, 0}, kInfinity).passed;
  EXPECT_LT(before, 0.05);
  for (int y = 5; y <= 60; y += 5) {
    const double passed = field.along({-1000, static_cast<double>(y), 1900}, {1, 0, 0}, kInfinity).passed;
    EXPECT_GE(passed, before - 0.01) << y;
    before = passed;
  }
  // sharp, this ray would lose two fifths
  EXPECT_GT(field.along({-1000, 59, 1900}, {1, 0, 0}, kInfinity).passed, 0.9);
}

TEST(CloudField, ThrowsAShadowAwayFromTheSun) {
  const CloudField field = field_of(
      {{{0, 0, 400}, 100}}, {.to_sun = unit(Vec3{1, 0, 1}), .sun = {}, .sky = {}, .ground = {}}, CloudEdges::kSharp);
  // the sphere's middle is 1,900 m up
  const sky::LayerFrame frame = sky::frame_of(kSampledLayer);
  const Vec3 middle = frame.out_of({0, 0, 400});
  EXPECT_LT(field.sun_passed(middle - unit(Vec3{1, 0, 1}) * 2000), 0.05);
  EXPECT_EQ(field.sun_passed(middle - Vec3{0, 0, 1900}), 1);
  EXPECT_EQ(field.sun_passed(middle + unit(Vec3{1, 0, 1}) * 200), 1);
}

// Droplets absorb nothing: a cloud under even light cannot be seen.
TEST(CloudField, PathsInEvenLightAreAsBrightAsTheLight) {
  const CloudLight light{.sun = {}, .sky = {1, 1, 1}, .ground = {1, 1, 1}};
  const CloudField field = field_of({{{0, 0, 400}, 150}, {{120, 40, 350}, 120}}, light, CloudEdges::kBillowed);
  double sum = 0;
  constexpr int kPaths = 4000;
  for (std::uint32_t i = 0; i < kPaths; ++i) {
    const CloudPath path =
        cloud_path(field, {-1000, 20, 1890}, {1, 0, 0}, kInfinity, 5000, Random{{5, StableId{i}, "path"}});
    sum += path.added[1] + path.passed;
  }
  EXPECT_NEAR(sum / kPaths, 1, 1e-12);
}

// A cloud from four sides, by CloudField over that of paths.
struct Ratios {
  double sum = 0, least = 1e9, most = 0;
  int count = 0;
  void add(double ratio) { sum += ratio, least = std::min(least, ratio), most = std::max(most, ratio), ++count; }
};

void compare(const sky::Cloud& cloud, const CloudLight& light, Ratios& ratios) {
  const sky::CloudParticles particles = sky::generate_cloud(kSampledLayer, cloud, kInfinity);
  const CloudField field = field_of(particles.spheres, light, CloudEdges::kBillowed);
  const Vec3 middle = sky::frame_of(kSampledLayer).out_of(at_height(cloud.centre, cloud.height_m * 0.4));
  for (const Vec3 side : {Vec3{1, 0, -0.3}, Vec3{0, 1, -0.3}, Vec3{-1, 0, -0.3}, Vec3{0, -1, -0.3}}) {
    double fast = 0, exact = 0;
    for (std::uint32_t i = 0; i < 1500; ++i) {
      const RandomSequence draw(3, StableId{i}, "ray");
      const auto off = [&](std::uint32_t n) { return draw.between(-0.6, 0.6, n) * cloud.radius_m; };
      const Vec3 eye = middle + side * 3000, along = unit(middle + Vec3{off(0), off(1), off(2) / 2} - eye);
      fast += field.along(eye, along, kInfinity).added[1];
      exact += cloud_path(field, eye, along, kInfinity, kMostScatterings, Random{{9, StableId{i}, "path"}}).added[1];
    }
    ratios.add(fast / exact);
  }
}

TEST(CloudField, IsAboutAsBrightAsPathsThroughTheCloud) {
  const std::vector<sky::Cloud> clouds = sky::clouds_in(kSampledLayer, {{-9000, -9000}, {9000, 9000}});
  ASSERT_GT(clouds.size(), 3U);
  Ratios ratios;
  for (std::size_t c = 0; c < 3; ++c)
    for (const double height : {0.2, 1.0, 4.0})
      compare(clouds[c],
              {.to_sun = unit(Vec3{1, 0, height}), .sun = {3, 3, 3}, .sky = {0.2, 0.2, 0.2}, .ground = {0.1, 0.1, 0.1}},
              ratios);
  EXPECT_NEAR(ratios.sum / ratios.count, 1, 0.1);
  EXPECT_GT(ratios.least, 0.5);
  EXPECT_LT(ratios.most, 1.6);
}

// The share of vertical rays from the ground that lose more than a tenth of their light.
double covered_by(double cover) {
  sky::CloudLayer layer = kSampledLayer;
  layer.cover = cover;
  const CloudField field(std::span(&layer, 1), {.sun = {}, .sky = {}, .ground = {}}, {0, 0, 100}, 0.002);
  int met = 0;
  constexpr std::uint32_t kRays = 2000;
  for (std::uint32_t i = 0; i < kRays; ++i) {
    const RandomSequence draw(1, StableId{i}, "ray");
    const Vec3 from{draw.between(-12000, 12000, 0), draw.between(-12000, 12000, 1), 0};
    met += field.along(from, {0, 0, 1}, kInfinity).passed < 0.9;
  }
  return static_cast<double>(met) / kRays;
}

TEST(CloudField, CoversTheShareOfTheSkyThatIsAskedFor) {
  for (const double cover : {0.15, 0.4, 0.7}) EXPECT_NEAR(covered_by(cover), cover, 0.1) << cover;
}

TEST(CloudField, BasesAreFlatAndAtTheLayersBase) {
  const CloudField field(std::span(&kSampledLayer, 1), {.sun = {}, .sky = {}, .ground = {}}, {0, 0, 100}, 0.002);
  double lowest_m = 1e9, met = 0, near_base = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const RandomSequence draw(2, StableId{i}, "ray");
    const Vec3 from{draw.between(-8000, 8000, 0), draw.between(-8000, 8000, 1), 0};
    const CloudPath path = field.along(from, {0, 0, 1}, kInfinity);
    if (path.passed > 0.1) continue;
    ++met, near_base += path.distance_m < kSampledLayer.base_m + 100;
    lowest_m = std::min(lowest_m, path.distance_m);
  }
  EXPECT_GE(lowest_m, kSampledLayer.base_m);
  EXPECT_GT(near_base, 0.8 * met);
}

}  // namespace
}  // namespace citykiln::preview
