// A prototype's levels: what has grown, as meshes of a tree 1 m tall.
//
//     tolerance, of the height:   …0.04  stems as tubes, leaves as cards, near ones become one (leaf_clusters.h)
//                            0.04…0.28   crossed cards (crossed_cards.h)
//                                 0.28…  a body of 36 triangles (crown_hull.h)
//                                    1…  nothing
#pragma once

#include <vector>

#include "compiler/impostor/cutout.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/plants/prototypes/grown_plant_cache.h"

namespace citykiln::plants {

/// From where on, as shares of the height, a plant is crossed cards, and a body; a hedge is a box.
inline constexpr double kCardsFrom = 0.04, kBodyFrom = 0.28, kBoxFrom = 0.12;

struct PrototypeMesh {
  /// Origin at the foot of the trunk, z up, 1 m tall in summer (scale is the height in metres). Empty: dropped.
  std::vector<materials::MaterialMesh> meshes;
  impostor::Cutout cutout{};  ///< What those on cutouts show.
  double error_per_m = 0;     ///< Deviation for a plant 1 m tall.
};

/// A prototype, cut so that a plant of `height_m` is within the tolerance; dropped (with error 1) where the plant
/// itself is no higher than it; without error where the season leaves nothing.
///
/// Error: certified both ways for stems and cards of leaves: mesh_plant's and the clusters'; but stems of a radius
/// below the tolerance are left out, however long they are. Of crossed cards stated, of bodies bounded.
/// Cost: O(n log n), some 10 ms.
PrototypeMesh prototype_mesh(const GrownPlant& grown, Species species, double height_m, double tolerance_m);

/// Of a species' variants so many are told apart at a tolerance: fine ones are large, bodies alike.
int variants_at(double tolerance_m);

}  // namespace citykiln::plants
