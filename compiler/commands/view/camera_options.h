// The options of `preview` that choose cameras.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/commands/verb.h"
#include "compiler/commands/view/preview_scene.h"
#include "compiler/commands/view/view_options.h"
#include "preview/camera/camera.h"

namespace citykiln::commands {

/// The opening of a lens, as a diameter or as an f-number. The f-number refers to the focal length that gives the field
/// of view on a frame of 36 by 24 mm.
struct Aperture {
  double diameter_mm = 0, f_number = 0;  ///< One of the two is 0.
};

/// The focus of a lens: a distance along the view, or a point.
struct Focus {
  std::optional<double> distance_m{};
  std::optional<GivenPoint> at{};
};

/// The values of the options.
struct CameraRequest {
  std::string view = "overview";
  std::optional<GivenPoint> eye{}, look_at{};             ///< Plane metres.
  std::optional<GivenPoint> eye_lonlat{}, look_lonlat{};  ///< Longitude and latitude in degrees, height in metres.
  std::optional<double> fov_deg{};
  std::optional<Aperture> aperture{};
  Focus focus{};
  std::string path{};  ///< The path of a GeoJSON file with a LineString.
  std::optional<double> speed_m_s{};
  std::optional<int> frames{}, turntable{};
  double shutter_s = 0;

  /// True if numbered pictures are requested.
  bool is_film() const { return !path.empty() || turntable.has_value(); }
  /// True if the camera is chosen by a named view of the scene.
  bool finds_view() const { return path.empty() && !eye && !eye_lonlat; }
};

/// Returns the options, which store their values in the request. It must outlive them.
std::vector<Option> camera_options(CameraRequest& request);

/// Returns the cameras of all frames; a single camera unless a film is requested. Errors: a point above the ground
/// where there is no ground; longitude and latitude without a scene that defines the plane; options that contradict
/// each other; a path that cannot be read.
Result<std::vector<preview::Camera>> cameras_of(const CameraRequest& request, const PreviewScene& scene,
                                                const Console& console);

}  // namespace citykiln::commands
