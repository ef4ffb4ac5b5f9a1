// From string to shape: a skeleton becomes round tubes, and where stems part, smooth joints.
//
//      |   | / /      joint: a box, a ring on each stem, quads between; its
//      |   |/ /       Catmull-Clark limit surface (joint_shape.h)
//      o---o /
//      | [] o         tube: circles, welded to the joints' rings
//      o---o
//      |   |
#pragma once

#include <span>

#include "lsystems/plant_mesh.h"
#include "lsystems/skeleton.h"

namespace citykiln::lsystems {

/// What stands where ~ names it; x along left, y along heading, z along up, in sizes of the instance.
struct LeafSurface {
  std::vector<Vec3> positions;
  std::vector<Vec2> uvs;  ///< As many.
  std::vector<Triangle> triangles;
};

struct TubeOptions {
  double tolerance_m = 0.02;  ///< ≥ 0; sides and levels end at kMostSides.
  double flare = 0.6;         ///< How much wider than the trunk its foot is, in radii; 0 for a straight one.
  /// By Instance::kind; kinds beyond its end, and empty surfaces, become cards: a kite of four corners.
  std::span<const LeafSurface> surfaces;
  bool instances = true;  ///< Else they are left to who places prototypes.
  /// The side of the picture of the bark, which repeats: u then counts metres on it, a whole number of pictures around
  /// each stem, as many as fit its mean girth; at least one. 0: one of a side of 1, so that u counts turns. From 1 on.
  double bark_m = 0;
};

inline constexpr int kMostSides = 64;

/// The surface that it stands for, whatever the tolerance: between two circles the lines that join equal angles; at
/// joints the limit surface of a cage that depends on the skeleton alone; flat discs at the ends.
///
/// Stems whose diameter is at most the tolerance go with all that they bear, if that is no thicker; leaves, if their
/// extent is no larger. A joint takes the stem it grows from, the one that goes on, and at most four others.
///
/// Guarantees: the bark is closed and oriented (each edge is passed as often one way as the other); error_m bounds the
/// distance to the surface above, and is at most the tolerance but for more sides than kMostSides and sharp bends;
/// triangles do not grow with the tolerance; the same bytes on every machine; everything is finite. Not promised: that
/// stems do not pass through each other. Total: lengths and radii of 0, coincident stems, turns of 180°; no segments
/// give no triangles. O(n), n = segments and corners; polygons of c corners, not convex, cost c³ at worst, and beyond
/// kMostClipped corners are fans.
PlantMesh mesh_plant(const Skeleton& skeleton, const TubeOptions& options = {});
/// The same into what held another plant, whose memory is used again: new pages cost as much as the triangles on them.
void mesh_plant(const Skeleton& skeleton, const TubeOptions& options, PlantMesh& mesh);

inline constexpr std::size_t kMostClipped = 256;

}  // namespace citykiln::lsystems
