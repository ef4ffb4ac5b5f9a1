// The GGX distribution of microfacets, in a frame whose z axis is the surface's normal.
#pragma once

#include "compiler/geometry/vec.h"
#include "preview/samples.h"

namespace citykiln::preview {

/// Right-handed orthonormal axes of a surface; z is its normal.
struct Frame {
  Vec3 x, y, z;

  /// Converts a direction to the frame; out_of() converts it back.
  Vec3 into(Vec3 v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  Vec3 out_of(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
};

/// Returns axes about a unit normal. Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
Frame frame_about(Vec3 normal);

/// Isotropic microfacets of width `alpha`, which is the square of glTF's roughness, with Smith's height-correlated
/// masking and shadowing. Directions are unit vectors with z > 0.
///
/// Source: Walter et al., "Microfacet Models for Refraction", EGSR 2007; Heitz, "Understanding the Masking-Shadowing
/// Function", JCGT 3(2), 2014.
struct Microfacets {
  double alpha = 1;  ///< > 0.

  /// Returns the density of facet normals, per steradian (D).
  double density(Vec3 facet) const;
  /// Returns the share of facets that are visible from a direction (G1).
  double seen(Vec3 from) const;
  /// Returns the share of facets that are visible from both directions (G2).
  double seen(Vec3 from, Vec3 other) const;
  /// Returns a sample of the normals of facets that are visible from a direction (Heitz, "Sampling the GGX Distribution
  /// of Visible Normals", JCGT 7(4), 2018).
  Vec3 sample(Vec3 from, UnitPair chance) const;
  /// Returns the density of sample(), per steradian.
  double pdf(Vec3 facet, Vec3 from) const;

 private:
  double lambda(Vec3 from) const;
};

/// Returns `v` mirrored at a plane with a unit normal. Both point away from the plane.
inline Vec3 mirrored(Vec3 v, Vec3 normal) { return normal * (2 * dot(v, normal)) - v; }

}  // namespace citykiln::preview
