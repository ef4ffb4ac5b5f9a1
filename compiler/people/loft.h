// Surfaces through rings of points, of which bodies are made.
#pragma once

#include <span>

#include "compiler/geometry/vec.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::people {

/// An ellipse: at + u · cos + v · sin. The cross product of u and v points along the loft.
struct Ring3 {
  Vec3 at, u, v;
};

/// Returns a horizontal ellipse whose normal is +z, for lofts that are listed from low to high.
inline Ring3 level_ring(Vec3 at, double half_width_m, double half_depth_m) {
  return {at, {half_width_m, 0, 0}, {0, half_depth_m, 0}};
}

/// A joint of a limb and its radius.
struct Joint {
  Vec3 at;
  double radius_m = 0;
};

/// Adds the closed surface through rings of `sides` points each, ends included, in one colour, with vertices of its
/// own: 2 · sides · rings − 4 triangles. Positions are multiples of 2^-10 m.
void add_loft(std::span<const Ring3> rings, int sides, materials::Tint tint, materials::MaterialMesh& mesh);

/// Adds a limb through joints, listed from its lower end. Each ring is square to the limb, and its u is as near to x as
/// possible, so no part of the limb may be parallel to x. Requires two joints or more.
/// @param flat  The depth of a ring as a share of its width.
void add_limb(std::span<const Joint> joints, int sides, double flat, materials::Tint tint,
              materials::MaterialMesh& mesh);

/// Sets the normal of each vertex to the mean of its triangles' normals, weighted by area.
void smooth(Mesh& mesh);

}  // namespace citykiln::people
