#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "preview/camera/camera.h"
#include "preview/camera/view_probe.h"
#include "preview/scene/world.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;

constexpr const char* kViews[] = {"overview", "street", "top", "north", "south", "east", "west", "low"};

// Ground with vertices every 50 m, as baked ground has.
bake::Primitive meadow() {
  bake::Primitive grass{Material::kGrass, {}, {}, {}, {}, {}};
  for (double y = -500; y < 500; y += 50)
    for (double x = -500; x < 500; x += 50)
      add_quad(grass, {x, y, 0}, {x + 50, y, 0}, {x + 50, y + 50, 0}, {x, y + 50, 0});
  return grass;
}

// A street to the north between two closed rows of houses, in the middle of a square kilometre of grass.
bake::BakedTile village(Vec3 origin) {
  bake::Primitive street{Material::kAsphalt, {}, {}, {}, {}, {}};
  for (double y = -200; y < 200; y += 10)
    add_quad(street, {-4, y, 0.1}, {4, y, 0.1}, {4, y + 10, 0.1}, {-4, y + 10, 0.1});
  bake::Primitive houses = box({-18, -190, 0}, {-8, 190, 9}, Material::kPlaster);
  const bake::Primitive east = box({8, -190, 0}, {18, 190, 9}, Material::kBrick);
  return tile(origin, {meadow(), street, houses, east});
}

// The number of rays that hit something, of 9 by 9 through a picture.
int rays_that_hit(std::span<const bake::BakedTile> tiles, const Camera& camera) {
  const World world(tiles, camera.eye);
  const Vec3 forward = unit(camera.look_at - camera.eye);
  const Vec3 right = unit(cross(forward, std::abs(forward.z) > 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, 1}));
  const Vec3 up = cross(right, forward);
  const double slope = std::tan(camera.vertical_fov_deg * std::numbers::pi / 360);
  int hits = 0;
  for (int y = -4; y <= 4; ++y)
    for (int x = -4; x <= 4; ++x) {
      const Vec3 ray = unit(forward + right * (slope * 16 / 9 * x / 4.5) + up * (slope * y / 4.5));
      hits += world.first_hit(camera.eye - world.origin(), ray) ? 1 : 0;
    }
  return hits;
}

bool is_finite(const Camera& c) {
  return std::isfinite(length(c.eye)) && std::isfinite(length(c.look_at)) && c.vertical_fov_deg > 0;
}

TEST(NamedView, TheMiddleOfEveryViewShowsTheScene) {
  for (const Vec3 origin : {Vec3{0, 0, 0}, Vec3{20480, -40960, 1200}}) {
    const std::vector tiles = {village(origin)};
    for (const char* name : kViews) {
      const Result<Camera> camera = named_view(tiles, name);
      ASSERT_TRUE(camera) << name;
      const World world(tiles, camera->eye);
      const auto hit = world.first_hit(camera->eye - world.origin(), unit(camera->look_at - camera->eye));
      // along a street one may look into the sky
      ASSERT_TRUE(hit || name == std::string("street")) << name;
      EXPECT_GT(rays_that_hit(tiles, *camera), 27) << name;
      // seen from above the ground, not from below it or from inside a house
      EXPECT_GT(camera->eye.z, origin.z + 1) << name;
      EXPECT_TRUE(!hit || hit->distance_m > 5) << name;
    }
  }
}

TEST(NamedView, OutsideViewsHoldAllButALittleOfTheScene) {
  const std::vector tiles = {village({3000, 1000, 50})};
  for (const char* name : {"top", "north", "south", "east", "west"}) {
    const Result<Camera> camera = named_view(tiles, name);
    ASSERT_TRUE(camera) << name;
    const Vec3 forward = unit(camera->look_at - camera->eye);
    const Vec3 pole = std::abs(forward.z) > 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 right = unit(cross(forward, pole)), up = cross(right, forward);
    const double slope = std::tan(camera->vertical_fov_deg * std::numbers::pi / 360);
    int outside = 0, all = 0;
    for (double x = 2500; x <= 3500; x += 50)
      for (double y = 500; y <= 1500; y += 50, ++all) {
        const Vec3 to = Vec3{x, y, 50} - camera->eye;
        const double reach = slope * dot(to, forward);
        outside += std::abs(dot(to, up)) > reach || std::abs(dot(to, right)) > reach * 16 / 9 ? 1 : 0;
      }
    EXPECT_LE(outside, all / 50) << name;
  }
}

