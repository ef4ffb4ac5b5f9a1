// Light sources: the sky as a table of directions to sample, the sun's disk, and haze.
#pragma once

#include <array>
#include <vector>

#include "compiler/sky/generate.h"
#include "preview/samples.h"

namespace citykiln::preview {

using sky::Rgb;

inline Rgb operator*(const Rgb& a, const Rgb& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
inline Rgb operator*(const Rgb& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline Rgb operator+(const Rgb& a, const Rgb& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
/// Luminance of linear Rec. 709.
inline double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

/// A unit vector at an angle from `axis`, turned about it by `turn` of a full circle.
Vec3 around(Vec3 axis, double cos_angle, double turn);

/// A sampled direction and its probability density per steradian.
struct DirectionSample {
  Vec3 direction;
  double pdf = 0;
};

/// A cosine-weighted sample about a unit vector.
DirectionSample sample_cosine(Vec3 normal, UnitPair chance);

/// The sources of light, and what rays see that hit nothing.
class Lights {
 public:
  explicit Lights(const sky::SkyModel& model);

  const sky::SkyModel& model() const { return model_; }

  /// Sky radiance for lighting surfaces, piecewise constant on 128 by 64 cells of equal solid angle. From below the
  /// horizon comes what dark ground reflects.
  const Rgb& falling(Vec3 direction) const;
  /// A sample of the sky above the horizon, in proportion to luminance; pdf 0 if the sky is black.
  DirectionSample sample_sky(UnitPair chance) const;
  /// The density of sample_sky() in a direction, per steradian.
  double sky_pdf(Vec3 direction) const;

  bool has_sun() const { return sun_solid_angle_ > 0; }
  /// A uniform sample of the sun's disk.
  Vec3 sample_sun(UnitPair chance) const;
  double sun_solid_angle() const { return sun_solid_angle_; }

  /// The sky as the eye sees it. Below the horizon, beyond the edge of the ground, it is haze, since a dark or sharp
  /// edge would look like a wall.
  Rgb seen(Vec3 direction) const;
  /// Light after `distance_m` of air: attenuated, with scattered light of the horizon's colour added.
  Rgb through_air(const Rgb& light, Vec3 direction, double distance_m) const;

 private:
  Rgb haze(Vec3 direction) const;

  sky::SkyModel model_;
  double sun_solid_angle_ = 0;
  std::vector<Rgb> cells_, ring_;
  Rgb below_{}, haze_mean_{};
  std::vector<double> row_sums_, sums_;  // cumulative luminance: of rows, and of cells within their row
};

}  // namespace citykiln::preview
