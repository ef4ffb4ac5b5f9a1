// Specular reflection of water and glass, blurred by their roughness.
#pragma once

#include "preview/light/light.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// Whether a surface reflects specularly: its roughness is below 0.3.
bool is_smooth(const Hit& hit);

/// A lobe of microfacets (GGX: Walter et al., "Microfacet Models for Refraction", EGSR 2007) about a normal.
struct SpecularLobe {
  Vec3 normal, to_eye, outside;  ///< Unit; `outside` is the geometric normal, below which nothing is reflected.
  double alpha = 0;              ///< GGX width.
  double f0 = 0;                 ///< Reflectance at normal incidence.
  double fresnel = 0;            ///< Reflectance at this angle (Schlick 1994); the diffuse body gets the rest.

  /// Samples a direction from which light comes.
  Vec3 draw(UnitPair chance) const;
  /// The share of the light from a sampled direction that reaches the eye.
  double share(Vec3 drawn) const;
  /// Radiance towards the eye per radiance from a direction, per steradian.
  double glint(Vec3 from) const;
};

/// The lobe of a hit.
/// @param place  The hit in the plane, since waves are a function of it.
/// @param pixel_rad  Angle of a pixel: waves shorter than that widen the lobe instead of turning its normal.
SpecularLobe specular_lobe_of(const Hit& hit, Vec3 direction, Vec2 place, double pixel_rad);

}  // namespace citykiln::preview
