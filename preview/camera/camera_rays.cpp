#include "preview/camera/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

// A uniform point of the unit disk. Shirley, Chiu, "A Low Distortion Map Between Disk and Square", JGT 2(3), 1997.
Vec2 on_disk(UnitPair chance) {
  const double x = 2 * chance.u - 1, y = 2 * chance.v - 1;
  if (x == 0 && y == 0) return {};
  constexpr double kEighth = std::numbers::pi / 4;
  const bool is_wide = std::abs(x) > std::abs(y);
  const double radius = is_wide ? x : y, angle = is_wide ? kEighth * y / x : 2 * kEighth - kEighth * x / y;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Pose pose_between(const Pose& a, const Pose& b, double share) {
  return {a.eye + (b.eye - a.eye) * share, a.look_at + (b.look_at - a.look_at) * share};
}

}  // namespace

ViewAxes axes_of(const Pose& pose, Vec3 vertical) {
  const Vec3 sight = unit(pose.look_at - pose.eye), forward = dot(sight, sight) > 0 ? sight : Vec3{0, 1, 0};
  // north, where it is not along the sight
  const Vec3 north = unit(cross(vertical, Vec3{1, 0, 0}));
  const Vec3 pole = std::abs(dot(forward, vertical)) > 0.9999 ? north : vertical;
  const Vec3 right = unit(cross(forward, pole));
  return {forward, right, cross(right, forward)};
}

Camera bent(Camera camera, const map::Cylinder& cylinder) {
  const auto place = [&](Vec3& p) { p = map::at(cylinder, p).at; };
  camera.up = map::at(cylinder, camera.eye).up;
  place(camera.eye), place(camera.look_at);
  if (camera.shutter_end) place(camera.shutter_end->eye), place(camera.shutter_end->look_at);
  return camera;
}

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : camera_(camera),
      width_(width),
      height_(height),
      half_height_(std::tan(std::clamp(camera.vertical_fov_deg, 0.01, 179.0) * std::numbers::pi / 360)) {
  half_width_ = half_height_ * width_ / height_;
  axes_ = axes_of({camera.eye, camera.look_at}, camera.up);
}

CameraRay CameraRays::through(double x, double y, PathDraw& draw) const {
  Pose pose{camera_.eye, camera_.look_at};
  ViewAxes axes = axes_;
  if (camera_.shutter_end) {
    pose = pose_between(pose, *camera_.shutter_end, draw.next().u);
    axes = axes_of(pose, camera_.up);
  }
  const auto& [forward, right, up] = axes;
  const double px = (2 * x / width_ - 1) * half_width_, py = (1 - 2 * y / height_) * half_height_;
  const Vec3 sight = forward + right * px + up * py;
  if (camera_.lens_radius_m <= 0) return {pose.eye, unit(sight)};
  const double focus_m = camera_.focus_m > 0 ? camera_.focus_m : std::max(length(pose.look_at - pose.eye), 1e-3);
  const Vec2 lens = on_disk(draw.next()) * camera_.lens_radius_m;
  const Vec3 aside = right * lens.x + up * lens.y;
  return {pose.eye + aside, unit(sight * focus_m - aside)};
}

}  // namespace citykiln::preview