TEST(NamedView, ViewsAreNamedByWhereTheEyeIs) {
  const std::vector tiles = {village({0, 0, 0})};
  const auto eye = [&](const char* name) { return named_view(tiles, name)->eye; };
  EXPECT_GT(eye("north").y, 500);
  EXPECT_LT(eye("south").y, -500);
  EXPECT_GT(eye("east").x, 500);
  EXPECT_LT(eye("west").x, -500);
  EXPECT_GT(eye("overview").x, 0);
  EXPECT_LT(eye("overview").y, 0);
  EXPECT_NEAR(eye("top").x, 0, 10);
}

TEST(NamedView, StreetStandsInAStreetAtEyeHeight) {
  const std::vector tiles = {village({100, 200, 30})};
  const Camera camera = *named_view(tiles, "street");
  // on the road, or on the ground between it and the houses
  EXPECT_NEAR(camera.eye.z, 30.05 + 1.7, 0.06);
  EXPECT_LE(std::abs(camera.eye.x - 100), 6);
  // along it, not at a wall
  const Vec3 sight = unit(camera.look_at - camera.eye);
  EXPECT_GT(std::abs(sight.y), 0.9);
}

// The place in the picture of a direction, as a share of half its width: -1 the left edge, 1 the right.
double across(const Camera& camera, Vec3 direction) {
  const Vec3 forward = unit(camera.look_at - camera.eye), right = unit(cross(forward, {0, 0, 1}));
  const double half = std::tan(camera.vertical_fov_deg * std::numbers::pi / 360) * 16 / 9;
  return dot(direction, right) / dot(direction, forward) / half;
}

TEST(NamedView, TheAxisOfAStreetIsAtAThirdOfThePicture) {
  const std::vector tiles = {village({0, 0, 0})};
  const Camera camera = *named_view(tiles, "street");
  const Vec3 axis{0, camera.look_at.y > camera.eye.y ? 1.0 : -1.0, 0};
  EXPECT_NEAR(std::abs(across(camera, axis)), 1.0 / 3, 0.02);
}

TEST(NamedView, AStreetIsSeenTowardsItsSunlitSide) {
  const std::vector tiles = {village({0, 0, 0})};
  for (const double from_east : {-1.0, 1.0}) {
    const Camera camera = *named_view(tiles, "street", unit({from_east, 0, 1}));
    // the sun in the east lights the walls in the west
    EXPECT_LT((camera.look_at.x - camera.eye.x) * from_east, 0) << from_east;
  }
}

// A yard as wide as the village, paved, with few houses, nearer to most houses than the street is.
TEST(NamedView, AStreetIsNotACarPark) {
  bake::BakedTile place = village({0, 0, 0});
  place.primitives.push_back(floor({-90, -60, 0.05}, {-18, 60, 0.05}, Material::kAsphalt));
  const std::vector tiles = {place};
  EXPECT_LE(std::abs(named_view(tiles, "street")->eye.x), 6);
}

