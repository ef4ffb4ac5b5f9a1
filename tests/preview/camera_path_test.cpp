#include "preview/camera/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::preview {
namespace {

// 100 m east, then 100 m north.
const std::vector<Vec3> kCorner = {{0, 0, 2}, {100, 0, 2}, {100, 0, 2}, {100, 100, 2}};

TEST(CamerasAlong, AreEquallyFarApartFromEndToEnd) {
  const auto cameras = cameras_along(kCorner, {.frames = 21});
  ASSERT_EQ(cameras.size(), 21u);
  EXPECT_EQ(cameras.front().eye, kCorner.front());
  EXPECT_LT(length(cameras.back().eye - kCorner.back()), 1e-9);
  for (std::size_t i = 1; i < cameras.size(); ++i)
    EXPECT_NEAR(length(cameras[i].eye - cameras[i - 1].eye), 10, 1e-9) << i;
}

TEST(CamerasAlong, TurnGraduallyAtACorner) {
  const auto cameras = cameras_along(kCorner, {.frames = 201});
  for (std::size_t i = 1; i < cameras.size(); ++i) {
    const Vec3 a = unit(cameras[i - 1].look_at - cameras[i - 1].eye), b = unit(cameras[i].look_at - cameras[i].eye);
    EXPECT_LT(std::acos(std::min(1.0, dot(a, b))), 0.16) << i;
  }
  EXPECT_NEAR(unit(cameras.back().look_at - cameras.back().eye).y, 1, 1e-9);
}

TEST(CamerasAlong, ASingleFrameIsAtTheFirstPlace) {
  const auto cameras = cameras_along(kCorner, {.frames = 1, .look_at = Vec3{7, 8, 9}});
  ASSERT_EQ(cameras.size(), 1u);
  EXPECT_EQ(cameras[0].eye, kCorner[0]);
  EXPECT_EQ(cameras[0].look_at, (Vec3{7, 8, 9}));
}

TEST(CamerasAlong, PlacesThatCoincideAreOne) {
  const std::vector<Vec3> still = {{1, 2, 3}, {1, 2, 3}};
  for (const Camera& camera : cameras_along(still, {.frames = 3})) {
    EXPECT_EQ(camera.eye, (Vec3{1, 2, 3}));
    EXPECT_TRUE(std::isfinite(camera.look_at.x) && length(camera.look_at - camera.eye) > 1);
  }
}

// Half a frame's time is half a frame's way.
TEST(CamerasAlong, AnOpenShutterMovesAsFarAsItsTime) {
  const auto cameras = cameras_along(kCorner, {.frames = 21, .shutter_s = 0.02});
  ASSERT_TRUE(cameras[3].shutter_end);
  EXPECT_NEAR(length(cameras[3].shutter_end->eye - cameras[3].eye), 5, 1e-9);
  EXPECT_FALSE(cameras_along(kCorner, {.frames = 21})[3].shutter_end);
}

TEST(Turntable, GoesAroundOnceAtTheSameDistance) {
  const Camera first{{10, 0, 5}, {0, 0, 1}, 40};
  const auto cameras = turntable(first, {.frames = 4});
  ASSERT_EQ(cameras.size(), 4u);
  EXPECT_LT(length(cameras[0].eye - first.eye), 1e-12);
  EXPECT_LT(length(cameras[1].eye - Vec3{0, 10, 5}), 1e-9);
  EXPECT_LT(length(cameras[3].eye - Vec3{0, -10, 5}), 1e-9);
  for (const Camera& camera : cameras) EXPECT_EQ(camera.vertical_fov_deg, 40);
}

TEST(Turntable, KeepsTheLensTheFocusAndTheVerticalOfTheFirstCamera) {
  Camera first{{10, 0, 5}, {0, 0, 1}, 40};
  first.lens_radius_m = 0.01, first.focus_m = 7, first.up = {0.6, 0, 0.8};
  const auto cameras = turntable(first, {.frames = 4});
  EXPECT_EQ(cameras[0].up, first.up);
  EXPECT_LT(length(cameras[1].up - Vec3{0, 0.6, 0.8}), 1e-9);
  for (const Camera& camera : cameras) {
    EXPECT_EQ(camera.lens_radius_m, 0.01);
    EXPECT_EQ(camera.focus_m, 7);
  }
}

}  // namespace
}  // namespace citykiln::preview
