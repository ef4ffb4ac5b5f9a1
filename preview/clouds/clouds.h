// The clouds of a picture.
#pragma once

#include <span>

#include "preview/clouds/cloud_dome.h"
#include "preview/clouds/cloud_field.h"
#include "preview/clouds/cloud_shadow.h"

namespace citykiln::preview {

/// How the light of clouds that are seen directly, or in mirrors, is found: by CloudField's approximation, or by
/// following one path of light through the droplets for each ray (cloud_paths.h), which is noisy.
enum class CloudMethod { kApproximate, kPaths };

/// Thread-safe; the same bits for any number of threads.
class Clouds {
 public:
  /// @param eye  Plane metres. @param finest  As for CloudSpheres.
  Clouds(std::span<const sky::CloudLayer> layers, const sky::SkyModel& model, Vec3 eye, double finest,
         CloudMethod method, int threads);

  /// What rays of the camera and of mirrors see.
  /// @param from  Plane metres; z above sea level. @param direction  Unit vector.
  CloudPath seen(Vec3 from, Vec3 direction, double distance_m) const;
  /// What falls on surfaces: by a table below the clouds, else as seen.
  CloudVeil falling(Vec3 from, Vec3 direction) const;
  /// The share of the sun's light that reaches a place: by a table below the clouds and near the eye.
  double sun_passed(Vec3 from) const;

 private:
  sky::SkyModel model_;
  CloudField field_;
  CloudShadow shadow_;
  CloudDome dome_;
  CloudMethod method_;
};

}  // namespace citykiln::preview
