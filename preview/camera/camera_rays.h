// The rays of a camera through its picture.
#pragma once

#include "preview/camera/camera.h"
#include "preview/samples.h"

namespace citykiln::preview {

/// A ray of a camera.
struct CameraRay {
  Vec3 from, direction;  ///< The origin, in metres on the map plane with z up; a unit vector.
};

/// Unit vectors of a view: forward, right and up. If eye and look_at coincide, forward is north. A view straight up or
/// down has north as its up direction.
struct ViewAxes {
  Vec3 forward, right, up;
};
/// Returns the axes of a view.
///
/// @param vertical  The unit vector upwards at the place.
ViewAxes axes_of(const Pose& pose, Vec3 vertical = {0, 0, 1});

/// The rays of a camera whose picture has a given size.
///
/// Model: a thin lens (Kolb, Mitchell, Hanrahan 1995, section 2). All rays through a point of the picture meet in the
/// plane in focus, whatever point of the lens they leave.
class CameraRays {
 public:
  CameraRays(const Camera& camera, int width, int height);

  /// Returns a ray through a point of the picture in pixels, x to the right and y down from the top left corner. A
  /// moving camera takes one pair of random numbers from `draw`, for the time; a thin lens takes one pair, for the
  /// point on the lens; a pinhole at rest takes none.
  CameraRay through(double x, double y, PathDraw& draw) const;
  /// Returns the angle of a pixel in the middle of the picture, in radians.
  double pixel_rad() const { return 2 * half_height_ / height_; }

 private:
  Camera camera_;
  double width_, height_;
  double half_width_, half_height_;  // of the picture at distance 1
  ViewAxes axes_;
};

}  // namespace citykiln::preview
