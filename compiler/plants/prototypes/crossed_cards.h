// A plant from afar: a few upright planes through its trunk and level ones through its crown, each with the picture of
// what lies near it.
//
//       \ | /          from above: n planes, all of the plant within R sin(90°/n) of one
//     ---\|/---
//       / | \.
#pragma once

#include <vector>

#include "compiler/impostor/cutout.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::plants {

struct CrossedCards {
  materials::MaterialMesh mesh;  ///< On the cutout.
  impostor::Cutout cutout;
  double error_m = 0;
};

/// @param shape  The plant, leaves as polygons of their true area, both sides.
/// @param tolerance_m  A picture shows what lies three quarters of it before and behind, or as far as planes need to
/// show all.
///
/// Error: any place of the shape is within R sin(90°/n) of an upright plane; n is what the tolerance asks for, up to
/// kMostPlanes. Of a picture every place is as near to the shape as its depth. A texel, a quarter of the tolerance, is
/// added, since pictures are there or not texel by texel: stated, not proved, as single leaves may be lost.
CrossedCards crossed_cards(const std::vector<materials::MaterialMesh>& shape, double tolerance_m);

inline constexpr int kMostPlanes = 8, kMostLevels = 3;

}  // namespace citykiln::plants
