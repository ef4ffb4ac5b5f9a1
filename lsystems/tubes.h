// Meshes a skeleton: stems as round tubes, with smooth joints where they branch.
//
//      |   | / /      joint: a box, a ring on each stem, quads between; its
//      |   |/ /       Catmull-Clark limit surface (joint_stencils.h)
//      o---o /
//      | [] o         tube: circles that share the joints' rings
//      o---o
//      |   |
#pragma once

#include <span>

#include "lsystems/plant_mesh.h"
#include "lsystems/skeleton.h"

namespace citykiln::lsystems {

/// The surface of an instance: x along left, y along heading, z along up, in units of Instance::size.
struct LeafSurface {
  std::vector<Vec3> positions;
  std::vector<Vec2> uvs;  ///< As many as positions.
  std::vector<Triangle> triangles;
};

struct TubeOptions {
  double tolerance_m = 0.02;  ///< ≥ 0; sides are at most kMostSides.
  double flare = 0.6;         ///< Widening of the trunk's foot in radii; 0: none.
  /// Indexed by Instance::kind. A kind without a surface is drawn as a kite of four corners.
  std::span<const LeafSurface> surfaces;
  bool instances = true;  ///< Whether instances are meshed.
  /// Period of the bark texture. u counts metres of the texture, with a whole number of periods around each stem, at
  /// least one, as many as fit its mean girth. 0: one period of 1, so that u counts turns. u begins at one period.
  double bark_m = 0;
};

inline constexpr int kMostSides = 64;

/// Meshes a skeleton.
///
/// The mesh approximates a surface that does not depend on the tolerance: between two circles the lines that join equal
/// angles, at joints the limit surface of a cage, flat discs at the ends. Stems with a diameter up to the tolerance
/// that carry nothing thicker, and leaves with an extent up to it, are left out. A joint has the arriving stem, the
/// continuing one and at most kMostSideStems others.
///
/// Guarantees: the bark is closed and oriented (each edge is used as often in one direction as in the other); error_m
/// bounds the distance to the surface, and is at most the tolerance except for sharp bends and where kMostSides are too
/// few; a coarser tolerance never has more triangles; the same bytes on every machine; everything is finite. Stems may
/// intersect each other. Total: lengths and radii of 0, coincident stems, turns of 180°; no segments give no triangles.
/// Cost: O(segments and corners); a concave polygon of c corners costs c³ at worst, beyond kMostClipped corners O(c).
PlantMesh mesh_plant(const Skeleton& skeleton, const TubeOptions& options = {});
/// The same, reusing the memory of `mesh`: mapping new pages costs as much as filling them.
void mesh_plant(const Skeleton& skeleton, const TubeOptions& options, PlantMesh& mesh);

inline constexpr std::size_t kMostClipped = 256;

}  // namespace citykiln::lsystems
