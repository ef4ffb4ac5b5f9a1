// How much of the light that falls on a rough surface its facets reflect, once or in several bounces between facets.
#pragma once

namespace citykiln::preview {

/// Light that facets of a width reflect once, for a reflectance at normal incidence f0 (Schlick 1994):
/// f0 * mirror + grazing.
struct SingleReflection {
  double mirror = 1, grazing = 0;

  double of(double f0) const { return f0 * mirror + grazing; }
  /// The same of facets that reflect everything.
  double of_white() const { return mirror + grazing; }
};

/// Single reflections for one width of facets, by the cosine of the direction towards the eye, in (0, 1]. A table,
/// interpolated; largest error 0.0005 where alpha is at least 0.01, which is also the least that is looked up.
class SingleReflections {
 public:
  explicit SingleReflections(double alpha);

  SingleReflection at(double cosine) const;
  /// For light from everywhere above.
  SingleReflection mean() const;

 private:
  int row_;
  double share_;  // of the next row
};

}  // namespace citykiln::preview
