// One material's triangles as Embree sees them, and what a hit on one means.
#pragma once

#include <embree3/rtcore.h>

#include <vector>

#include "compiler/bake/baked.h"
#include "preview/world.h"

namespace citykiln::preview {

/// Triangles, and their corners about another origin. Refers to the primitive.
struct MeshPart {
  const bake::Primitive* primitive = nullptr;
  std::vector<bake::Float3> corners;  ///< One a position, and one more: Embree reads 16 bytes at each.
};

/// The primitive's positions plus `offset`, rounded once.
MeshPart moved(const bake::Primitive& primitive, Vec3 offset);

/// Adds a part to an uncommitted scene; its id is the number of parts before it. The part must outlive the scene.
void attach(RTCDevice device, RTCScene scene, const MeshPart& part);

/// A hit in the part's own frame; normals not turned towards the ray, distance not set. `rounding_m` covers what the
/// triangle adds: Embree's plane of it lies at most so far from the exact one.
Hit hit_on(const MeshPart& part, const RTCHit& found);

}  // namespace citykiln::preview
