#include "preview/camera/camera_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

constexpr double kNearAhead_m = 10, kFarAhead_m = 40;
constexpr int kAheadSteps = 7;

// A line with the distance of each point along it.
class Track {
 public:
  explicit Track(std::span<const Vec3> line) {
    for (const Vec3& p : line) {
      const double at_m = points_.empty() ? 0 : along_m_.back() + length(p - points_.back());
      // points that coincide have no direction
      if (!points_.empty() && at_m == along_m_.back()) continue;
      points_.push_back(p), along_m_.push_back(at_m);
    }
  }

  double length_m() const { return along_m_.back(); }

  // The point at a distance along the line, beyond its ends straight on.
  Vec3 at(double distance_m) const {
    if (points_.size() == 1) return points_.front() + Vec3{0, distance_m, 0};
    const auto after = std::ranges::upper_bound(along_m_, distance_m) - along_m_.begin();
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(points_) - 1));
    const double share = (distance_m - along_m_[i - 1]) / (along_m_[i] - along_m_[i - 1]);
    return points_[i - 1] + (points_[i] - points_[i - 1]) * share;
  }

 private:
  std::vector<Vec3> points_;
  std::vector<double> along_m_;
};

Vec3 ahead_of(const Track& track, double at_m) {
  Vec3 sum;
  for (int i = 0; i < kAheadSteps; ++i)
    sum = sum + track.at(at_m + kNearAhead_m + (kFarAhead_m - kNearAhead_m) * i / (kAheadSteps - 1));
  return sum * (1.0 / kAheadSteps);
}

Pose pose_at(const Track& track, double at_m, const Film& film) {
  return {track.at(at_m), film.look_at ? *film.look_at : ahead_of(track, at_m)};
}

Camera camera_between(const Pose& open, const Pose& closed, const Film& film) {
  Camera camera{.eye = open.eye, .look_at = open.look_at, .vertical_fov_deg = film.vertical_fov_deg};
  if (film.shutter_s > 0) camera.shutter_end = closed;
  return camera;
}

}  // namespace

double length_m(std::span<const Vec3> line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += length(line[i] - line[i - 1]);
  return sum;
}

std::vector<Camera> cameras_along(std::span<const Vec3> line, const Film& film) {
  assert(!line.empty() && film.frames > 0);
  const Track track(line);
  const double step_m = film.frames > 1 ? track.length_m() / (film.frames - 1) : track.length_m();
  const double open_m = step_m * kFramesPerSecond * film.shutter_s;
  std::vector<Camera> cameras;
  for (int frame = 0; frame < film.frames; ++frame) {
    const double at_m = frame * step_m;
    cameras.push_back(camera_between(pose_at(track, at_m, film), pose_at(track, at_m + open_m, film), film));
  }
  return cameras;
}

std::vector<Camera> turntable(const Camera& first, const Film& film) {
  assert(film.frames > 0);
  const auto turned = [](Vec3 v, double turns) {
    const double angle = 2 * std::numbers::pi * turns, c = std::cos(angle), s = std::sin(angle);
    return Vec3{c * v.x - s * v.y, s * v.x + c * v.y, v.z};
  };
  const auto pose = [&](double turns) {
    return Pose{first.look_at + turned(first.eye - first.look_at, turns), first.look_at};
  };
  std::vector<Camera> cameras;
  for (int frame = 0; frame < film.frames; ++frame) {
    const double open = frame, closed = frame + film.shutter_s * kFramesPerSecond;
    Camera camera = camera_between(pose(open / film.frames), pose(closed / film.frames), film);
    camera.vertical_fov_deg = first.vertical_fov_deg;
    camera.lens_radius_m = first.lens_radius_m, camera.focus_m = first.focus_m;
    camera.up = turned(first.up, open / film.frames);
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace citykiln::preview
