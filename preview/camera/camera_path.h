// Cameras of a film: along a line, or around a point.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "preview/camera/camera.h"

namespace citykiln::preview {

/// Frames of a film, per second.
inline constexpr double kFramesPerSecond = 25;

/// Pictures along a way.
struct Film {
  int frames = 1;
  double shutter_s = 0;           ///< Time for which the shutter of each frame is open.
  std::optional<Vec3> look_at{};  ///< What all frames look at; empty: ahead.
  double vertical_fov_deg = 60;
};

/// The length of a line of points.
double length_m(std::span<const Vec3> line);

/// Cameras at equal distances from the first to the last point of a line; a single frame is at the first. Without
/// look_at a camera looks at the mean of the line from 10 m to 40 m ahead, so that it turns gradually at corners, and
/// past the end straight on.
/// @param line  Plane metres. At least 1 point.
std::vector<Camera> cameras_along(std::span<const Vec3> line, const Film& film);

/// Cameras around `first.look_at`, counter-clockwise from above, from `first` through a whole turn; the last is one
/// step before the first.
std::vector<Camera> turntable(const Camera& first, const Film& film);

}  // namespace citykiln::preview
