// The levels of detail of a grown plant, as meshes of a plant 1 m tall (levels.md). A card is a rectangle with a
// picture of leaves.
//
//     tolerance / height   … 0.28    stems as tubes, leaves as cards, merged within the tolerance (leaf_clusters.h)
//                     0.28 … 1       a hull of 12 triangles (crown_hull.h)
//                        1 …         nothing
//
// Plants of hedges have a box in place of the hull, from 0.12 on.
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/plants/prototypes/grown_plant_cache.h"
#include "compiler/plants/prototypes/leaf_atlas.h"

namespace citykiln::plants {

/// The least tolerances, as shares of the plant's height, at which a plant becomes a hull (kHullFrom) and a plant of a
/// hedge becomes a box (kBoxFrom).
inline constexpr double kHullFrom = 0.28, kBoxFrom = 0.12;

/// The mesh of a plant 1 m tall at one tolerance.
struct PrototypeMesh {
  /// The origin is at the foot of the trunk, z up; 1 m tall in summer. Empty: the plant is left out.
  std::vector<materials::MaterialMesh> meshes;
  bool shows_leaf_atlas = false;  ///< Some meshes have ColourSource::kByCutout.
  double error_per_m = 0;         ///< The error of a plant 1 m tall.
};

/// Returns the mesh of a plant that keeps the tolerance when scaled to `height_m`. Empty if nothing has grown, or if
/// the tolerance is at least the plant's height in the season; the error is then that height as a share of the summer's
/// (SeasonState::height_share): 0 if the season leaves no plant.
///
/// @param grown                  The plant's stems and leaves.
/// @param species                The species of the plant; decides between hull and box.
/// @param atlas                  The leaf pictures of the month for which the plant was grown.
/// @param height_m, tolerance_m  > 0.
///
/// Error: for stems and leaf cards error_per_m bounds the distance of the mesh from the plant and of the plant from the
/// mesh, except that stems with a radius below the tolerance
/// are left out regardless of their length. For hulls error_per_m is the bound of crown_hull.h. Cost: O(n log n), some
/// 10 ms.
PrototypeMesh prototype_mesh(const GrownPlant& grown, const LeafAtlas& atlas, Species species, double height_m,
                             double tolerance_m);

/// Returns the number of variants of a species, differently grown plants, that are used at a tolerance: few for fine
/// meshes, which are large, and for hulls, which look alike.
int variants_at(double tolerance_m);

}  // namespace citykiln::plants
