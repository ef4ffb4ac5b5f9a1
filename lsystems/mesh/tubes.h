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

#include "lsystems/mesh/plant_mesh.h"
#include "lsystems/rewriting/skeleton.h"

namespace citykiln::lsystems {

/// The surface of an instance. x is along left, y along heading, z along up, in units of Instance::size.
struct LeafSurface {
  std::vector<Vec3> positions;
  std::vector<Vec2> uvs;  ///< One for each position.
  std::vector<Triangle> triangles;
};

/// The settings of mesh_plant().
struct TubeOptions {
  double tolerance_m = 0.02;  ///< ≥ 0; sides are at most kMostSides.
  double flare = 0.6;         ///< The widening of the trunk's foot, in radii; 0: none.
  /// The surface of each Instance::kind. A kind without a surface gets a kite of four corners.
  std::span<const LeafSurface> surfaces;
  bool instances = true;  ///< Instances are meshed.
  /// The period of the bark texture. u counts metres of the texture. A whole number of periods is around each stem, as
  /// many as fit its mean girth and at least one. 0: one period of 1, so u counts turns. u begins at one period.
  double bark_m = 0;
};

inline constexpr int kMostSides = 64;

/// Meshes a skeleton.
///
/// The mesh approximates a surface that does not depend on the tolerance: the lines that join equal angles of two
/// circles, the limit surface of a cage at joints, and flat discs at ends. Leaves no larger than the tolerance are left
/// out, and so are stems no thicker than the tolerance with all their branches, unless a branch is thicker. A joint has
/// the arriving stem, the continuing stem and at most kMostSideStems side stems.
///
/// Guarantees: the bark is closed and oriented (each edge is used as often in one direction as in the other); error_m
/// bounds the distance to the surface, and is at most the tolerance except at sharp bends and if kMostSides are too
/// few; a coarser tolerance never gives more triangles; deterministic on every machine; all numbers are finite. Stems
/// may intersect each other. Accepts any skeleton: lengths and radii of 0, coincident stems, turns of 180°, no
/// segments. Cost: O(segments and corners); a concave polygon of c corners costs c³ at worst, beyond kMostClipped
/// corners O(c).
PlantMesh mesh_plant(const Skeleton& skeleton, const TubeOptions& options = {});
/// Meshes a skeleton into `mesh`, whose memory is reused.
void mesh_plant(const Skeleton& skeleton, const TubeOptions& options, PlantMesh& mesh);

inline constexpr std::size_t kMostClipped = 256;

}  // namespace citykiln::lsystems