// The village, and a lane between ramparts of many parts, higher than its houses.
TEST(NamedView, AStreetIsNotALaneBetweenRamparts) {
  bake::BakedTile place = village({0, 0, 0});
  for (std::int64_t id = 0; id <= 10; ++id) place.features.push_back({OsmType::kWay, id});
  for (bake::Primitive& part : place.primitives) part.features.assign(part.positions.size(), 0);
  const auto add = [&](bake::Primitive&& part, bake::Layer layer, std::uint32_t feature) {
    part.layer = layer;
    part.features.assign(part.positions.size(), feature);
    place.primitives.push_back(std::move(part));
  };
  add(box({-17, -190, 0}, {-9, 190, 12}, Material::kPlaster), bake::Layer::kBuildings, 1);
  for (std::uint32_t i = 0; i < 9; ++i) {
    const double y = -190 + 42.0 * i;
    add(box({180, y, 0}, {188, y + 42, 20}, Material::kStone), bake::Layer::kProps, 2 + i);
    add(box({200, y, 0}, {208, y + 42, 20}, Material::kStone), bake::Layer::kProps, 2 + i);
  }
  add(floor({188, -190, 0.1}, {200, 190, 0.1}, Material::kAsphalt), bake::Layer::kRoads, 0);
  const std::vector tiles = {place};
  EXPECT_LE(std::abs(named_view(tiles, "street")->eye.x), 6);
}

// Ground that rises towards the middle, with a wood on it and no street.
TEST(NamedView, NoEyeIsBelowTheGround) {
  bake::Primitive hill{Material::kForestFloor, {}, {}, {}, {}, {}};
  const auto at = [](double x, double y) { return Vec3{x, y, 120 - 0.2 * std::abs(x) - 0.15 * std::abs(y)}; };
  for (double y = -400; y < 400; y += 40)
    for (double x = -400; x < 400; x += 40) add_quad(hill, at(x, y), at(x + 40, y), at(x + 40, y + 40), at(x, y + 40));
  const std::vector tiles = {tile({0, 0, 0}, {hill, box({-60, -60, 130}, {60, 60, 140}, Material::kBroadLeaf),
                                              box({-200, -200, 60}, {-190, -190, 90}, Material::kBroadLeaf)})};
  for (const char* name : kViews) {
    const Camera camera = *named_view(tiles, name);
    const World world(tiles, camera.eye);
    // one may stand below trees
    const auto above = world.first_hit(camera.eye - world.origin(), {0, 0, 1});
    EXPECT_TRUE(!above || above->material == Material::kBroadLeaf) << name;
    const auto below = world.first_hit(camera.eye - world.origin(), {0, 0, -1});
    if (name == std::string("street")) {
      ASSERT_TRUE(below);
      EXPECT_NEAR(below->distance_m, 1.7, 0.05);
      EXPECT_TRUE(below->is_front);
    }
  }
}

// Streets below crowns are as good as others: a closed roof of leaves over the only street of the village.
TEST(NamedView, AStreetMayBeBelowTrees) {
  bake::BakedTile place = village({0, 0, 0});
  place.primitives.push_back(box({-30, -220, 5}, {30, 220, 7}, Material::kBroadLeaf));
  const std::vector tiles = {place};
  const Camera camera = *named_view(tiles, "street");
  EXPECT_LE(std::abs(camera.eye.x), 6);
  EXPECT_NEAR(camera.eye.z, 1.75, 0.06);  // on the street, or beside it
}

// Walls behind low crowns are seen: of two equal villages the one with crowns at its walls has a view into the street.
TEST(NamedView, CrownsHideNoWalls) {
  bake::BakedTile place = village({0, 0, 0});
  place.primitives.push_back(box({-7.5, -220, 2.5}, {-5, 220, 7}, Material::kBroadLeaf));
  place.primitives.push_back(box({5, -220, 2.5}, {7.5, 220, 7}, Material::kBroadLeaf));
  const std::vector tiles = {place};
  const Camera camera = *named_view(tiles, "street");
  const Vec3 ahead = unit(camera.look_at - camera.eye);
  EXPECT_LE(std::abs(camera.eye.x), 4);
  // turned by a third of the picture, since both sides have walls
  EXPECT_GT(std::abs(ahead.x), 0.1);
  EXPECT_GT(std::abs(ahead.y), 0.8);
}

