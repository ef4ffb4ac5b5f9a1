// The clouds of a picture.
#pragma once

#include <span>

#include "preview/clouds/cloud_dome.h"
#include "preview/clouds/cloud_field.h"
#include "preview/clouds/cloud_panorama.h"
#include "preview/clouds/cloud_shadow.h"

namespace citykiln::preview {

/// The method for clouds that are seen directly or in mirrors: an approximation (CloudField), or one random path of
/// light through the droplets for each ray (cloud_paths.h), which is exact but noisy.
enum class CloudMethod { kApproximate, kPaths };

/// All clouds of a picture, with their tables. Thread-safe; the same bits for any number of threads.
class Clouds {
 public:
  /// @param eye        Plane metres.
  /// @param pixel_rad  The angle of a pixel.
  Clouds(std::span<const sky::CloudLayer> layers, const sky::SkyModel& model, Vec3 eye, double pixel_rad,
         CloudMethod method, int threads);

  /// Returns the clouds that a ray of the camera, or of a mirror, sees. Rays that end in the sky are read from a
  /// panorama, with the detail of a pixel for the camera, and less for mirrors.
  /// @param from  Plane metres; z above sea level.
  /// @param direction  Unit vector.
  CloudPath seen(Vec3 from, Vec3 direction, double distance_m, bool is_camera) const;
  /// Returns the effect of clouds, and of the air before them, on skylight that falls on a surface from a direction.
  /// Below the clouds it is read from a table.
  CloudVeil falling(Vec3 from, Vec3 direction) const;
  /// Returns the share of the sun's light that reaches a place. Below the clouds and near the eye it is read from a
  /// table.
  double sun_passed(Vec3 from) const;

 private:
  sky::SkyModel model_;
  CloudField field_;
  CloudShadow shadow_;
  CloudDome dome_;
  CloudPanorama panorama_, mirrored_;
  CloudMethod method_;
};

}  // namespace citykiln::preview
