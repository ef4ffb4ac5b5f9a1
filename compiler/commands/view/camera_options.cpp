#include "compiler/commands/view/camera_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/commands/view/ground_height.h"
#include "compiler/commands/view/read_line_string.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/map/plane/plane.h"
#include "preview/camera/camera_path.h"
#include "preview/camera/camera_rays.h"
#include "preview/camera/view_names.h"

namespace citykiln::commands {
namespace {

// Places of a path without heights are this far above the ground.
constexpr double kAboveGround_m = 2;

// The largest distance between points of a path at which the ground's height is looked up.
constexpr double kHeightStep_m = 5;

constexpr int kMostFrames = 100'000;

// Speed of a path for which neither a speed nor a number of frames is given: a bicycle.
constexpr double kSpeed_m_s = 5;

StoreValue store_aperture(std::optional<Aperture>& aperture) {
  return [&aperture](const std::string& text) -> Result<Done> {
    const bool is_f_number = text.starts_with("f/");
    const auto number = number_in<double>(std::string_view(text).substr(is_f_number ? 2 : 0));
    if (!number || *number <= 0 || *number > 1e6)
      return Error{"", fmt::format("expected an f-number such as f/2.8, or a diameter in millimetres such as 25, found "
                                   "\"{}\"",
                                   text)};
    aperture = is_f_number ? Aperture{.f_number = *number} : Aperture{.diameter_mm = *number};
    return Done{};
  };
}

StoreValue store_focus(Focus& focus) {
  return [&focus](const std::string& text) -> Result<Done> {
    focus = {};
    if (text.find(',') != std::string::npos) return store_point(focus.at)(text);
    const auto number = number_in<double>(text);
    if (!number || *number <= 0)
      return Error{"", fmt::format("expected a distance in metres or a place X,Y,Z, found \"{}\"", text)};
    focus.distance_m = *number;
    return Done{};
  };
}

StoreValue store_frames(std::optional<int>& frames) {
  return [&frames](const std::string& text) -> Result<Done> {
    const auto number = number_in<int>(text);
    if (!number || *number < 1 || *number > kMostFrames)
      return Error{"", fmt::format("expected a number of frames from 1 to {}, found \"{}\"", kMostFrames, text)};
    frames = *number;
    return Done{};
  };
}

// The lens of a camera, as asked for.
void add_lens(preview::Camera& camera, const CameraRequest& request, const std::optional<Vec3>& focus) {
  if (request.fov_deg) camera.vertical_fov_deg = *request.fov_deg;
  if (!request.aperture) return;
  // a frame of 24 mm height
  const double focal_mm = 12 / std::tan(camera.vertical_fov_deg * std::numbers::pi / 360);
  const double diameter_mm =
      request.aperture->f_number > 0 ? focal_mm / request.aperture->f_number : request.aperture->diameter_mm;
  camera.lens_radius_m = diameter_mm / 2000;
  camera.focus_m = request.focus.distance_m.value_or(0);
  if (focus)
    camera.focus_m = std::max(dot(*focus - camera.eye, preview::axes_of({camera.eye, camera.look_at}).forward), 0.01);
}

// Returns the path in plane metres, with points close enough for the ground's height. Points without a height are above
// the ground.
Result<std::vector<Vec3>> line_of(const CameraRequest& request, const PreviewScene& scene,
                                  const GroundHeight& ground_m) {
  const auto places = read_line_string(request.path);
  if (!places) return places.error();
  if (!scene.loaded.header)
    return Error{"--path", "needs the scene's origin: give the manifest, or the folder that contains it"};
  const map::Plane plane(scene.loaded.header->origin);
  std::vector<Vec3> line;
  const auto add = [&](Vec2 at, std::optional<double> height_m) {
    if (!height_m) height_m = ground_m(at);
    // outside of the scene: as high as before
    line.push_back(at_height(at, height_m ? *height_m + kAboveGround_m : line.empty() ? 0 : line.back().z));
  };
  for (std::size_t i = 0; i < places->size(); ++i) {
    const LonLatHeight& place = (*places)[i];
    const Vec2 to = plane.forward({place.lon_deg, place.lat_deg});
    const auto given = [&] { return place.height_m ? std::optional(*place.height_m - kAboveGround_m) : std::nullopt; };
    if (!line.empty() && !place.height_m) {
      const Vec2 from = in_plan(line.back());
      const int steps = static_cast<int>(std::min(std::ceil(distance(from, to) / kHeightStep_m), 10'000.0));
      for (int step = 1; step < steps; ++step) add(from + (to - from) * (static_cast<double>(step) / steps), {});
    }
    add(to, given());
  }
  return line;
}

struct Points {
  std::optional<Vec3> eye, look_at, focus;
};

Result<Points> points_of(const CameraRequest& request, const PreviewScene& scene, const GroundHeight& ground_m) {
  const auto point = [&](const auto& in_plane, const auto& lonlat) {
    return point_of(in_plane, lonlat, scene.loaded.header, ground_m);
  };
  const Result<std::optional<Vec3>> eye = point(request.eye, request.eye_lonlat);
  if (!eye) return eye.error();
  const Result<std::optional<Vec3>> look_at = point(request.look_at, request.look_lonlat);
  if (!look_at) return look_at.error();
  const Result<std::optional<Vec3>> focus = point(request.focus.at, std::optional<GivenPoint>());
  if (!focus) return focus.error();
  return Points{*eye, *look_at, *focus};
}

std::optional<Error> contradiction_in(const CameraRequest& request) {
  if (!request.path.empty() && request.turntable) return Error{"--turntable", "cannot be combined with --path"};
  if (request.path.empty() && (request.speed_m_s || request.frames))
    return Error{request.speed_m_s ? "--speed" : "--frames", "needs --path"};
  if (request.speed_m_s && request.frames) return Error{"--speed", "cannot be combined with --frames"};
  if (request.shutter_s > 0 && !request.is_film()) return Error{"--shutter", "needs --path or --turntable"};
  if ((request.focus.distance_m || request.focus.at) && !request.aperture) return Error{"--focus", "needs --aperture"};
  return std::nullopt;
}

Result<std::vector<preview::Camera>> path_cameras(const CameraRequest& request, const PreviewScene& scene,
                                                  const GroundHeight& ground_m, const Points& points) {
  const Result<std::vector<Vec3>> line = line_of(request, scene, ground_m);
  if (!line) return line.error();
  const double seconds = preview::length_m(*line) / request.speed_m_s.value_or(kSpeed_m_s);
  const double count = std::floor(seconds * preview::kFramesPerSecond) + 1;
  if (!request.frames && count > kMostFrames)
    return Error{"--path", fmt::format("needs {:.0f} frames; at most {} are made: give a higher --speed, or --frames",
                                       count, kMostFrames)};
  return preview::cameras_along(*line, {.frames = request.frames ? *request.frames : static_cast<int>(count),
                                        .shutter_s = request.shutter_s,
                                        .look_at = points.look_at});
}

// Corrects a view that was chosen on coarse ground: a camera near the ground keeps its height above it.
preview::Camera on_ground(preview::Camera camera, const PreviewScene& scene, const GroundHeight& ground_m) {
  constexpr double kNear_m = 5;
  const std::optional<double> low_m = ground_height_m(scene.view_tiles(), in_plan(camera.eye));
  if (!low_m || camera.eye.z - *low_m > kNear_m) return camera;
  const std::optional<double> exact_m = ground_m(in_plan(camera.eye));
  if (exact_m) camera.eye.z += *exact_m - *low_m, camera.look_at.z += *exact_m - *low_m;
  return camera;
}

// The direction of the sun; empty while it is too low to light streets, and inside of a cylinder.
std::optional<Vec3> sun_over(const PreviewScene& scene) {
  constexpr double kLowest = 0.05;
  const sky::Sky& sky = scene.sky;
  return sky.inside || scene.loaded.cylinder || sky.to_sun.z < kLowest ? std::nullopt : std::optional(sky.to_sun);
}

Result<preview::Camera> still_camera(const CameraRequest& request, const PreviewScene& scene, const Points& points,
                                     const GroundHeight& ground_m) {
  if (points.eye) return preview::Camera{*points.eye, *points.look_at};
  const Result<preview::Camera> camera = preview::named_view(scene.view_tiles(), request.view, sun_over(scene));
  if (!camera) return camera.error();
  return on_ground(*camera, scene, ground_m);
}

}  // namespace

Result<std::vector<preview::Camera>> cameras_of(const CameraRequest& request, const PreviewScene& scene,
                                                const Console& console) {
  if (const auto contradiction = contradiction_in(request)) return *contradiction;
  const GroundHeight ground_m = [&](Vec2 place) { return scene.ground_height_m(place); };
  const Result<Points> points = points_of(request, scene, ground_m);
  if (!points) return points.error();
  if (request.path.empty() && points->eye.has_value() != points->look_at.has_value())
    return Error{"", "--eye and --look must be given together"};
  if (points->eye) note_if_below_ground(*points->eye, ground_m, console);
  std::vector<preview::Camera> cameras;
  if (!request.path.empty()) {
    Result<std::vector<preview::Camera>> along = path_cameras(request, scene, ground_m, *points);
    if (!along) return along.error();
    cameras = std::move(*along);
  } else {
    const Result<preview::Camera> camera = still_camera(request, scene, *points, ground_m);
    if (!camera) return camera.error();
    cameras = {*camera};
    if (request.turntable)
      cameras = preview::turntable(*camera, {.frames = *request.turntable, .shutter_s = request.shutter_s});
  }
  for (preview::Camera& camera : cameras) add_lens(camera, request, points->focus);
  return cameras;
}

std::vector<Option> camera_options(CameraRequest& request) {
  return {
      {"--view", preview::view_names("|"), "a view that is found in the scene by its name (default: overview)", false,
       store_text(request.view)},
      {"--eye", "X,Y,Z",
       "place of the viewer in plane metres, such as 0,-200,150, or 0,-200,+2 for 2 m above the ground; needs --look",
       false, store_point(request.eye)},
      {"--look", "X,Y,Z", "place in the middle of the picture, such as 0,0,20", false, store_point(request.look_at)},
      {"--eye-lonlat", "LON,LAT,HEIGHT", "place of the viewer in degrees and metres, such as 7.42,43.73,150", false,
       store_point(request.eye_lonlat)},
      {"--look-lonlat", "LON,LAT,HEIGHT", "place in the middle of the picture in degrees and metres", false,
       store_point(request.look_lonlat)},
      {"--fov", "DEG", "vertical field of view in degrees (default: 45)", false,
       store_number(request.fov_deg, kFieldsOfView_deg)},
      {"--aperture", "f/N|MM",
       "opening of a lens, which blurs what is out of focus: f/2.8 of a camera with a frame of 24 mm height, or a "
       "diameter in millimetres (default: a pinhole)",
       false, store_aperture(request.aperture)},
      {"--focus", "M|X,Y,Z", "distance or place in focus (default: that of --look); needs --aperture", false,
       store_focus(request.focus)},
      {"--path", "FILE.geojson",
       "numbered pictures along a LineString of longitude, latitude and height (default: 2 m above the ground), "
       "looking "
       "ahead, or at --look",
       false, store_text(request.path)},
      {"--speed", "M/S", "speed along --path at 25 frames a second (default: 5)", false,
       store_number(request.speed_m_s, {})},
      {"--frames", "N", "number of pictures along --path, instead of a speed", false, store_frames(request.frames)},
      {"--turntable", "N", "N numbered pictures from once around the place looked at", false,
       store_frames(request.turntable)},
      {"--shutter", "S",
       "time for which the shutter is open, at 25 frames a second, such as 0.02: motion blur of --path or --turntable "
       "(default: 0)",
       false, store_number(request.shutter_s, {0, 1, true})},
  };
}

}  // namespace citykiln::commands
