// The scattering of light by surfaces (BSDF): glTF's metals and coated matt surfaces, water, panes of glass, and
// leaves. A lobe is a part of the scattering from which directions are sampled: the microfacets of the coat, or the
// matt body below it.
#pragma once

#include "preview/rgb.h"
#include "preview/samples.h"
#include "preview/surface/microfacet.h"
#include "preview/surface/reflected_energy.h"
#include "preview/surface/surface_point.h"

namespace citykiln::preview {

/// A sampled direction from which light comes.
struct BsdfSample {
  Vec3 direction;
  Rgb weight{};    ///< Radiance towards the eye per radiance from the direction, divided by the density; 0: no light.
  double pdf = 0;  ///< Density per steradian.
  double lobe_rad = 1;  ///< Angle of the cone of directions that the ray stands for.
};

/// Light that is scattered towards the eye.
struct Scattering {
  Rgb light{};     ///< BSDF times cosine: radiance towards the eye per radiance from a direction, per steradian.
  double pdf = 0;  ///< Density, per steradian, with which the direction is sampled.
};

/// The scattering of light at a point of a surface. Energy is conserved: a white surface under even light is as bright
/// as the light (tested to 0.1 %, half rough coats 0.2 %, metals 1 %). Scattering is reciprocal, but for water whose
/// waves hide each other.
///
/// Method: one lobe of microfacets, with the light of several bounces between facets added (Kulla, Conty, "Revisiting
/// Physically Based Shading at Imageworks", SIGGRAPH 2017 course), over a matt body, which gets the light that the
/// facets let pass both ways (Ashikhmin, Shirley 2000). Leaves are matt on both sides.
class Bsdf {
 public:
  /// @param to_eye  Unit, on the side of the surface's normals.
  /// @param least_alpha  The least width of microfacets; narrower ones are widened to it.
  Bsdf(const SurfacePoint& surface, Vec3 to_eye, double least_alpha);

  /// Returns the scattering towards the eye of light from a direction.
  Scattering scattering(Vec3 from) const;
  /// Returns the BSDF times cosine of the body alone, without the light that facets reflect once.
  Rgb matt(Vec3 from) const { return of_body(dot(outside_, from), dot(frame_.z, from)); }
  /// Declares that the caller samples both lobes, one direction each, instead of one of them. The density is then the
  /// sum over both lobes.
  void split();
  bool is_split() const { return facets_share_ + body_share_ > 1.5; }
  /// Samples one of the lobes.
  /// @param lobe  A uniform random number in [0, 1), which chooses the lobe.
  BsdfSample sample(double lobe, UnitPair chance) const;
  BsdfSample sample_facets(UnitPair chance) const;
  /// Samples the matt body.
  /// @param side  A uniform random number in [0, 1), which chooses the side of a leaf.
  BsdfSample sample_body(double side, UnitPair chance) const;

  /// True if light passes to the other side, as in leaves.
  bool is_two_sided() const { return through_ > 0; }
  /// Returns the width of the microfacets; 1 for leaves.
  double alpha() const { return facets_.alpha; }
  /// Returns the radiance that facets reflect towards the eye under even light of 1.
  const Rgb& facets_energy() const { return energy_; }

 private:
  BsdfSample weighed(Vec3 direction, double lobe_rad) const;
  Rgb of_body(double flat, double cosine) const;
  void add_facets(Vec3 from, Scattering& to) const;
  Rgb energy_at(const SingleReflection& once) const;

  Vec3 outside_;  // geometric normal
  Frame frame_;   // about the shading normal
  Vec3 eye_;      // in the frame
  Rgb body_{};    // reflectance of the body times the share that the facets let pass towards the eye
  double through_ = 0;
  bool has_facets_;
  Microfacets facets_{1};
  SingleReflections reflections_{1};
  Rgb f0_{}, several_{};  // reflectance at normal incidence; light of several bounces
  double once_ = 1, once_mean_ = 1, seen_ = 1;
  Rgb energy_{}, mean_energy_{};
  double facets_share_ = 0, body_share_ = 1;  // probabilities of the lobes; 1 and 1 where both are sampled
};

}  // namespace citykiln::preview
