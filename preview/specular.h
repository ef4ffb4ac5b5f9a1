// Smooth surfaces: water and glass send part of the light on as a mirror does, blurred by their roughness.
#pragma once

#include "preview/light.h"
#include "preview/world.h"

namespace citykiln::preview {

/// Smoother than 0.3: seen as a mirror as well.
bool is_smooth(const Hit& hit);

/// A mirror of small facets (GGX: Walter et al., "Microfacet Models for Refraction", EGSR 2007) about a normal.
struct SpecularLobe {
  Vec3 normal, to_eye, outside;  ///< Unit; `outside` is the true surface's normal, below which nothing is sent.
  double alpha = 0;              ///< Width of the facets' slopes.
  double f0 = 0;                 ///< Mirrored at normal incidence.
  double fresnel = 0;            ///< Mirrored at this angle (Schlick 1994): what the body does not get.

  /// A direction that light comes from.
  Vec3 draw(UnitPair chance) const;
  /// What share of the light from a drawn direction reaches the eye.
  double share(Vec3 drawn) const;
  /// Radiance sent to the eye for radiance from a direction, per steradian of it.
  double glint(Vec3 from) const;
};

/// @param place  The hit in the plane: waves stay where they are. @param pixel_rad  What a pixel covers: waves finer
/// than that blur the mirror instead of turning it.
SpecularLobe specular_lobe_of(const Hit& hit, Vec3 direction, Vec2 place, double pixel_rad);

}  // namespace citykiln::preview
