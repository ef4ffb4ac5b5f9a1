// Cameras of a film: along a line, or around a point.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "preview/camera/camera.h"

namespace citykiln::preview {

/// Frames of a film per second.
inline constexpr double kFramesPerSecond = 25;

/// The frames of a film, for cameras along a line or around a point.
struct Film {
  int frames = 1;
  double shutter_s = 0;           ///< Time for which the shutter of each frame is open.
  std::optional<Vec3> look_at{};  ///< The point that all frames look at; empty: they look ahead.
  double vertical_fov_deg = 60;
};

/// Returns the length of a polyline.
double length_m(std::span<const Vec3> line);

/// Returns cameras at equal distances from the first to the last point of a line. A single frame is at the first point.
/// Without look_at a camera looks at the mean of the line from 10 m to 40 m ahead, so that it turns gradually at
/// corners; beyond its end the line continues straight.
/// @param line  Plane metres. At least 1 point.
std::vector<Camera> cameras_along(std::span<const Vec3> line, const Film& film);

/// Returns cameras on a circle around `first.look_at`, counter-clockwise from above. The first camera is `first`; the
/// last one is a step before it. All have its field of view, lens and focus, and its vertical turns with them. Only
/// `frames` and `shutter_s` of the film count.
std::vector<Camera> turntable(const Camera& first, const Film& film);

}  // namespace citykiln::preview
