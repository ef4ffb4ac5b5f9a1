// The directional albedo of rough surfaces: the share of light that microfacets reflect, once or after several bounces
// between facets.
#pragma once

namespace citykiln::preview {

/// The share of light that facets of one width reflect once, for a reflectance at normal incidence f0 (Schlick 1994):
/// f0 * mirror + grazing.
struct SingleReflection {
  double mirror = 1, grazing = 0;

  double of(double f0) const { return f0 * mirror + grazing; }
  /// The share for facets that reflect everything (f0 = 1).
  double of_white() const { return mirror + grazing; }
};

/// Single reflections for one width of facets, by the cosine of the direction towards the eye, in (0, 1]. An
/// interpolated table; largest error 0.0005. A smaller alpha than 0.01 counts as 0.01.
class SingleReflections {
 public:
  explicit SingleReflections(double alpha);

  /// Returns the reflection for a direction towards the eye.
  /// @param cosine  The cosine of the angle between this direction and the normal, in (0, 1].
  SingleReflection at(double cosine) const;
  /// Returns the mean for even light from all directions above.
  SingleReflection mean() const;

 private:
  int row_;
  double share_;  // of the next row
};

}  // namespace citykiln::preview
