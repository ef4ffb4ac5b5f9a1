// Colours of light, and what shines: the sky as a table to draw directions from, the sun's disk, haze.
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
/// Rec. 709.
inline double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

/// A unit vector at an angle from `axis`, turned about it by `turn` of a full circle.
Vec3 around(Vec3 axis, double cos_angle, double turn);

/// A drawn direction: pdf per steradian.
struct DirectionSample {
  Vec3 direction;
  double pdf = 0;
};

/// Cosine-weighted about a unit vector.
DirectionSample sample_cosine(Vec3 normal, UnitPair chance);

/// What a ray sees that meets nothing, and where light comes from.
class Lights {
 public:
  explicit Lights(const sky::SkyModel& dome);

  const sky::SkyModel& dome() const { return dome_; }

  /// The sky for light that falls on surfaces, piecewise constant: 128 by 64 cells of equal solid angle. From below the
  /// horizon comes what darker ground throws back.
  const Rgb& falling(Vec3 direction) const;
  /// A direction of the sky, bright ones more often, from above the horizon only; pdf 0 if the sky is black.
  DirectionSample sample_sky(UnitPair chance) const;
  /// How often sample_sky draws this direction, per steradian.
  double sky_pdf(Vec3 direction) const;

  bool has_sun() const { return sun_solid_angle_ > 0; }
  /// A direction of the sun's disk, evenly.
  Vec3 sample_sun(UnitPair chance) const;
  double sun_solid_angle() const { return sun_solid_angle_; }

  /// The sky as the eye sees it. Below the horizon, beyond the ground's edge, there is haze: a dark or sharp edge would
  /// look like a wall.
  Rgb seen(Vec3 direction) const;
  /// Light seen through `distance_m` of air: some is lost, some of the horizon's is put in.
  Rgb through_air(const Rgb& light, Vec3 direction, double distance_m) const;

 private:
  Rgb haze(Vec3 direction) const;

  sky::SkyModel dome_;
  double sun_solid_angle_ = 0;
  std::vector<Rgb> cells_, ring_;
  Rgb below_{}, haze_mean_{};
  std::vector<double> row_sums_, sums_;  // running sums of luminance: of rows, and of cells within their row
};

}  // namespace citykiln::preview
