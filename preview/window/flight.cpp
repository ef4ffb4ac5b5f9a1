#include "preview/window/flight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "preview/camera/camera_rays.h"

namespace citykiln::preview {
namespace {

constexpr double kSpeed_m_s = 20, kFast = 10;

// Longest time of one step: after a pause the camera does not jump.
constexpr double kLongest_s = 0.2;

constexpr double kSteepest_rad = 89 * std::numbers::pi / 180;

// The view's direction, turned to the right and down by angles.
Vec3 turned_view(Vec3 forward, double right_rad, double down_rad) {
  const double bearing = std::atan2(forward.x, forward.y) + right_rad;
  const double rise = std::clamp(std::asin(std::clamp(forward.z, -1.0, 1.0)) - down_rad, -kSteepest_rad, kSteepest_rad);
  return {std::sin(bearing) * std::cos(rise), std::cos(bearing) * std::cos(rise), std::sin(rise)};
}

}  // namespace

bool is_moving(const CitykilnInput& input) {
  return input.ahead != 0 || input.aside != 0 || input.upward != 0 || input.turn_px != 0 || input.tilt_px != 0;
}

Camera moved(const Camera& camera, const CitykilnInput& input) {
  const ViewAxes axes = axes_of({camera.eye, camera.look_at});
  const double far_m = std::max(length(camera.look_at - camera.eye), 1.0);
  const double pixel_rad = camera.vertical_fov_deg * std::numbers::pi / 180 / std::max(input.height, 1);
  const double step_m = kSpeed_m_s * (input.is_fast != 0 ? kFast : 1) * std::clamp(input.seconds, 0.0, kLongest_s);
  const Vec3 way = axes.forward * input.ahead + axes.right * input.aside + Vec3{0, 0, input.upward};
  Camera next = camera;
  next.eye = camera.eye + unit(way) * step_m;
  const bool turns = input.turn_px != 0 || input.tilt_px != 0;
  const Vec3 forward =
      turns ? turned_view(axes.forward, input.turn_px * pixel_rad, input.tilt_px * pixel_rad) : axes.forward;
  next.look_at = next.eye + forward * far_m;
  return next;
}

}  // namespace citykiln::preview
