// The options of preview that choose cameras.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/commands/preview_scene.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/view_options.h"
#include "preview/camera/camera.h"

namespace citykiln::commands {

/// The opening of a lens: a diameter, or an f-number of the lens that shows the field of view on a frame of 36 by 24
/// mm.
struct Aperture {
  double diameter_mm = 0, f_number = 0;  ///< One of both is 0.
};

/// What a lens is focused on: a distance along the view, or a point.
struct Focus {
  std::optional<double> distance_m{};
  std::optional<GivenPoint> at{};
};

/// What was asked for.
struct CameraRequest {
  std::string view = "overview";
  std::optional<GivenPoint> eye{}, look_at{};             ///< Plane metres.
  std::optional<GivenPoint> eye_lonlat{}, look_lonlat{};  ///< Longitude and latitude in degrees, height in metres.
  std::optional<double> fov_deg{};
  std::optional<Aperture> aperture{};
  Focus focus{};
  std::string path{};  ///< Of a GeoJSON file.
  std::optional<double> speed_m_s{};
  std::optional<int> frames{}, turntable{};
  double shutter_s = 0;

  /// Whether numbered pictures are asked for.
  bool is_film() const { return !path.empty() || turntable.has_value(); }
  /// Whether the scene decides where the camera is.
  bool finds_view() const { return path.empty() && !eye && !eye_lonlat; }
};

std::vector<Option> camera_options(CameraRequest& request);

/// The cameras of all frames; one unless a film is asked for. Errors: points without a ground or a plane to refer to,
/// options that contradict each other, a path that cannot be read.
Result<std::vector<preview::Camera>> cameras_of(const CameraRequest& request, const PreviewScene& scene,
                                                const Console& console);

}  // namespace citykiln::commands