TEST(NamedView, ContentIsVariedAndCloseWallsCount) {
  const std::vector tiles = {village({0, 0, 0})};
  const World world(tiles, {0, 0, 2});
  const PictureContent along = content_of(world, {{0, 0, 2}, {0, 40, 3}, 46});
  const PictureContent at_wall = content_of(world, {{5, 0, 2}, {45, 0, 2}, 46});
  EXPECT_GT(along.variety_bits, 1);
  EXPECT_LT(along.variety_bits, 2.33);  // five materials at most
  EXPECT_LT(along.close_walls, at_wall.close_walls);
  EXPECT_GT(at_wall.close_walls, 0.5);
}

TEST(NamedView, OverviewAndLowAreOfWhatIsBuilt) {
  const std::vector tiles = {village({3000, 1000, 50})};
  const Camera overview = *named_view(tiles, "overview"), top = *named_view(tiles, "top");
  EXPECT_LT(overview.eye.z - 50, (top.eye.z - 50) / 2);
  for (const double y : {820.0, 1180.0}) EXPECT_LT(std::abs(across(overview, Vec3{3013, y, 55} - overview.eye)), 1);
}

TEST(NamedView, WaterIsAlsoTheSea) {
  bake::BakedTile place = village({0, 0, 0});
  EXPECT_FALSE(named_view(std::vector{place}, "water"));
  place.primitives.push_back(floor({60, -300, 0.1}, {400, 300, 0.1}, Material::kSea));
  const Camera camera = *named_view(std::vector{place}, "water");
  EXPECT_GT(camera.eye.x, 60);
  EXPECT_NEAR(camera.eye.z, 3.1, 0.01);
  EXPECT_EQ(named_view(std::vector{place}, "river")->eye, camera.eye);
}

TEST(NamedView, AParkIsALawnWithTrees) {
  bake::BakedTile place = village({0, 0, 0});
  EXPECT_FALSE(named_view(std::vector{place}, "park"));
  place.primitives.push_back(box({100, 0, 0}, {104, 4, 12}, Material::kBroadLeaf));
  const Camera camera = *named_view(std::vector{place}, "park");
  EXPECT_NEAR(camera.eye.z, 1.7, 0.01);
  EXPECT_LT(std::abs(across(camera, Vec3{102, 2, 5} - camera.eye)), 1.1);
}

TEST(NamedView, AnUnknownNameListsTheKnownOnes) {
  const std::vector tiles = {village({0, 0, 0})};
  for (const char* unknown : {"nowhere", "", "Overview"}) {
    const Result<Camera> camera = named_view(tiles, unknown);
    ASSERT_FALSE(camera);
    EXPECT_EQ(camera.error().where, std::string("--view ") + unknown);
    for (const char* name : kViews) EXPECT_NE(camera.error().message.find(name), std::string::npos) << name;
  }
}

TEST(NamedView, PlacesThatAreNotFiniteChangeNoView) {
  const std::vector plain = {village({0, 0, 0})};
  std::vector spoilt = plain;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kFar = std::numeric_limits<float>::infinity();
  for (const bake::Float3& bad : {bake::Float3{0, 0, kFar}, {0, 0, -kFar}, {kNan, 0, 5000}, {0, kFar, -5000}}) {
    bake::Primitive& ground = spoilt[0].primitives[0];
    ground.positions.push_back(bad);
    ground.normals.push_back({0, 0, 1});
    ground.colours.push_back(materials::kNoTint);
    ground.features.push_back(0);
  }
  for (const char* name : kViews) {
    const Camera a = *named_view(plain, name), b = *named_view(spoilt, name);
    EXPECT_EQ(a.eye, b.eye) << name;
    EXPECT_EQ(a.look_at, b.look_at) << name;
  }
}

TEST(NamedView, NothingAtAllStillHasViews) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<bake::BakedTile>> scenes = {
      {}, {tile({0, 0, 0}, {})}, {tile({0, 0, 0}, {floor({nan, 0, 0}, {1, nan, 0}, Material::kAsphalt)})}};
  for (const auto& tiles : scenes)
    for (const char* name : kViews) {
      const Result<Camera> camera = named_view(tiles, name);
      ASSERT_TRUE(camera) << name;
      EXPECT_TRUE(is_finite(*camera)) << name;
    }
}

}  // namespace
}  // namespace citykiln::preview
