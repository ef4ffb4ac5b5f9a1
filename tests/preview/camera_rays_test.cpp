#include "preview/camera/camera_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

const Camera kLens{.eye = {3, 4, 5}, .look_at = {3, 14, 5}, .vertical_fov_deg = 60, .lens_radius_m = 0.5, .focus_m = 8};

// The point of a ray at a distance along the view, which is to the north.
Vec3 at_depth(const CameraRay& ray, double depth_m) {
  return ray.from + ray.direction * ((4 + depth_m - ray.from.y) / ray.direction.y);
}

PathDraw draw_of(const PixelSamples& samples, std::uint32_t i) { return {samples, i}; }

TEST(CameraRays, OfALensMeetInThePlaneInFocus) {
  const CameraRays rays(kLens, 160, 90);
  const PixelSamples samples(1, 2, 3, grid_of(160, 90, 64));
  PathDraw first = draw_of(samples, 0);
  const Vec3 meeting = at_depth(rays.through(30, 20, first), 8);
  double widest_m = 0;
  for (std::uint32_t i = 1; i < 64; ++i) {
    PathDraw draw = draw_of(samples, i);
    const CameraRay ray = rays.through(30, 20, draw);
    EXPECT_LT(length(at_depth(ray, 8) - meeting), 1e-9);
    EXPECT_LE(length(ray.from - kLens.eye), 0.5 + 1e-12);
    widest_m = std::max(widest_m, length(at_depth(ray, 16) - at_depth(rays.through(30, 20, first), 16)));
  }
  // twice as far away a point is blurred to the size of the lens
  EXPECT_GT(widest_m, 0.3);
}

// A pinhole draws nothing, so that its other samples are those of before there were lenses.
TEST(CameraRays, OfAPinholeDrawNothing) {
  Camera pinhole = kLens;
  pinhole.lens_radius_m = 0;
  const CameraRays rays(pinhole, 160, 90);
  const PixelSamples samples(1, 2, 3, grid_of(160, 90, 64));
  PathDraw used = draw_of(samples, 5), fresh = draw_of(samples, 5);
  EXPECT_EQ(rays.through(30, 20, used).from, pinhole.eye);
  EXPECT_EQ(used.next().u, fresh.next().u);
}

TEST(CameraRays, CornersAreTheFieldOfView) {
  Camera pinhole = kLens;
  pinhole.lens_radius_m = 0;
  const CameraRays rays(pinhole, 160, 90);
  const PixelSamples samples(1, 2, 3, grid_of(1, 1, 1));
  PathDraw draw = draw_of(samples, 0);
  const Vec3 top = rays.through(80, 0, draw).direction, bottom = rays.through(80, 90, draw).direction;
  EXPECT_NEAR(std::acos(dot(top, bottom)), 60 * std::numbers::pi / 180, 1e-12);
  EXPECT_GT(top.z, 0);
  EXPECT_GT(rays.through(160, 45, draw).direction.x, 0);
}

TEST(CameraRays, OfAMovingCameraStartAlongItsWay) {
  Camera moving = kLens;
  moving.lens_radius_m = 0;
  moving.shutter_end = Pose{{5, 4, 5}, {5, 14, 5}};
  const CameraRays rays(moving, 160, 90);
  const PixelSamples samples(1, 2, 3, grid_of(160, 90, 64));
  double least = 9, most = 0, sum = 0;
  for (std::uint32_t i = 0; i < 64; ++i) {
    PathDraw draw = draw_of(samples, i);
    const double x = rays.through(80, 45, draw).from.x;
    least = std::min(least, x), most = std::max(most, x), sum += x;
  }
  EXPECT_GE(least, 3);
  EXPECT_LE(most, 5);
  EXPECT_NEAR(sum / 64, 4, 0.02);
  EXPECT_GT(most - least, 1.9);
}

}  // namespace
}  // namespace citykiln::preview
