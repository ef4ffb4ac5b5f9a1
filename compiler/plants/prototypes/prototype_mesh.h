// Levels of detail of a grown plant, as meshes of a plant 1 m tall (levels.md).
//
//     tolerance / height   … 0.28    stems as tubes, leaves as cards, merged within the tolerance (leaf_clusters.h)
//                     0.28 … 1       a hull of 12 triangles (crown_hull.h)
//                        1 …         nothing
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/plants/prototypes/grown_plant_cache.h"
#include "compiler/plants/prototypes/leaf_atlas.h"

namespace citykiln::plants {

/// Least tolerances, as shares of the height, of the hull and of a hedge's box.
inline constexpr double kHullFrom = 0.28, kBoxFrom = 0.12;

struct PrototypeMesh {
  /// Origin at the foot of the trunk, z up, 1 m tall in summer. Empty: dropped.
  std::vector<materials::MaterialMesh> meshes;
  bool shows_leaf_atlas = false;  ///< Whether meshes with ColourSource::kByCutout are there.
  double error_per_m = 0;         ///< Of a plant 1 m tall.
};

/// The mesh of a plant that keeps the tolerance when scaled to `height_m`. Empty with error 1 where the tolerance is at
/// least the height; empty without error where the season leaves no plant.
///
/// @param atlas  Of the month in which the plant was grown.
/// @param height_m, tolerance_m  > 0.
///
/// Error: certified in both directions for stems and leaf cards, except that stems of a radius below the tolerance are
/// left out whatever their length; bounded for hulls. Cost: O(n log n), some 10 ms.
PrototypeMesh prototype_mesh(const GrownPlant& grown, const LeafAtlas& atlas, Species species, double height_m,
                             double tolerance_m);

/// Number of variants of a species used at a tolerance: fine meshes are large, and hulls look alike.
int variants_at(double tolerance_m);

}  // namespace citykiln::plants
